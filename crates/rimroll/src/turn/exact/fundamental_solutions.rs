//! No slip: all motions of a body as functions of the tilt.
//!
//! Rows 1 and 3 of the paper's `noslip_eqs` are linear in l = ψ̇ sin² φ and s = θ̇ + ψ̇ cos φ. With the
//! independent variable η = ln y, y = tan(φ/2), they are
//!
//! ```text
//! dl/dη = a sin² φ s − b sin φ l          a = C (C + mR²)/D     b = C mHR/D
//! ds/dη = κ l + b sin φ s                 κ = mR² A/D           D = C (A + mH²) + mR² A
//! ```
//!
//! The system has zero trace and a regular singular point at φ = 0. One solution, (l, s) = (l₁, s₁), is
//! regular there; the other is (l₂, s₂) + κ (l₁, s₁) ln y. The method of Frobenius gives the four functions
//! as power series in φ, which converge for φ < π. They depend on the body alone and are tabulated once per
//! body, as polynomials in y that interpolate at Chebyshev points.
//!
//! Without friction, too, l and s obey linear equations, and the body comes down flat if l = 0 at φ = 0. So the starts
//! that do lie on a straight line in the plane of yaw and spin rates, whatever the tilt rate and gravity
//! ([`watershed_slope`]). It separates the starts that come down to the left from those that come down to the right.

use crate::body::Body;
use crate::error::{InvalidInput, bounded};
use crate::law::{IdealLaw, Parameters};
use crate::real::Real;
use core::f64::consts::{FRAC_PI_2, PI};

/// Number of terms of the power series. At φ = π/2 the last term is about 2⁻⁶⁴ of the first.
const TERMS: usize = 64;

/// Number of Chebyshev points, sufficient for tilts up to π/2.
const POINTS: usize = 28;

/// Size, relative to the largest Chebyshev coefficient, below which coefficients are rounding errors.
const NEGLIGIBLE: f64 = 5e-16;

/// The fundamental solutions of one body, and its constants.
#[derive(Debug, Clone)]
pub(super) struct Fundamental<C> {
    pub(super) parameters: Parameters<C>,
    /// K = A + mH².
    pub(super) base_inertia: C,
    /// J = K + mR².
    pub(super) rim_inertia: C,
    /// mHR.
    pub(super) mhr: C,
    /// C + mR².
    pub(super) axial_inertia: C,
    /// a, b, κ.
    pub(super) rates: [C; 3],
    /// 2/y_end. The polynomials are in z = 2y/y_end − 1.
    scale: f64,
    /// Polynomial coefficients of l₁/y², s₁, l₂, s₂/y, highest power first.
    coefficients: Vec<[C; 4]>,
}

impl Fundamental<f64> {
    /// The table for tilts with tan(φ/2) up to `end` ≤ 1.
    pub(super) fn new(k: Parameters<f64>, end: f64) -> Self {
        let chebyshev = |k| chebyshev(&Series::new(rates(k)), end);
        let size = |row: &[f64; 4]| row.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let coefficients = chebyshev(&k);
        let most = coefficients.iter().map(size).fold(0.0, f64::max);
        let last = coefficients
            .iter()
            .rposition(|row| size(row) > NEGLIGIBLE * most);
        Fundamental::with_terms(k, end, last.unwrap_or(0) + 1)
    }
}

impl<C: Real> Fundamental<C> {
    /// The table for another number type, with as many terms.
    pub(super) fn like(table: &Fundamental<f64>, k: Parameters<C>) -> Self {
        Fundamental::with_terms(k, table.end(), table.coefficients.len())
    }

    fn with_terms(k: Parameters<C>, end: f64, terms: usize) -> Self {
        let mrr = k.m * k.r * k.r;
        let base_inertia = k.a + k.m * k.h * k.h;
        let rates = rates(&k);
        Fundamental {
            parameters: k,
            base_inertia,
            rim_inertia: base_inertia + mrr,
            mhr: k.m * k.h * k.r,
            axial_inertia: k.c + mrr,
            rates,
            scale: 2.0 / end,
            coefficients: powers(&chebyshev(&Series::new(rates), end)[..terms]),
        }
    }
}

