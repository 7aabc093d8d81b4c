//! The theory that the paper rejects: a rim, or a table, with an imperfection.
//!
//! Source: Srinivasan & Ruina (2007), section "Candidate theories for symmetry breaking": "Geometric
//! perturbations to the circular rim can similarly lead to two-point collisions ... We could then
//! compute the consequences of, say, a plastic collision at the new point of contact." The paper stops
//! there; this is the computation. (All points slapping the table at once, the other theory that it
//! rejects, no rigid-body law decides.)
//!
//! # What is assumed
//! The body tips about the point A of its rim, exactly toward face down, at the rate ω. One point B of
//! the rim (or of the table under it), at the angle β round the rim from A, stands out by a height
//! δ ≪ R; the rest of the rim is perfect. B meets the table before the base is flat. Every collision is
//! plastic: the point that strikes comes to rest, at once and without rebound, and the table pushes but
//! never pulls. The outcome is the limit δ → 0, in which neither δ nor gravity matters.
//!
//! # The mechanics
//! So close to face down the lean is a vector q in the plane (length: the tilt; direction: the point
//! that leans lowest), and the base's centre is at the height z. The spin about the axis stays zero, in
//! collisions too; the centre of mass moves sideways with H q̇ without slip and not at all without
//! friction. Either way
//!
//! ```text
//! 2T = K′ |q̇|² + m ż²        K′ = A + mH² without slip, A without friction
//! z ≥ R |q|                   the rim: a cone
//! z ≥ δ + R q·e_B             the imperfection: a plane that cuts off the cone's tip
//! ```
//!
//! a particle in a convex valley. Rolling on the rim it runs along geodesics of the cone (unrolled, they
//! are straight: hence the paper's π √(J′/K′) with J′ = K′ + mR²); an impulse N at the rim point e
//! changes q̇ by −(R/K′) N e and ż by N/m. A plastic collision leaves the velocity nearest to the one
//! before that does not enter the table (Moreau). Without slip the impulse asks for friction
//! mHR/(A + mH²) times its upward part, just as rolling through the near-collision does.
//!
//! 1. **B strikes.** If K′ + mR² cos β ≥ 0, A lifts off and ω e_A turns into
//!    q̇ = −ω [e_A + (mR²/J′)(1 − cos β) e_B]; this loses the part mR² K′ (1 − cos β)²/J′² of the energy.
//!    Else A and B hold, and the body turns about the chord between them.
//! 2. **The rim strikes again.** The body rotates about B alone until a rim point C comes down, at the
//!    angle χ from B with cot(χ/2) = (K′ − mR²)/J′ tan(β/2).
//! 3. **It rolls off.** For K′ ≥ mR² (all but flat bodies) B lifts off, and the rim rolls on from C without
//!    touching B again. With c, s = cos, sin of β/2, D = K′ − mR²:
//!
//! ```text
//! turn = β + 2 arccot(D s/(J′ c)) − √(J′/K′) arctan[4 mR² J′² s c³ / (√(J′/K′) D (J′² − 4 K′ mR² s⁴))]
//! ```
//!
//! For K′ < mR² the body rocks over the chord between B and the running point C until B can hold no
//! longer, at cos χ = −K′/(mR²); whence turn = β + a number of the body, for β < π.
//!
//! β = π is the rocking block's collision (Housner 1963): turn π, ω falls by the factor
//! (K′ − mR²)/(K′ + mR²), and bodies with K′ ≤ mR² stop dead. For K′ ≥ mR², β → 0 ends like β = π.

use crate::body::Body;
use crate::error::{InvalidInput, bounded, moderate};
use crate::law::IdealLaw;
use crate::turn::inertias;
use core::f64::consts::{PI, TAU};

/// What becomes of a body that falls on the imperfection of its rim.
#[derive(Debug, Clone, PartialEq)]
pub struct ImperfectRim {
    /// The angle between the leans before and after, rad, in the direction in which the imperfection's
    /// angle is counted; `None` for a body that stops dead.
    pub turn: Option<f64>,
    /// The rate of tipping with which it rises again, rad/s.
    pub tipping_rate: f64,
    /// The part of the kinetic energy on arrival that is left.
    pub energy_kept: f64,
    /// Its collisions, one or two.
    pub collisions: Vec<Collision>,
}

