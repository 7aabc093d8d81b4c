//! Implicit steps by [`Collocation`], for parts of a motion that relax too fast for explicit steps:
//! creep, films, and whatever resists the wobble as the base comes down flat.
//!
//! The states at the points are found by Newton's method, which begins at the state at the start of the step.
//! (Extrapolating the step before would begin nearer, but its errors, enlarged, would enter the error
//! estimate.) The Jacobian matrices are exact, by dual numbers: finite differences have too few digits where
//! components of very different sizes act on each other. As long as the corrections shrink fast, the
//! Jacobian is that at the start of the step; else it is taken at each point. Where the next correction would
//! not be smaller, only a part of a correction is made. Only components on which some rate depends take part
//! in the linear equations; the others are integrals.
//!
//! Sources: Hairer & Wanner, *Solving Ordinary Differential Equations II*, section IV.8; for the damping,
//! Deuflhard, *Newton Methods for Nonlinear Problems*, section 3.3.

use super::{Collocation, Dense, POINTS, System, Work};
use crate::real::Dual;

/// Implicit steps of a system, one after another.
pub struct Implicit<'a, S, D, const N: usize> {
    system: &'a S,
    /// The system on dual numbers, for its Jacobian.
    dual: &'a D,
    method: &'static Collocation,
    tolerance: f64,
    start: [f64; N],
    jacobian: Jacobian<N>,
    /// Work so far.
    pub work: Work,
}

/// A finished step.
pub struct ImplicitStep<const N: usize> {
    /// The step.
    pub dense: Dense<f64, N>,
    /// Its error over what is tolerated: the step is good when this is ≤ 1.
    pub error: f64,
}

impl<const N: usize> ImplicitStep<N> {
    /// The factor by which the step size may change after this step, at least 1/4.
    pub fn next_factor(&self) -> f64 {
        (0.8 / libm::pow(self.error.max(1e-9), 1.0 / 7.0)).max(0.25)
    }
}

/// `[i][j]` is the derivative of the rate of component i with respect to component j.
type Jacobian<const N: usize> = [[f64; N]; N];

type States<const N: usize> = [[f64; N]; POINTS];

/// An iterate of Newton's method. All but the states are relative to the error scales.
struct Iterate<const N: usize> {
    states: States<N>,
    /// start + ∫ rates − states.
    residual: States<N>,
    correction: States<N>,
    /// The largest number in the correction that is no rounding error.
    change: f64,
}

impl<'a, S: System<f64, N>, D: System<Dual, N>, const N: usize> Implicit<'a, S, D, N> {
    /// Steps from `start` whose errors are held below a tolerance.
    pub fn new(system: &'a S, dual: &'a D, start: [f64; N], tolerance: f64) -> Self {
        let mut implicit = Implicit {
            system,
            dual,
            method: Collocation::get(),
            tolerance,
            start,
            jacobian: [[0.0; N]; N],
            work: Work::default(),
        };
        implicit.jacobian = implicit.jacobian(&start);
        implicit
    }

    /// The relaxation rate of the fastest component at the end of the last step: the size of the largest
    /// eigenvalue of the Jacobian, from its eighth power. Sums of the Jacobian's entries may be far larger where
    /// the components' scales differ much.
    pub fn relaxation(&self) -> f64 {
        let scales = self.system.scale(&self.start);
        let active = active(core::slice::from_ref(&self.jacobian));
        let entry = |i: usize, j: usize| self.jacobian[i][j] * scales[j] / scales[i];
        let row = |&i: &usize| active.iter().map(|&j| entry(i, j)).collect();
        let mut power: Vec<Vec<f64>> = active.iter().map(row).collect();
        let size = largest_row(&power);
        if size > 0.0 {
            for row in &mut power {
                row.iter_mut().for_each(|x| *x /= size);
            }
        }
        for _ in 0..3 {
            power = squared(&power);
        }
        size * largest_row(&power).sqrt().sqrt().sqrt()
    }