/// [a, b, κ].
fn rates<C: Real>(k: &Parameters<C>) -> [C; 3] {
    let mrr = k.m * k.r * k.r;
    let mhr = k.m * k.h * k.r;
    let determinant = k.c * (k.a + k.m * k.h * k.h) + mrr * k.a;
    [
        k.c * (k.c + mrr) / determinant,
        k.c * mhr / determinant,
        mrr * k.a / determinant,
    ]
}

impl<C: Copy> Fundamental<C> {
    /// The end of the table, tan(φ/2).
    pub(super) fn end(&self) -> f64 {
        2.0 / self.scale
    }

    /// [l, s] of the solution that is regular at φ = 0, and of the other one, at y = tan(φ/2) with the logarithm
    /// η.
    #[inline(always)]
    pub(super) fn solutions<T: Real>(&self, y: T, eta: T) -> [T; 4]
    where
        C: Into<T>,
    {
        let z = y * T::from(self.scale) - T::from(1.0);
        let [l_1, s_1, l_2, s_2] = T::polynomials(&self.coefficients, z);
        let kappa: T = self.rates[2].into();
        let log = kappa * eta;
        let l_1 = y * y * l_1;
        [l_1, s_1, l_2 + log * l_1, y * s_2 + log * s_1]
    }
}

/// [l, s] at a tilt (rad), for the solution that is regular at φ = 0 with the value [0, 1] there.
pub(super) fn regular_solution(k: &Parameters<f64>, tilt: f64) -> [f64; 2] {
    let [l_1, s_1, ..] = Series::new(rates(k)).at(tilt);
    [l_1, s_1]
}

/// The power series in φ of the four functions.
struct Series<C> {
    l_1: [C; TERMS],
    s_1: [C; TERMS],
    l_2: [C; TERMS],
    s_2: [C; TERMS],
}

impl<C: Real> Series<C> {
    fn new([a, b, kappa]: [C; 3]) -> Self {
        let zero = C::from(0.0);
        let (swing, yaw) = (swing_of_tilt(), tilt_over_sine());
        let mut series = Series {
            l_1: [zero; TERMS],
            s_1: [zero; TERMS],
            l_2: [zero; TERMS],
            s_2: [zero; TERMS],
        };
        series.s_1[0] = C::from(1.0);
        series.l_2[0] = C::from(1.0);
        for k in 1..TERMS {
            let Series { l_1, s_1, l_2, s_2 } = &mut series;
            let n = C::from(k as f64);
            l_1[k] = (a * product(&swing, s_1, k) - b * l_1[k - 1]) / n;
            s_1[k] = (kappa * product(&yaw, l_1, k) + b * s_1[k - 1]) / n;
            let log_l = kappa * product(&yaw, l_1, k);
            l_2[k] = (a * product(&swing, s_2, k) - b * l_2[k - 1] - log_l) / n;
            let log_s = product(&yaw, l_2, k) - product(&yaw, s_1, k);
            s_2[k] = (kappa * log_s + b * s_2[k - 1]) / n;
        }
        series
    }

    /// [l₁, s₁, l₂, s₂] at a tilt, rad.
    fn at(&self, tilt: f64) -> [C; 4] {
        let value = |series: &[C; TERMS]| {
            let sum = |sum: C, &term: &C| sum * C::from(tilt) + term;
            series.iter().rev().fold(C::from(0.0), sum)
        };
        [&self.l_1, &self.s_1, &self.l_2, &self.s_2].map(value)
    }
}

/// Coefficient k of the product of two power series.
fn product<C: Real>(known: &[f64; TERMS], series: &[C; TERMS], k: usize) -> C {
    (0..=k).fold(C::from(0.0), |sum, i| {
        sum + C::from(known[i]) * series[k - i]
    })
}

/// φ sin φ.
fn swing_of_tilt() -> [f64; TERMS] {
    let mut series = [0.0; TERMS];
    let mut term = 1.0;
    for k in (2..TERMS).step_by(2) {
        series[k] = term;
        term /= -((k * (k + 1)) as f64);
    }
    series
}