/// A plastic collision of one more point of the rim, while another rests on the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// Where round the rim from A, rad between 0 and 2π.
    pub azimuth: f64,
    /// The tilt at which it happens, in units of δ/R.
    pub scaled_tilt: f64,
    /// The table's upward impulse at the point that strikes, N s.
    pub impulse: f64,
    /// The same at the point that rested on the table, N s: 0 when it lifts off.
    pub held_impulse: f64,
    /// Where round the rim from A the lean moves to right after it, rad between 0 and 2π; `None` for a
    /// body that stops dead.
    pub lean_azimuth: Option<f64>,
    /// How fast, rad/s.
    pub lean_rate: f64,
    /// The upward velocity of the centre of mass right after, m/s.
    pub rise_rate: f64,
    /// The part of the kinetic energy on arrival that is left.
    pub energy_kept: f64,
}

/// The fall of a body that tips at `tipping_rate` (ω, rad/s) toward face down and whose rim has an
/// imperfection at the angle `angle` (β, rad) from its point of contact.
///
/// # Errors
/// Refuses an angle outside (0, 2π) and a tipping rate outside 1e-60 to 1e60.
pub fn imperfect_rim(
    body: &Body,
    law: IdealLaw,
    angle: f64,
    tipping_rate: f64,
) -> Result<ImperfectRim, InvalidInput> {
    let inside = |angle| angle > 0.0 && angle < TAU;
    bounded("angle", angle, inside, "inside (0, 2 pi)", "rad")?;
    moderate("tipping_rate", tipping_rate, "rad/s")?;
    let (j, k) = inertias(body, law);
    let valley = Valley {
        k: k / j,
        m: body.mass() * body.radius() * body.radius() / j,
    };
    // Mirrored to where B comes before half a turn.
    let mirrored = angle > PI;
    let beta = if mirrored { TAU - angle } else { angle };
    let seen = |azimuth: f64| if mirrored { TAU - azimuth } else { azimuth };
    let (end, strikes) = valley.fall(beta);

    let collisions = strikes.iter().map(|strike| Collision {
        azimuth: in_one_round(seen(beta + strike.chi)),
        scaled_tilt: strike.scaled_tilt,
        impulse: strike.impulse * j / body.radius() * tipping_rate,
        held_impulse: strike.held_impulse * j / body.radius() * tipping_rate,
        lean_azimuth: strike
            .after
            .direction()
            .map(|chi| in_one_round(seen(beta + chi))),
        lean_rate: strike.after.lean_rate() * tipping_rate,
        rise_rate: strike.after.up * body.radius() * tipping_rate,
        energy_kept: valley.energy(&strike.after),
    });
    Ok(ImperfectRim {
        turn: end.chi.map(|chi| seen(beta + chi)),
        tipping_rate: end.energy.sqrt() * tipping_rate,
        energy_kept: end.energy,
        collisions: collisions.collect(),
    })
}

/// An angle brought between 0 and 2π.
fn in_one_round(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).floor()
}

/// The cone with its tip cut off, in units of J′, ω and R: K′ and mR², whose sum is one. Plane
/// vectors have their parts toward B and across, along e_z × e_B; angles χ count from B.
struct Valley {
    k: f64,
    m: f64,
}

/// The lean's rate and the upward velocity of the base.
#[derive(Clone, Copy)]
struct Velocity {
    lean: [f64; 2],
    up: f64,
}

impl Velocity {
    fn lean_rate(&self) -> f64 {
        dot(self.lean, self.lean).sqrt()
    }

    fn direction(&self) -> Option<f64> {
        let [toward, across] = self.lean;
        (self.lean_rate() > 0.0).then(|| libm::atan2(across, toward))
    }