    /// A step of length h; none where Newton's method does not settle.
    pub fn attempt(&mut self, h: f64) -> Option<ImplicitStep<N>> {
        const MAX_ROUNDS: usize = 30;
        // So far from the start the equations may have another solution.
        const FARTHEST: f64 = 10.0;
        // If corrections shrink more slowly, new Jacobians are worth their cost, which is that of some rounds.
        const SLOW: f64 = 0.3;
        const MIN_FRACTION: f64 = 0.05;
        let scales = self.system.scale(&self.start);
        // An integral can be so much larger than its error scale that its rounding errors are, too.
        let rounding = self.start.map(|value| 4.0 * f64::EPSILON * value.abs());
        let sizes = Sizes { scales, rounding };
        let mut newton = Newton::new(self.method, &[self.jacobian; POINTS], sizes, h)?;
        let mut at = self.iterate(&newton, [self.start; POINTS], h);
        // Whether the Jacobians are those at the points, and which fraction of a correction is made.
        let (mut exact, mut fraction) = (false, 1.0);
        for _ in 0..MAX_ROUNDS {
            if at.change > FARTHEST {
                return None;
            }
            if at.change <= 0.02 * self.tolerance {
                let states = newton.corrected(&at, 1.0);
                return Some(self.found(&states, h));
            }
            let next = self.iterate(&newton, newton.corrected(&at, fraction), h);
            let (change, shrunk) = (at.change, next.change <= (1.0 - 0.5 * fraction) * at.change);
            if shrunk {
                (at, exact, fraction) = (next, false, 1.0);
                if at.change <= SLOW * change {
                    continue;
                }
            } else if exact && at.change <= 4.0 * self.tolerance {
                // The Jacobians are those here, so only rounding keeps the last corrections from shrinking.
                return Some(self.found(&at.states, h));
            }
            if exact {
                fraction *= 0.5;
                if fraction < MIN_FRACTION {
                    return None;
                }
            } else {
                let jacobians = at.states.map(|state| self.jacobian(&state));
                newton = Newton::new(self.method, &jacobians, sizes, h)?;
                (at.correction, at.change) = newton.solved(&at.residual);
                exact = true;
            }
        }
        None
    }

    /// Goes on from the end of a step.
    pub fn accept(&mut self, step: &Dense<f64, N>) {
        self.start = step.end;
        self.jacobian = self.jacobian(&step.end);
        self.work.steps += 1;
    }

    fn iterate(&mut self, newton: &Newton<N>, states: States<N>, h: f64) -> Iterate<N> {
        let rates = states.map(|state| self.system.rates(&state));
        self.work.evaluations += POINTS;
        let residual = core::array::from_fn(|k| {
            core::array::from_fn(|i| {
                let weights = &self.method.integral[k];
                let sum: f64 = (0..POINTS).map(|j| weights[j] * rates[j][i]).sum();
                (self.start[i] - states[k][i] + h * sum) / newton.sizes.scales[i]
            })
        });
        let (correction, change) = newton.solved(&residual);
        Iterate {
            states,
            residual,
            correction,
            change,
        }
    }

    fn jacobian(&mut self, u: &[f64; N]) -> Jacobian<N> {
        self.work.evaluations += N;
        let mut jacobian = [[0.0; N]; N];
        for j in 0..N {
            let along = core::array::from_fn(|i| Dual {
                value: u[i],
                slope: f64::from(i == j),
            });
            let rates = self.dual.rates(&along);
            for (row, rate) in jacobian.iter_mut().zip(&rates) {
                row[j] = rate.slope;
            }
        }
        jacobian
    }

    fn found(&self, states: &States<N>, h: f64) -> ImplicitStep<N> {
        let start = &self.start;
        let (at_start, at_end) = (
            self.system.scale(start),
            self.system.scale(&states[POINTS - 1]),
        );
        let mut error: f64 = 0.0;
        for i in 0..N {
            // What the highest power contributes bounds what those left out do. Found from the states:
            // the rates of what relaxes fast are differences with few digits.
            let highest: f64 = (0..POINTS)
                .map(|j| self.method.last_of_rises[j] * (states[j][i] - start[i]))
                .sum();
            let size = at_start[i].max(at_end[i]);
            // A component that changes by less than its rounding errors carries no information.
            let weights = self.method.last_of_rises.iter().map(|weight| weight.abs());
            let rounding = f64::EPSILON * start[i].abs() * weights.sum::<f64>();
            let part = if highest.abs() <= rounding {
                0.0
            } else {
                (0.05 * highest / size).abs()
            };
            error = error.max(if part.is_nan() { f64::INFINITY } else { part });
        }
        ImplicitStep {
            dense: self.method.through(h, start, states),
            error: error / self.tolerance,
        }
    }
}

/// The largest sum of a row's sizes.
fn largest_row(matrix: &[Vec<f64>]) -> f64 {
    let sums = matrix.iter().map(|row| row.iter().map(|x| x.abs()).sum());
    sums.fold(0.0, f64::max)
}

