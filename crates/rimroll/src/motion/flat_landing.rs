//! What follows where the whole base comes down flat at once, which rigid-body mechanics does not determine.

use super::instant::LEVEL_PHASES;
use super::level_base::UPLIFT_TILT;
use crate::body::Body;
use crate::error::{InvalidInput, bounded};
use crate::ground::random_bits;
use crate::law::{Dynamics, DynamicsExt, FrictionLaw, Parameters};
use crate::number_format::formatted;
use crate::real::{Real, Scalar};
use crate::state::Coordinates;
use core::f64::consts::PI;

/// The motion after the whole base has come down flat at once: in a plane, or because a resistance has stopped the contact
/// point on the rim, or below a gap ([`Options::flat_gap`](crate::Options::flat_gap)). A base that has stopped like that comes to rest if the resistance would hold the contact point even at
/// the tilt from which the base fell: under [`Smooth`](Self::Smooth), and on a table that moves also under
/// [`Stop`](Self::Stop).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum FlatLanding {
    /// The motion ends.
    #[default]
    Stop,
    /// The limit of a near-collision: the contact point runs round the rim by the limiting turn, and no energy is
    /// lost to the side or to resistances. The side to which it runs is not determined by the motion.
    Smooth(Side),
    /// A plastic collision with the opposite point of the rim (G. W. Housner, Bull. Seismol. Soc. Am. 53, 1963). The
    /// body goes on to rock about that point. A rim that rolls does not slip in the collision either, so that the angular
    /// momentum about that point stays the same: φ̇ falls by the factor (A + mH² − mR²)/(A + mH² + mR²), and the spin s
    /// about the axis changes by (C − mR²)/(C + mR²). A rim that slides suffers no impulse of friction: it keeps s, and the
    /// factor of φ̇ is (A − mR²)/(A + mR²).
    Housner,
    /// φ̇ falls by this factor, from 0 to 1, and the body goes on to rock about the opposite point of the rim, with the spin
    /// after a plastic collision.
    Restitution(f64),
}

/// The side to which the contact point runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The yaw increases.
    Left,
    /// The yaw decreases.
    Right,
    /// Drawn for each landing from the random numbers of this seed.
    Drawn(u64),
}

impl FlatLanding {
    /// Refuses a factor that is out of bounds and, without the crate's feature `ground`, all but [`Self::Stop`].
    pub(super) fn check(&self) -> Result<(), InvalidInput> {
        if !LEVEL_PHASES && *self != FlatLanding::Stop {
            return Err(InvalidInput::UnknownName {
                what: "flat landing",
                name: format!("{self:?}"),
                choices: "Stop".to_owned(),
            });
        }
        if let FlatLanding::Restitution(factor) = *self {
            let unit = |factor: f64| (0.0..=1.0).contains(&factor);
            bounded("flat restitution", factor, unit, "between 0 and 1", "")?;
        }
        Ok(())
    }
}

/// Refuses a gap (m) under a base that comes down flat unless it is small and, without the crate's feature `ground`,
/// unless it is 0.
///
/// The tilt at which the base comes down flat has to be small, and far below the balance tilt: a tenth of the radius, or a
/// quarter of the balance tilt of a slender body.
pub(super) fn check_gap(gap: f64, body: &Body) -> Result<(), InvalidInput> {
    let (r, h) = (body.radius(), body.height());
    let (tenth, of_balance) = (0.1 * r, 0.5 * r * r / libm::hypot(r, h));
    let (largest, reason) = match LEVEL_PHASES {
        false => (0.0, ""),
        true if tenth <= of_balance => (tenth, ", a tenth of the radius"),
        true => (
            of_balance,
            ", at which the base comes down from a quarter of the balance tilt",
        ),
    };
    if (0.0..=largest).contains(&gap) {
        return Ok(());
    }
    let bound = format!("between 0 and {}{reason}", formatted(largest));
    bounded("flat_gap", gap, |_| false, &bound, "m").map(drop)
}