    /// The velocity with which a rim point comes up.
    fn of_point(&self, e: [f64; 2]) -> f64 {
        self.up - dot(self.lean, e)
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// A collision of the point at χ.
struct Strike {
    chi: f64,
    scaled_tilt: f64,
    impulse: f64,
    held_impulse: f64,
    after: Velocity,
}

/// The lean's last direction, unless there is none, and what is left of the energy.
struct End {
    chi: Option<f64>,
    energy: f64,
}

impl Valley {
    /// 2T.
    fn energy(&self, v: &Velocity) -> f64 {
        self.k * dot(v.lean, v.lean) + self.m * v.up * v.up
    }

    /// All that happens, for 0 < β ≤ π.
    fn fall(&self, beta: f64) -> (End, Vec<Strike>) {
        let opposite = PI - beta <= 4.0 * f64::EPSILON;
        let (sin_half, cos_half) = if opposite {
            (1.0, 0.0)
        } else {
            libm::sincos(0.5 * beta)
        };
        let (b, a) = ([1.0, 0.0], at_twice(cos_half, -sin_half));
        let tipping = Velocity {
            lean: [-a[0], -a[1]],
            up: -1.0,
        };
        let first = self.strike(&tipping, b, a, 0.0, 0.5 / (sin_half * sin_half));
        if first.held_impulse > 0.0 {
            return (self.rock_over_chord(&first.after), vec![first]);
        }
        if opposite {
            // It leans straight toward B, and no other point comes down.
            return (self.roll_off(b, &first.after), vec![first]);
        }

        let y = (self.k - self.m) * sin_half / cos_half;
        let chi = 2.0 * libm::atan2(1.0, y);
        let c = at_twice(y / (1.0 + y * y).sqrt(), 1.0 / (1.0 + y * y).sqrt());
        let second = self.strike(&first.after, c, b, chi, 0.5 * (1.0 + y * y));
        let end = if second.held_impulse > 0.0 {
            self.rock_over_chord(&second.after)
        } else {
            self.roll_off(c, &second.after)
        };
        (end, vec![first, second])
    }

    /// A plastic collision of one rim point while another is held, or lifts off.
    fn strike(
        &self,
        v: &Velocity,
        struck: [f64; 2],
        held: [f64; 2],
        chi: f64,
        scaled_tilt: f64,
    ) -> Strike {
        let (after, impulse, held_impulse) = if self.k + self.m * dot(struck, held) >= 0.0 {
            let stopped = -v.of_point(struck);
            let [toward, across] = v.lean;
            let tilted = self.m * stopped;
            let after = Velocity {
                lean: [toward - tilted * struck[0], across - tilted * struck[1]],
                up: v.up + self.k * stopped,
            };
            (after, self.k * self.m * stopped, 0.0)
        } else {
            self.strike_holding(v, struck, held)
        };
        Strike {
            chi,
            scaled_tilt,
            impulse,
            held_impulse,
            after,
        }
    }

    /// Both points come to rest: of the velocity that part is left which turns the body about the
    /// chord between them. With the impulses at both.
    fn strike_holding(
        &self,
        v: &Velocity,
        struck: [f64; 2],
        held: [f64; 2],
    ) -> (Velocity, f64, f64) {
        let difference = [struck[0] - held[0], struck[1] - held[1]];
        let length = dot(difference, difference).sqrt();
        let chord = difference.map(|part| part / length);
        let across = [chord[1], -chord[0]];
        let distance = dot(struck, across);
        let inertia = self.k + self.m * distance * distance;
        let rate = (self.k * dot(v.lean, across) + self.m * distance * v.up) / inertia;
        let after = Velocity {
            lean: across.map(|part| rate * part),
            up: rate * distance,
        };
        let sum = self.m * (after.up - v.up);
        let difference = 2.0 * self.k * dot(v.lean, chord) / length;
        // Where holding begins, rounding must not make the table pull.
        let held_impulse = (0.5 * (sum - difference)).max(0.0);
        (after, 0.5 * (sum + difference), held_impulse)
    }

    /// Flat bodies: the chord from B to the running point C turns, without loss, past the point
    /// opposite to B, until B would have to be pulled.
    fn rock_over_chord(&self, v: &Velocity) -> End {
        let energy = self.energy(v);
        if energy == 0.0 {
            return End { chi: None, energy };
        }
        let distance = ((self.m - self.k) / (2.0 * self.m)).sqrt();
        let sine = (0.5 / self.m).sqrt();
        let rate = (energy / (self.k + self.m * distance * distance)).sqrt();
        let after = Velocity {
            lean: [rate * distance, rate * sine],
            up: rate * distance,
        };
        self.roll_off(at_twice(distance, sine), &after)
    }

    /// The rim rolls on from its point e as in the paper's near-collision: the tilt grows in the end,
    /// and ψ = √(J′/K′) arctan(ω t/φ_c) has less than half the limiting angle to go.
    fn roll_off(&self, e: [f64; 2], v: &Velocity) -> End {
        let [tilting, turning] = [dot(v.lean, e), dot(v.lean, [-e[1], e[0]])];
        let energy = tilting * tilting + self.k * turning * turning;
        let stretch = 1.0 / self.k.sqrt();
        let left = stretch * libm::atan2(turning, stretch * tilting);
        let chi = libm::atan2(e[1], e[0]) + left;
        End {
            chi: (energy > 0.0).then_some(chi),
            energy,
        }
    }
}

/// The unit vector at twice the angle of another.
fn at_twice(cos: f64, sin: f64) -> [f64; 2] {
    [(cos - sin) * (cos + sin), 2.0 * cos * sin]
}