fn squared(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let size = matrix.len();
    let entry = |i: usize, j: usize| (0..size).map(|k| matrix[i][k] * matrix[k][j]).sum();
    (0..size)
        .map(|i| (0..size).map(|j| entry(i, j)).collect())
        .collect()
}

/// The components on which some rate depends, by any of these Jacobians.
fn active<const N: usize>(jacobians: &[Jacobian<N>]) -> Vec<usize> {
    let matters = |j: &usize| jacobians.iter().flatten().any(|row| row[*j] != 0.0);
    (0..N).filter(matters).collect()
}

/// The error scales of the components and their rounding errors.
#[derive(Clone, Copy)]
struct Sizes<const N: usize> {
    scales: [f64; N],
    rounding: [f64; N],
}

/// The linear equations of Newton's method, 1 − h (integral ⊗ Jacobian), in factors.
struct Newton<const N: usize> {
    sizes: Sizes<N>,
    /// The components that have equations.
    active: Vec<usize>,
    rows: Vec<Vec<f64>>,
    order: Vec<usize>,
}

impl<const N: usize> Newton<N> {
    /// With the Jacobian at each point. None where the equations are singular or not finite.
    fn new(
        method: &Collocation,
        jacobians: &[Jacobian<N>; POINTS],
        sizes: Sizes<N>,
        h: f64,
    ) -> Option<Self> {
        let scales = sizes.scales;
        let active = active(jacobians);
        let n = active.len();
        let size = n * POINTS;
        let entry = |row: usize, column: usize| {
            let (i, j) = (active[row % n], active[column % n]);
            let (to, from) = (row / n, column / n);
            let slope = jacobians[from][i][j] * scales[j] / scales[i];
            f64::from(row == column) - h * method.integral[to][from] * slope
        };
        let rows = (0..size)
            .map(|row| (0..size).map(|column| entry(row, column)).collect())
            .collect();
        let mut newton = Newton {
            sizes,
            rows,
            order: (0..size).collect(),
            active,
        };
        newton.factor().then_some(newton)
    }

    fn factor(&mut self) -> bool {
        let size = self.rows.len();
        for i in 0..size {
            let pivot = (i..size)
                .max_by(|&a, &b| self.rows[a][i].abs().total_cmp(&self.rows[b][i].abs()))
                .unwrap_or(i);
            if self.rows[pivot][i] == 0.0 || !self.rows[pivot][i].is_finite() {
                return false;
            }
            self.rows.swap(i, pivot);
            self.order.swap(i, pivot);
            let (above, below) = self.rows.split_at_mut(i + 1);
            let top = &above[i];
            for row in below {
                let factor = row[i] / top[i];
                row[i] = factor;
                if factor != 0.0 {
                    for k in i + 1..size {
                        row[k] -= factor * top[k];
                    }
                }
            }
        }
        true
    }

    /// The correction for a residual, and the largest number in it that is no rounding error.
    fn solved(&self, residual: &States<N>) -> (States<N>, f64) {
        let n = self.active.len();
        let size = self.rows.len();
        let right = |&row: &usize| residual[row / n][self.active[row % n]];
        let mut x: Vec<f64> = self.order.iter().map(right).collect();
        for i in 0..size {
            let sum: f64 = (0..i).map(|k| self.rows[i][k] * x[k]).sum();
            x[i] -= sum;
        }
        for i in (0..size).rev() {
            let sum: f64 = (i + 1..size).map(|k| self.rows[i][k] * x[k]).sum();
            x[i] = (x[i] - sum) / self.rows[i][i];
        }
        let mut correction = *residual;
        for (row, &by) in x.iter().enumerate() {
            let component = self.active[row % n];
            // What stays exactly constant, as all across a plane does, is not moved by rounding errors of the others.
            if residual.iter().any(|point| point[component] != 0.0) {
                correction[row / n][component] = by;
            }
        }
        let Sizes { scales, rounding } = self.sizes;
        let mut change: f64 = 0.0;
        for point in &correction {
            for ((by, scale), rounding) in point.iter().zip(&scales).zip(&rounding) {
                change = match by.abs() {
                    size if size.is_nan() => f64::INFINITY,
                    size if size * scale <= *rounding => change,
                    size => change.max(size),
                };
            }
        }
        (correction, change)
    }