/// φ / sin φ, the inverse of the series of sin φ / φ.
fn tilt_over_sine() -> [f64; TERMS] {
    let swing = swing_of_tilt();
    let mut series = [0.0; TERMS];
    series[0] = 1.0;
    for k in 1..TERMS - 2 {
        series[k] = -(1..=k).map(|i| swing[i + 2] * series[k - i]).sum::<f64>();
    }
    series
}

/// Chebyshev coefficients over (0, end) of l₁/y², s₁, l₂, s₂/y.
fn chebyshev<C: Real>(series: &Series<C>, end: f64) -> [[C; 4]; POINTS] {
    // cos(n (i + ½) π / POINTS), with the angle reduced modulo 2π.
    let cos = |n: usize, i: usize| {
        libm::cos(PI * (n * (2 * i + 1) % (4 * POINTS)) as f64 / (2 * POINTS) as f64)
    };
    let values: [[C; 4]; POINTS] = core::array::from_fn(|i| {
        let y = 0.5 * end * (1.0 + cos(1, i));
        let [l_1, s_1, l_2, s_2] = series.at(2.0 * libm::atan(y));
        let inverse = C::from(1.0 / y);
        [l_1 * inverse * inverse, s_1, l_2, s_2 * inverse]
    });
    core::array::from_fn(|n| {
        let norm = if n == 0 { 1.0 } else { 2.0 } / POINTS as f64;
        let weight = |i: usize| norm * cos(n, i);
        combined(values.iter().enumerate().map(|(i, row)| (weight(i), row)))
    })
}

/// Converts coefficients of Chebyshev polynomials to those of powers, highest power first. The Chebyshev
/// coefficients decrease so fast here that the conversion loses no accuracy.
fn powers<C: Real>(chebyshev: &[[C; 4]]) -> Vec<[C; 4]> {
    let terms = chebyshev.len();
    let mut polynomials = vec![vec![0.0; terms]; terms];
    polynomials[0][0] = 1.0;
    for n in 1..terms {
        let factor = if n == 1 { 1.0 } else { 2.0 };
        for power in 0..terms {
            let risen = if power > 0 {
                factor * polynomials[n - 1][power - 1]
            } else {
                0.0
            };
            let before = if n > 1 {
                polynomials[n - 2][power]
            } else {
                0.0
            };
            polynomials[n][power] = risen - before;
        }
    }
    let power = |power: usize| {
        combined(
            polynomials
                .iter()
                .zip(chebyshev)
                .map(|(polynomial, row)| (polynomial[power], row)),
        )
    };
    (0..terms).rev().map(power).collect()
}

/// A weighted sum of rows.
fn combined<'a, C: Real + 'a>(rows: impl Iterator<Item = (f64, &'a [C; 4])>) -> [C; 4] {
    rows.fold([C::from(0.0); 4], |sum, (weight, row)| {
        core::array::from_fn(|j| sum[j] + C::from(weight) * row[j])
    })
}

/// Yaw rate over spin rate of the starts at a tilt (rad) that come down flat, dimensionless.
///
/// Frictionless: A l + C s cos φ and s are constant and l = 0 at φ = 0, hence
/// C/(A (1 + cos φ) − C cos φ). No slip: the solution of the linear equations that is regular at φ = 0.
/// The paper says only that the side depends sensitively on the start.
///
/// # Errors
/// Refuses a tilt outside (0, π/2).
pub fn watershed_slope(body: &Body, law: IdealLaw, tilt: f64) -> Result<f64, InvalidInput> {
    let leans = |tilt: f64| 0.0 < tilt && tilt < FRAC_PI_2;
    bounded("tilt", tilt, leans, "inside (0, pi/2)", "rad")?;
    let (sin, cos) = libm::sincos(tilt);
    let (a, c) = (body.transverse_inertia(), body.axial_inertia());
    Ok(match law {
        IdealLaw::Frictionless => {
            // This is a sum of two terms that are not negative. For a flat body, C = 2A, the first one is zero.
            let half = libm::sin(0.5 * tilt);
            c / ((2.0 * a - c) * cos + 2.0 * a * half * half)
        }
        IdealLaw::NoSlip => {
            // Gravity does not enter the linear equations.
            let [l, s] = regular_solution(&Parameters::new(body, 1.0), tilt);
            let yaw_rate = l / (sin * sin);
            yaw_rate / (s - yaw_rate * cos)
        }
    })
}
