//! Steady motions: the tilt, the yaw rate and the axial spin are constant. The contact point runs round a circle or
//! along a straight line.
//!
//! A state with φ̇ = 0 is steady if φ̈ = 0. Under the ideal laws ẇ and ṡ are φ̇ times functions of the state, so w and s
//! follow the tilt, and a small disturbance of the tilt obeys δφ̈ = −ω² δφ + constant with
//!
//! ```text
//! −ω² = ∂φ̈/∂φ + ∂φ̈/∂w · ∂ẇ/∂φ̇ + ∂φ̈/∂s · ∂ṡ/∂φ̇
//! ```
//!
//! For ω² > 0 the tilt nutates with the angular frequency ω. For ω² < 0 the disturbance grows like exp(√(−ω²) t). The
//! derivatives come from the equations of motion on dual numbers.

use crate::body::Body;
use crate::error::{InvalidInput, bounded, positive, within};
use crate::law::{Dynamics, Frictionless, IdealLaw, NoSlip, Parameters};
use crate::real::{Dual, Real, Slopes};
use crate::state::Coordinates;
use crate::turn::inertias;
use core::f64::consts::{FRAC_PI_2, PI};

/// A state is steady if its φ̈ is less than this fraction of the sum of its terms.
const ROUNDING: f64 = 1e-12;

/// A motion at a constant tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyMotion {
    /// ψ̇, rad/s.
    pub yaw_rate: f64,
    /// s = θ̇ + ψ̇ cos φ, rad/s.
    pub axial_spin: f64,
    /// ω², the squared angular frequency of nutation, rad²/s²; negative for an unstable motion.
    pub nutation_squared: f64,
}

/// The rates that a steady motion is asked to have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// The yaw rate; the axial spin follows.
    YawRate(f64),
    /// The axial spin; up to two yaw rates follow, the slower one first.
    AxialSpin(f64),
    /// The yaw rate and the axial spin.
    Both(f64, f64),
}

/// The steady motions of a body at a tilt (rad) with the given rates (rad/s).
///
/// There are none, one or two. Under [`IdealLaw::Frictionless`] the centre of mass is at rest; another uniform
/// velocity may be added.
///
/// # Errors
/// Refuses gravity ≤ 0, a tilt outside (0, π) and rates above 1e30 rad/s.
pub fn steady_motions(
    body: &Body,
    law: IdealLaw,
    tilt: f64,
    given: Given,
    gravity: f64,
) -> Result<Vec<SteadyMotion>, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    let inside = |tilt| tilt > 0.0 && tilt < PI;
    bounded("tilt", tilt, inside, "inside (0, pi)", "rad")?;
    let check = |name, rate| within(name, rate, 1e30, "between -1e30 and 1e30", "rad/s");
    if let Given::YawRate(rate) | Given::Both(rate, _) = given {
        check("yaw_rate", rate)?;
    }
    if let Given::AxialSpin(spin) | Given::Both(_, spin) = given {
        check("axial_spin", spin)?;
    }
    let k = Parameters::new(body, g);
    Ok(match law {
        IdealLaw::NoSlip => Balance::new(&NoSlip::new(k), tilt).motions(given),
        IdealLaw::Frictionless => Balance::new(&Frictionless::new(k), tilt).motions(given),
    })
}

/// The yaw rate, rad/s, at which a body wobbles steadily at a tilt φ with its centre of mass at rest:
/// ψ̇² = m g R ρ / [sin φ (A R cos φ − C H sin φ)] with ρ = R cos φ − H sin φ. No friction acts, so
/// this motion exists under every law. Its spin rate is s = Hψ̇ sin φ/R, that is
/// θ̇ = ψ̇ (H sin φ/R − cos φ).
///
/// Below the smaller of the tilts where ρ = 0 (balance) and where A R cos φ = C H sin φ both factors are positive, and
/// beyond the larger one both are negative, as for a tube that spins nearly horizontal on one rim.
///
/// # Errors
/// Refuses gravity ≤ 0, a tilt outside (0, π), and a tilt at which no steady wobble exists
/// (ψ̇² ≤ 0).
pub fn steady_wobble_rate(body: &Body, tilt: f64, gravity: f64) -> Result<f64, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    let inside = |tilt| tilt > 0.0 && tilt < PI;
    bounded("tilt", tilt, inside, "inside (0, pi)", "rad")?;
    let (sin, cos) = libm::sincos(tilt);
    let (m, r, h) = (body.mass(), body.radius(), body.height());
    let rho = r * cos - h * sin;
    let stiffness = body.transverse_inertia() * r * cos - body.axial_inertia() * h * sin;
    let square = m * g * r * rho / (sin * stiffness);
    let exists = |_| square > 0.0 && square.is_finite();
    let bound = "one at which a steady wobble exists \
        ((R cos(tilt) - H sin(tilt))/(A R cos(tilt) - C H sin(tilt)) > 0)";
    bounded("tilt", tilt, exists, bound, "rad")?;
    Ok(square.sqrt())
}

