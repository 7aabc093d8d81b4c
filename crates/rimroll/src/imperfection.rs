//! The theory that the paper rejects: a rim, or a table, with an imperfection.
//!
//! Source: Srinivasan & Ruina (2007), section "Candidate theories for symmetry breaking": "Geometric
//! perturbations to the circular rim can similarly lead to two-point collisions ... We could then
//! compute the consequences of, say, a plastic collision at the new point of contact." The paper stops
//! there; this module does that computation. (The other theory that it rejects, in which all points of the
//! rim slap the table at once, is not determined by any rigid-body law.)
//!
//! # Assumptions
//! The body tips about the point A of its rim, exactly toward face down, at the rate ω. One point B of
//! the rim (or of the table under it), at the angle β round the rim from A, protrudes by a height
//! δ ≪ R; the rest of the rim is perfect. B meets the table before the base is flat. Every collision is
//! plastic: the striking point comes to rest instantly and without rebound, and the table pushes but
//! never pulls. The result is the limit δ → 0, in which neither δ nor gravity matters.
//!
//! # Mechanics
//! Close to face down the lean is a vector q in the plane (length: the tilt; direction: toward the lowest
//! point of the rim), and the base's centre is at the height z. The spin about the axis stays zero, also in
//! collisions. The centre of mass moves sideways with H q̇ without slip, and not at all without friction.
//! In both cases
//!
//! ```text
//! 2T = K′ |q̇|² + m ż²        K′ = A + mH² without slip, A without friction
//! z ≥ R |q|                   the rim: a cone
//! z ≥ δ + R q·e_B             the imperfection: a plane that cuts off the cone's tip
//! ```
//!
//! which is a particle in a convex valley. While the body rolls on its rim, the particle moves along
//! geodesics of the cone. They are straight on the unrolled cone, which gives the paper's π √(J′/K′) with
//! J′ = K′ + mR². An impulse N at the rim point e changes q̇ by −(R/K′) N e and ż by N/m. The velocity after
//! a plastic collision is the admissible velocity (one that does not enter the table) nearest to the
//! velocity before it, in the kinetic metric (Moreau). Without slip the impulse requires a horizontal
//! component of mHR/(A + mH²) times its vertical one, the same ratio as rolling through the near-collision.
//!
//! 1. **B strikes.** If K′ + mR² cos β ≥ 0, A lifts off and the velocity becomes
//!    q̇ = −ω [e_A + (mR²/J′)(1 − cos β) e_B]; the fraction mR² K′ (1 − cos β)²/J′² of the energy is lost.
//!    Otherwise A and B both stay in contact, and the body rotates about the chord between them.
//! 2. **The rim strikes again.** The body rotates about B alone until a rim point C comes down, at the
//!    angle χ from B with cot(χ/2) = (K′ − mR²)/J′ tan(β/2).
//! 3. **The body rolls off.** For K′ ≥ mR² (all but flat bodies) B lifts off, and the rim rolls on from C
//!    without touching B again. With c, s = cos, sin of β/2 and D = K′ − mR²:
//!
//! ```text
//! turn = β + 2 arccot(D s/(J′ c)) − √(J′/K′) arctan[4 mR² J′² s c³ / (√(J′/K′) D (J′² − 4 K′ mR² s⁴))]
//! ```
//!
//! For K′ < mR² the body rolls on over the chord between B and the moving contact point C until the force at
//! B vanishes, at cos χ = −K′/(mR²). For β < π the turn is therefore β plus a constant of the body.
//!
//! β = π is the collision of the rocking block (Housner 1963): the turn is π, ω is multiplied by
//! (K′ − mR²)/(K′ + mR²), and bodies with K′ ≤ mR² stop completely. For K′ ≥ mR² the limit β → 0 has the
//! same outcome as β = π.

use crate::body::Body;
use crate::error::{InvalidInput, bounded, moderate};
use crate::law::IdealLaw;
use crate::turn::inertias;
use core::f64::consts::{PI, TAU};

/// The outcome of a fall on the imperfection of the rim.
#[derive(Debug, Clone, PartialEq)]
pub struct ImperfectRim {
    /// The angle between the leans before and after, rad, positive in the direction in which the
    /// imperfection's angle is measured; `None` for a body that stops completely.
    pub turn: Option<f64>,
    /// The tipping rate with which the body rises again, rad/s.
    pub tipping_rate: f64,
    /// The remaining fraction of the kinetic energy before the first collision.
    pub energy_kept: f64,
    /// The one or two collisions.
    pub collisions: Vec<Collision>,
}

/// A plastic collision of a second point of the rim while another is in contact with the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// The angle of the striking point round the rim from A, rad, between 0 and 2π.
    pub azimuth: f64,
    /// The tilt at the collision, in units of δ/R.
    pub scaled_tilt: f64,
    /// The upward impulse at the striking point, N s.
    pub impulse: f64,
    /// The upward impulse at the point already in contact, N s: 0 if that point lifts off.
    pub held_impulse: f64,
    /// The direction of the lean's velocity after the collision, as an angle round the rim from A, rad,
    /// between 0 and 2π; `None` for a body that stops completely.
    pub lean_azimuth: Option<f64>,
    /// The magnitude of the lean's velocity after the collision, rad/s.
    pub lean_rate: f64,
    /// The upward velocity of the centre of mass after the collision, m/s.
    pub rise_rate: f64,
    /// The remaining fraction of the kinetic energy before the first collision.
    pub energy_kept: f64,
}