impl Side {
    /// The sign of the yaw's change in the landing number `landing`.
    pub(super) fn sign(self, landing: u64) -> f64 {
        match self {
            Side::Left => 1.0,
            Side::Right => -1.0,
            Side::Drawn(seed) => {
                if random_bits(seed, landing) & 1 == 0 {
                    1.0
                } else {
                    -1.0
                }
            }
        }
    }
}

/// The factor of φ̇ in a plastic collision of a rim that rolls or slides.
pub(super) fn plastic_factor<T: Real>(k: &Parameters<T>, rolls: bool) -> T {
    let (upright, rim) = (k.a + k.m * k.h * k.h, k.m * k.r * k.r);
    let factor = if rolls {
        (upright - rim) / (upright + rim)
    } else {
        (k.a - rim) / (k.a + rim)
    };
    // A body that is wide enough stays on the table.
    factor.max(T::from(0.0))
}

/// Describes a disk whose other face comes down with the opposite direction of its axis, so that this face is the first
/// one. Other bodies stay as they are.
pub(super) fn on_first_face<T: Scalar>(u: &Coordinates<T>) -> Coordinates<T> {
    if u.cos.value() < 0.0 {
        turned_over(u, PI)
    } else {
        *u
    }
}

/// The motion of a body on its first face, with the face down that is down in `at`.
pub(super) fn on_face_of<T: Scalar>(at: &Coordinates<T>, u: &Coordinates<T>) -> Coordinates<T> {
    if at.cos.value() < 0.0 {
        turned_over(u, -PI)
    } else {
        *u
    }
}

/// The motion of a disk described with the opposite direction of its axis, which changes the yaw by half a turn.
fn turned_over<T: Real>(u: &Coordinates<T>, half_turn: f64) -> Coordinates<T> {
    Coordinates {
        yaw: u.yaw + T::from(half_turn),
        spin: -u.spin,
        cos: -u.cos,
        p: -u.p,
        s: -u.s,
        x1: -u.x1,
        y1: -u.y1,
        slip_x: -u.slip_x,
        slip_y: -u.slip_y,
        ..*u
    }
}

/// The body at the end of a fall over the gap below a small tilt, which takes no time and costs no energy. A moving
/// table works on the body: it falls under gravity and the inertial force.
///
/// The tilt as a vector (φ cos ψ, φ sin ψ) has the velocity (φ̇, w) along e_x1 and e_y1. The base comes down in this
/// direction, so that the contact point is then where the direction points to. As in the limit of a near-collision, the
/// spin s about the axis stays the same; a body that wobbles in place does not turn. A rim that rolls keeps its
/// footprint, and one that slides the place and the horizontal velocity of its centre of mass. Of w only the sign
/// remains, as that of the least number.
///
/// Kinetic energy of a rim that rolls has the term −mHR w s, which goes with w. Where that and
/// the work leave less than nothing for φ̇, the tilt rate is zero, and s is reduced.
pub(super) fn fallen<T: Scalar>(
    dynamics: &dyn Dynamics<T>,
    friction: &FrictionLaw,
    rolls: bool,
    at: &Coordinates<T>,
) -> Coordinates<T> {
    let k = dynamics.parameters();
    let (zero, least) = (T::from(0.0), T::from(f64::MIN_POSITIVE));
    // A body that falls back from below the gap begins its fall at rest.
    let change = (-at.w).atan2((-at.p).max(least));
    let (sin, cos) = change.sin_cos();
    let turned = |[x, y]: [T; 2]| [x * cos + y * sin, y * cos - x * sin];
    let toward_axis = if rolls { k.r - k.rho(at) } else { zero };
    let [x1, y1] = turned([at.x1 + toward_axis, at.y1]);
    let [vx, vy] = turned(dynamics.center_velocity(at));
    let rim = k.m * k.r * k.r;
    let s = match friction {
        FrictionLaw::InPlace => zero,
        _ => at.s,
    };
    let height = if rolls { k.h } else { zero };
    let w = if at.w.value() == 0.0 {
        at.w
    } else {
        at.w.where_negative(-least, least)
    };
    let flat = Coordinates {
        yaw: at.yaw + change,
        spin: at.spin - change,
        sin: T::from(UPLIFT_TILT),
        cos: T::from(1.0),
        p: zero,
        w,
        s,
        x1,
        y1,
        ..*at
    };
    let moving = |u: Coordinates<T>| {
        let [rolling_x, rolling_y] = k.rolling_velocity(&u);
        Coordinates {
            slip_x: if rolls { zero } else { vx - rolling_x },
            slip_y: if rolls { zero } else { vy - rolling_y },
            ..u
        }
    };
    let work = work_in_fall(dynamics, rolls, at);
    let flat = Coordinates {
        ground_work: at.ground_work + work,
        ..flat
    };
    let energy = dynamics.energy(at).total() - dynamics.energy(&moving(flat)).total() + work;
    if energy.value() < 0.0 {
        let square = s * s + T::from(2.0) * energy / (k.c + if rolls { rim } else { zero });
        let slower = square.max(zero).sqrt();
        let s = if at.s.value() < 0.0 { -slower } else { slower };
        return moving(Coordinates { s, ..flat });
    }
    let inertia = k.a + rim + k.m * height * height;
    let p = -(T::from(2.0) * energy / inertia).sqrt();
    moving(Coordinates { p, ..flat })
}