/// The ratio of the angular frequency of nutation to the yaw rate in a steady wobble with the centre of mass at rest, as
/// the tilt goes to zero: √((3A + mH²)/(A + mR² + mH²)) without slip, √(3A/(A + mR²)) without friction.
pub fn nutation_ratio(body: &Body, law: IdealLaw) -> f64 {
    let (j, k) = inertias(body, law);
    ((2.0 * body.transverse_inertia() + k) / j).sqrt()
}

/// The axial spin, rad/s, above which an upright disk that rolls straight without slip is stable:
/// s² = A m g R/(C (C + mR²)).
///
/// # Errors
/// Refuses gravity ≤ 0 and a body that is not a disk (H > 0).
pub fn critical_rolling_spin(disk: &Body, gravity: f64) -> Result<f64, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    check_disk(disk)?;
    let (m, r, a, c) = (
        disk.mass(),
        disk.radius(),
        disk.transverse_inertia(),
        disk.axial_inertia(),
    );
    Ok((a * m * g * r / (c * (c + m * r * r))).sqrt())
}

/// The yaw rate, rad/s, above which a disk that spins without slip about its vertical diameter is stable:
/// Ω² = m g R/(A + mR²).
///
/// # Errors
/// Refuses gravity ≤ 0 and a body that is not a disk (H > 0).
pub fn critical_spinning_rate(disk: &Body, gravity: f64) -> Result<f64, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    check_disk(disk)?;
    let (m, r) = (disk.mass(), disk.radius());
    Ok((m * g * r / (disk.transverse_inertia() + m * r * r)).sqrt())
}

fn check_disk(body: &Body) -> Result<(), InvalidInput> {
    let is_disk = |height: f64| height == 0.0;
    let bound = "0 (a disk without thickness, as from disk(radius))";
    bounded("height", body.height(), is_disk, bound, "m")?;
    Ok(())
}

/// The yaw rate, rad/s, at which a body on a smooth table spins about the vertical at a tilt (rad) without spinning in
/// the frame that yaws (θ̇ = 0): Ω² = m g ρ/((A − C) sin φ cos φ) with ρ = R cos φ − H sin φ.
///
/// # Errors
/// Refuses gravity ≤ 0, a tilt outside (0, π/2), and a tilt at which no such motion exists (Ω² < 0, or A = C).
pub fn spinning_rate(body: &Body, tilt: f64, gravity: f64) -> Result<f64, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    let inside = |tilt| tilt > 0.0 && tilt < FRAC_PI_2;
    bounded("tilt", tilt, inside, "inside (0, pi/2)", "rad")?;
    let (sin, cos) = libm::sincos(tilt);
    let rho = body.radius() * cos - body.height() * sin;
    let excess = body.transverse_inertia() - body.axial_inertia();
    let squared = body.mass() * g * rho / (excess * sin * cos);
    let exists = |_| squared >= 0.0 && squared.is_finite();
    let bound = "one at which the body can spin about the vertical ((A - C) (R cos(tilt) - H sin(tilt)) > 0)";
    bounded("tilt", tilt, exists, bound, "rad")?;
    Ok(squared.sqrt())
}

/// The balance of the tilt at φ̇ = 0: φ̈ = `of_yaw` w² + `of_both` w s − `weight`.
struct Balance<'a, L> {
    dynamics: &'a L,
    tilt: f64,
    of_yaw: f64,
    of_both: f64,
    weight: f64,
    /// The change of `weight` with the tilt, which is not zero where `weight` is.
    stiffness: f64,
}