/// The fall of a body that tips at `tipping_rate` (ω, rad/s) toward face down and whose rim has an
/// imperfection at `angle` (β, rad) from the contact point.
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
    // For β > π the mirror image is computed.
    let mirrored = angle > PI;
    let beta = if mirrored { TAU - angle } else { angle };
    let unmirrored = |azimuth: f64| if mirrored { TAU - azimuth } else { azimuth };
    let (end, strikes) = valley.fall(beta);

    let collisions = strikes.iter().map(|strike| Collision {
        azimuth: wrapped_to_two_pi(unmirrored(beta + strike.chi)),
        scaled_tilt: strike.scaled_tilt,
        impulse: strike.impulse * j / body.radius() * tipping_rate,
        held_impulse: strike.held_impulse * j / body.radius() * tipping_rate,
        lean_azimuth: strike
            .after
            .direction()
            .map(|chi| wrapped_to_two_pi(unmirrored(beta + chi))),
        lean_rate: strike.after.lean_rate() * tipping_rate,
        rise_rate: strike.after.up * body.radius() * tipping_rate,
        energy_kept: valley.energy(&strike.after),
    });
    Ok(ImperfectRim {
        turn: end.chi.map(|chi| unmirrored(beta + chi)),
        tipping_rate: end.energy.sqrt() * tipping_rate,
        energy_kept: end.energy,
        collisions: collisions.collect(),
    })
}

/// The equivalent angle between 0 and 2π.
fn wrapped_to_two_pi(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).floor()
}

/// The truncated cone, in units of J′, ω and R: K′ and mR², whose sum is one. Plane vectors have components
/// toward B and along e_z × e_B; angles χ are measured from B.
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

    /// The upward velocity of a rim point.
    fn of_rim_point(&self, e: [f64; 2]) -> f64 {
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

/// The final direction of the lean (`None` if the body stops) and the remaining fraction of the energy.
struct End {
    chi: Option<f64>,
    energy: f64,
}

impl Valley {
    /// 2T.
    fn energy(&self, v: &Velocity) -> f64 {
        self.k * dot(v.lean, v.lean) + self.m * v.up * v.up
    }

    /// The final state and the collisions, for 0 < β ≤ π.
    fn fall(&self, beta: f64) -> (End, Vec<Strike>) {
        let opposite = PI - beta <= 4.0 * f64::EPSILON;
        let (sin_half, cos_half) = if opposite {
            (1.0, 0.0)
        } else {
            libm::sincos(0.5 * beta)
        };
        let (b, a) = ([1.0, 0.0], at_double_angle(cos_half, -sin_half));
        let tipping = Velocity {
            lean: [-a[0], -a[1]],
            up: -1.0,
        };
        let first = self.strike(&tipping, b, a, 0.0, 0.5 / (sin_half * sin_half));
        if first.held_impulse > 0.0 {
            return (self.rock_over_chord(&first.after), vec![first]);
        }
        if opposite {
            // The lean is exactly toward B, and no other point comes down.
            return (self.roll_off(b, &first.after), vec![first]);
        }

        let y = (self.k - self.m) * sin_half / cos_half;
        let chi = 2.0 * libm::atan2(1.0, y);
        let c = at_double_angle(y / (1.0 + y * y).sqrt(), 1.0 / (1.0 + y * y).sqrt());
        let second = self.strike(&first.after, c, b, chi, 0.5 * (1.0 + y * y));
        let end = if second.held_impulse > 0.0 {
            self.rock_over_chord(&second.after)
        } else {
            self.roll_off(c, &second.after)
        };
        (end, vec![first, second])
    }

    /// A plastic collision of one rim point, while another one stays in contact or lifts off.
    fn strike(
        &self,
        v: &Velocity,
        struck: [f64; 2],
        held: [f64; 2],
        chi: f64,
        scaled_tilt: f64,
    ) -> Strike {
        let (after, impulse, held_impulse) = if self.k + self.m * dot(struck, held) >= 0.0 {
            let stopped = -v.of_rim_point(struck);
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

    /// A collision after which both points are at rest: only the rotation about the chord between them
    /// remains. Returns the velocity and the impulses at the striking and at the held point.
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
        // Near the threshold, rounding must not make this impulse negative.
        let held_impulse = (0.5 * (sum - difference)).max(0.0);
        (after, 0.5 * (sum + difference), held_impulse)
    }

    /// Flat bodies: C moves on, without loss of energy, past the point opposite to B, until the table would
    /// have to pull at B.
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
        self.roll_off(at_double_angle(distance, sine), &after)
    }

    /// The rim rolls on from its point e as in the paper's near-collision. In the end the tilt grows, and
    /// the rest of ψ = √(J′/K′) arctan(ω t/φ_c) is less than half of the limiting angle.
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

/// The unit vector at twice the angle of (cos, sin).
fn at_double_angle(cos: f64, sin: f64) -> [f64; 2] {
    [(cos - sin) * (cos + sin), 2.0 * cos * sin]
}