    /// The states after this fraction of the correction.
    fn corrected(&self, at: &Iterate<N>, fraction: f64) -> States<N> {
        core::array::from_fn(|k| {
            core::array::from_fn(|i| {
                at.states[k][i] + fraction * at.correction[k][i] * self.sizes.scales[i]
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Implicit, System};
    use crate::real::{Real, Scalar};

    /// x′ = −10⁶ (x − y), y′ = −y: x follows y at once.
    struct Follower;

    impl<T: Real> System<T, 2> for Follower {
        fn rates(&self, u: &[T; 2]) -> [T; 2] {
            [T::from(-1e6) * (u[0] - u[1]), -u[1]]
        }

        fn scale(&self, _: &[T; 2]) -> [T; 2] {
            [T::from(1.0); 2]
        }
    }

    /// A [`Follower`] and the integral of y. This integral may be far larger than its error scale.
    struct Accounted;

    impl<T: Real> System<T, 3> for Accounted {
        fn rates(&self, u: &[T; 3]) -> [T; 3] {
            let [x, y] = Follower.rates(&[u[0], u[1]]);
            [x, y, u[1]]
        }

        fn scale(&self, _: &[T; 3]) -> [T; 3] {
            [T::from(1.0); 3]
        }
    }

    /// A [`Follower`] in a plane: the rate across is zero, but has a derivative.
    struct InPlane;

    impl<T: Scalar> System<T, 3> for InPlane {
        fn rates(&self, u: &[T; 3]) -> [T; 3] {
            let [x, y] = Follower.rates(&[u[0], u[1]]);
            [x, y, u[0] - T::from(u[0].value()) + u[2]]
        }

        fn scale(&self, _: &[T; 3]) -> [T; 3] {
            [T::from(1.0); 3]
        }
    }

    /// x′ = −10³ x³.
    struct Cubic;

    impl<T: Real> System<T, 1> for Cubic {
        fn rates(&self, u: &[T; 1]) -> [T; 1] {
            [T::from(-1e3) * u[0] * u[0] * u[0]]
        }

        fn scale(&self, _: &[T; 1]) -> [T; 1] {
            [T::from(1.0)]
        }
    }

    #[test]
    fn nonlinear_equations_are_solved_to_within_the_error_estimate() {
        const TOLERANCE: f64 = 1e-10;
        for h in [1e-5, 1e-4, 1e-3, 3e-3, 1e-2] {
            let mut implicit = Implicit::new(&Cubic, &Cubic, [1.0], TOLERANCE);
            let step = implicit.attempt(h).expect("it settles");
            let off = (step.dense.end[0] - 1.0 / (1.0 + 2e3 * h).sqrt()).abs();
            // Newton's method stops at 0.02 tolerances.
            let allowed = (step.error + 0.02) * TOLERANCE;
            assert!(off <= allowed, "{off:e} for h = {h:e}, {allowed:e} allowed");
        }
    }

    #[test]
    fn steps_over_what_relaxes_at_once() {
        // The slow solution: x = y/(1 − 10⁻⁶).
        let start = [1.0 / (1.0 - 1e-6), 1.0];
        let mut implicit = Implicit::new(&Follower, &Follower, start, 1e-10);
        let step = implicit.attempt(0.3).expect("it settles");
        assert!(step.error < 1.0);
        let exact = libm::exp(-0.3);
        assert!((step.dense.end[1] - exact).abs() < 1e-13);
        assert!((step.dense.end[0] - exact / (1.0 - 1e-6)).abs() < 1e-12);
    }

    #[test]
    fn what_stays_constant_is_not_moved_by_the_others() {
        let mut implicit = Implicit::new(&InPlane, &InPlane, [2.0, 1.0, 0.0], 1e-10);
        for _ in 0..5 {
            let step = implicit.attempt(1e-6).expect("it settles");
            assert_eq!(step.dense.end[2], 0.0);
            implicit.accept(&step.dense);
        }
    }

    #[test]
    fn rounding_of_a_large_integral_does_not_keep_a_step_from_settling() {
        let exact = 1.0 - libm::exp(-0.3);
        for before in [0.0, 1e3, 1e8, 1e13] {
            let start = [1.0 / (1.0 - 1e-6), 1.0, before];
            let mut implicit = Implicit::new(&Accounted, &Accounted, start, 1e-10);
            let step = implicit.attempt(0.3).expect("it settles");
            assert!(step.error < 1.0);
            let off = (step.dense.end[2] - before - exact).abs();
            assert!(off < 1e-12 + 4.0 * f64::EPSILON * before, "{off:e}");
        }
    }
}