/// A number with its derivatives by φ, φ̇, w and s.
type Number = Dual<Slopes<4>>;

const TILT: usize = 0;
const TILT_RATE: usize = 1;
const W: usize = 2;
const S: usize = 3;

impl<'a, L: Dynamics<Number>> Balance<'a, L> {
    fn new(dynamics: &'a L, tilt: f64) -> Self {
        let [at_rest, ..] = accelerations(dynamics, tilt, 0.0, 0.0);
        let [yawing, ..] = accelerations(dynamics, tilt, 1.0, 0.0);
        Balance {
            dynamics,
            tilt,
            of_yaw: 0.5 * yawing.slope.0[W],
            of_both: yawing.slope.0[S],
            weight: -at_rest.value,
            stiffness: at_rest.slope.0[TILT],
        }
    }

    fn motions(&self, given: Given) -> Vec<SteadyMotion> {
        let sin = libm::sin(self.tilt);
        let rates = match given {
            Given::YawRate(yaw_rate) => self.with_yaw_rate(yaw_rate * sin).collect(),
            Given::AxialSpin(spin) => self.with_axial_spin(spin),
            Given::Both(yaw_rate, spin) => vec![[yaw_rate * sin, spin]],
        };
        let steady = rates.into_iter().filter(|&[w, s]| self.is_steady(w, s));
        steady
            .map(|[w, s]| SteadyMotion {
                yaw_rate: w / sin,
                axial_spin: s,
                nutation_squared: self.nutation_squared(w, s),
            })
            .collect()
    }

    /// (w, s). Without yaw, every axial spin is steady or none is.
    fn with_yaw_rate(&self, w: f64) -> impl Iterator<Item = [f64; 2]> + use<L> {
        let s = (self.weight - self.of_yaw * w * w) / (self.of_both * w);
        s.is_finite().then_some([w, s]).into_iter()
    }

    /// (w, s), the slower yaw first.
    fn with_axial_spin(&self, s: f64) -> Vec<[f64; 2]> {
        let linear = self.of_both * s;
        // At the vertical of a disk only rounding is left of `of_yaw`.
        let of_yaw = if self.of_yaw.abs() > ROUNDING * self.of_both.abs() {
            self.of_yaw
        } else {
            0.0
        };
        let discriminant = linear * linear + 4.0 * of_yaw * self.weight;
        // Both terms of the sum have the same sign, so nothing cancels.
        let half = -0.5 * (linear + discriminant.sqrt().copysign(linear));
        let (slow, fast) = (-self.weight / half, half / of_yaw);
        let roots = if half == 0.0 {
            [0.0, f64::NAN]
        } else {
            [slow, fast]
        };
        roots
            .into_iter()
            .filter(|w| w.is_finite())
            .map(|w| [w, s])
            .collect()
    }

    fn is_steady(&self, w: f64, s: f64) -> bool {
        let terms = [self.of_yaw * w * w, self.of_both * w * s, -self.weight];
        let size = terms.iter().map(|term| term.abs()).sum::<f64>() + self.stiffness.abs();
        terms.iter().sum::<f64>().abs() <= ROUNDING * size
    }

    fn nutation_squared(&self, w: f64, s: f64) -> f64 {
        let [p, w, s] = accelerations(self.dynamics, self.tilt, w, s).map(|rate| rate.slope.0);
        -(p[TILT] + p[W] * w[TILT_RATE] + p[S] * s[TILT_RATE])
    }
}

/// (φ̈, ẇ, ṡ) at φ̇ = 0.
fn accelerations(dynamics: &impl Dynamics<Number>, tilt: f64, w: f64, s: f64) -> [Number; 3] {
    let variable = |value, index| {
        let mut slope = Slopes([0.0; 4]);
        slope.0[index] = 1.0;
        Dual { value, slope }
    };
    let (sin, cos) = variable(tilt, TILT).sin_cos();
    let u = Coordinates {
        sin,
        cos,
        p: variable(0.0, TILT_RATE),
        w: variable(w, W),
        s: variable(s, S),
        ..Coordinates::zero()
    };
    let rates = dynamics.reduced_rates(&u);
    [rates.p / sin, rates.w / sin, rates.s / sin]
}
