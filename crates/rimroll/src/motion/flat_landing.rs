//! What follows where the whole base comes down flat at once, which rigid-body mechanics does not determine.

use super::instant::LEVEL_PHASES;
use super::level_base::UPLIFT_TILT;
use crate::error::{InvalidInput, bounded};
use crate::ground::random_bits;
use crate::law::Parameters;
use crate::real::{Real, Scalar};
use crate::state::Coordinates;
use core::f64::consts::PI;

/// The motion after the whole base has come down flat at once: in a plane, or because a resistance has stopped the contact
/// point on the rim. A base that has stopped like that comes to rest if the resistance would hold the contact point even at
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
    /// body goes on to rock about that point. A rim that rolls does not slip in the collision either, so that
    /// φ̇ falls by the factor (A + mH² − mR²)/(A + mH² + mR²); a rim that slides suffers no impulse of friction, and
    /// the factor is (A − mR²)/(A + mR²).
    Housner,
    /// φ̇ falls by this factor, from 0 to 1, and the body goes on to rock about the opposite point of the rim.
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

/// The body that begins to rock about the opposite point of the rim, with φ̇ multiplied by a factor. A rim that slides
/// keeps the horizontal `velocity` (m/s, along e_x1 and e_y1) of the centre of mass, and its axial spin.
pub(super) fn rocked_over<T: Scalar>(
    k: &Parameters<T>,
    at: &Coordinates<T>,
    factor: T,
    velocity: Option<[T; 2]>,
) -> Coordinates<T> {
    let zero = T::from(0.0);
    let half_turn = T::from(if at.w.value() < 0.0 { -PI } else { PI });
    let u = Coordinates {
        yaw: at.yaw + half_turn,
        spin: at.spin - half_turn,
        sin: T::from(UPLIFT_TILT),
        cos: T::from(1.0),
        p: factor * at.p.abs(),
        w: zero,
        s: if velocity.is_some() { at.s } else { zero },
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