/// The work of a moving table, J, on a body that falls over the gap from a small tilt: the inertial force times the way of
/// the centre of mass.
pub(super) fn work_in_fall<T: Real>(
    dynamics: &dyn Dynamics<T>,
    rolls: bool,
    at: &Coordinates<T>,
) -> T {
    let k = dynamics.parameters();
    let [along, _, vertical] = dynamics.table_acceleration(at);
    let away_from_rim = if rolls { k.r - k.rho(at) } else { T::from(0.0) };
    k.m * (vertical * (k.z(at) - k.h) - along * away_from_rim)
}

/// The body that begins to rock about the opposite point of the rim, with φ̇ multiplied by a factor.
///
/// The impulse of the table acts at the new contact point alone. Where the rim rolls, this point does not slip, and the
/// angular momentum about the vertical through it stays the same, which changes the spin s by the factor
/// (C − mR²)/(C + mR²): the centre of mass, which moved at Rs, now goes round the other point. A rim that slides keeps s and
/// the horizontal `velocity` (m/s, along e_x1 and e_y1) of the centre of mass.
pub(super) fn rocked_over<T: Scalar>(
    k: &Parameters<T>,
    at: &Coordinates<T>,
    factor: T,
    velocity: Option<[T; 2]>,
) -> Coordinates<T> {
    let zero = T::from(0.0);
    let half_turn = T::from(if at.w.value() < 0.0 { -PI } else { PI });
    let rim = k.m * k.r * k.r;
    let spin_factor = (k.c - rim) / (k.c + rim);
    let u = Coordinates {
        yaw: at.yaw + half_turn,
        spin: at.spin - half_turn,
        sin: T::from(UPLIFT_TILT),
        cos: T::from(1.0),
        p: factor * at.p.abs(),
        w: zero,
        s: if velocity.is_some() {
            at.s
        } else {
            spin_factor * at.s
        },
        x1: -at.x1,
        y1: -at.y1,
        slip_x: zero,
        slip_y: zero,
        ..*at
    };
    let Some([vx, vy]) = velocity else {
        return u;
    };
    let [rolling_x, rolling_y] = k.rolling_velocity(&u);
    Coordinates {
        slip_x: -vx - rolling_x,
        slip_y: -vy - rolling_y,
        ..u
    }
}
