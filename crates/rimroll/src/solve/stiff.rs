//! One implicit step by [`Collocation`], for parts of a motion that relax too fast for explicit steps:
//! creep, films, and whatever resists the wobble as the base comes down flat.
//!
//! The points are found by Newton's method with the derivatives at the start of the step, taken by
//! differences. Only components that something depends on take part in its linear equations; the others
//! are integrals.
//!
//! Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*, section IV.8.

use super::{Collocation, Dense, POINTS, System};

/// Implicit steps of a system.
pub struct Implicit<'a, S, const N: usize> {
    system: &'a S,
    method: &'static Collocation,
    tolerance: f64,
}

/// A finished step.
pub struct Found<const N: usize> {
    /// The step.
    pub dense: Dense<f64, N>,
    /// Its error over what is tolerated: the step is good when this is ≤ 1.
    pub error: f64,
}

/// Derivatives of the rates by the components that matter, each in units of its size.
struct Slopes<const N: usize> {
    /// Which components matter.
    active: Vec<usize>,
    scales: [f64; N],
    /// `of[a][b]`: of the rate of active component a by active component b.
    of: Vec<Vec<f64>>,
}

type States<const N: usize> = [[f64; N]; POINTS];

impl<'a, S: System<f64, N>, const N: usize> Implicit<'a, S, N> {
    /// Steps whose errors are held below a tolerance.
    pub fn new(system: &'a S, tolerance: f64) -> Self {
        Implicit {
            system,
            method: Collocation::get(),
            tolerance,
        }
    }

    /// How fast the fastest part relaxes at `u`: the size of the largest eigenvalue of the derivatives,
    /// from their eighth power. Sums of the derivatives themselves may be far larger where the
    /// components' sizes differ much.
    pub fn relaxation(&self, u: &[f64; N]) -> f64 {
        let mut power = self.slopes(u).of;
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
    pub fn step(&self, start: &[f64; N], h: f64) -> Option<Found<N>> {
        const MAX_ROUNDS: usize = 30;
        // So far from the start the equations may have another solution.
        const FARTHEST: f64 = 10.0;
        let slopes = self.slopes(start);
        let newton = Newton::new(self.method, &slopes, h)?;
        let mut states = [*start; POINTS];
        let mut last_change = f64::INFINITY;
        for round in 0..MAX_ROUNDS {
            let rates = states.map(|state| self.system.rates(&state));
            let wanted = self.integrated(start, &rates, h);
            let change = newton.correct(&slopes, &wanted, &mut states);
            if change <= 0.02 * self.tolerance {
                return Some(self.found(start, &states, h));
            }
            if change > FARTHEST {
                return None;
            }
            // Rounding keeps the last changes from getting smaller. Written so that a NaN ends it.
            let shrinks = change <= 0.8 * last_change;
            if round > 4 && !shrinks {
                let settled = change <= 4.0 * self.tolerance;
                return settled.then(|| self.found(start, &states, h));
            }
            last_change = change;
        }
        None
    }

    fn slopes(&self, u: &[f64; N]) -> Slopes<N> {
        const NUDGE: f64 = 1e-7;
        // What is held close to zero by something that is not smooth there, as drag with an exponent
        // below 2 holds the yaw rate, changes on the scale of its own value, not of its size.
        const SMALLEST: f64 = 1e-9;
        let scales = self.system.scale(u);
        let rates = self.system.rates(u);
        let columns: Vec<[f64; N]> = (0..N)
            .map(|j| {
                let mut beside = *u;
                beside[j] += NUDGE * u[j].abs().clamp(SMALLEST * scales[j], scales[j]);
                let nudge = (beside[j] - u[j]) / scales[j];
                let there = self.system.rates(&beside);
                core::array::from_fn(|i| {
                    if nudge == 0.0 {
                        0.0
                    } else {
                        (there[i] - rates[i]) / (nudge * scales[i])
                    }
                })
            })
            .collect();
        let matters = |j: &usize| columns[*j].iter().any(|&x| x != 0.0);
        let active: Vec<usize> = (0..columns.len()).filter(matters).collect();
        let row = |&i: &usize| active.iter().map(|&j| columns[j][i]).collect();
        Slopes {
            of: active.iter().map(row).collect(),
            scales,
            active,
        }
    }

    /// The states at the points, as the rates there have it.
    fn integrated(&self, start: &[f64; N], rates: &States<N>, h: f64) -> States<N> {
        self.method.integral.map(|row| {
            core::array::from_fn(|i| {
                let sum: f64 = (0..POINTS).map(|j| row[j] * rates[j][i]).sum();
                start[i] + h * sum
            })
        })
    }

    fn found(&self, start: &[f64; N], states: &States<N>, h: f64) -> Found<N> {
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
            let part = (0.05 * highest / size).abs();
            error = error.max(if part.is_nan() { f64::INFINITY } else { part });
        }
        Found {
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

/// The linear equations of Newton's method, 1 − h (integral ⊗ slopes), in factors.
struct Newton {
    rows: Vec<Vec<f64>>,
    order: Vec<usize>,
}

impl Newton {
    /// None where the equations are singular or not finite.
    fn new<const N: usize>(method: &Collocation, slopes: &Slopes<N>, h: f64) -> Option<Newton> {
        let n = slopes.active.len();
        let size = n * POINTS;
        let entry = |row: usize, column: usize| {
            let coupled = h * method.integral[row / n][column / n] * slopes.of[row % n][column % n];
            f64::from(row == column) - coupled
        };
        let rows = (0..size)
            .map(|row| (0..size).map(|column| entry(row, column)).collect())
            .collect();
        let mut newton = Newton {
            rows,
            order: (0..size).collect(),
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

    fn solved(&self, right: &[f64]) -> Vec<f64> {
        let size = right.len();
        let mut x: Vec<f64> = self.order.iter().map(|&row| right[row]).collect();
        for i in 0..size {
            let sum: f64 = (0..i).map(|k| self.rows[i][k] * x[k]).sum();
            x[i] -= sum;
        }
        for i in (0..size).rev() {
            let sum: f64 = (i + 1..size).map(|k| self.rows[i][k] * x[k]).sum();
            x[i] = (x[i] - sum) / self.rows[i][i];
        }
        x
    }

    /// Moves the states toward the solution; the largest change, each component by its size.
    fn correct<const N: usize>(
        &self,
        slopes: &Slopes<N>,
        wanted: &States<N>,
        states: &mut States<N>,
    ) -> f64 {
        let Slopes { active, scales, .. } = slopes;
        let n = active.len();
        let lacking = |row: usize| {
            let i = active[row % n];
            (wanted[row / n][i] - states[row / n][i]) / scales[i]
        };
        let right: Vec<f64> = (0..n * POINTS).map(lacking).collect();
        let corrections = self.solved(&right);
        let mut change: f64 = 0.0;
        for (j, state) in states.iter_mut().enumerate() {
            for i in 0..N {
                let by = match active.iter().position(|&a| a == i) {
                    Some(a) => corrections[j * n + a],
                    None => (wanted[j][i] - state[i]) / scales[i],
                };
                state[i] += by * scales[i];
                change = change.max(if by.is_nan() { f64::INFINITY } else { by.abs() });
            }
        }
        change
    }
}

#[cfg(test)]
mod tests {
    use super::{Implicit, System};

    /// x′ = −10⁶ (x − y), y′ = −y: x follows y at once.
    struct Follower;

    impl System<f64, 2> for Follower {
        fn rates(&self, u: &[f64; 2]) -> [f64; 2] {
            [-1e6 * (u[0] - u[1]), -u[1]]
        }

        fn scale(&self, _: &[f64; 2]) -> [f64; 2] {
            [1.0, 1.0]
        }
    }

    #[test]
    fn steps_over_what_relaxes_at_once() {
        let implicit = Implicit::new(&Follower, 1e-10);
        // The slow solution: x = y/(1 − 10⁻⁶).
        let start = [1.0 / (1.0 - 1e-6), 1.0];
        let step = implicit.step(&start, 0.3).expect("it settles");
        assert!(step.error < 1.0);
        let exact = libm::exp(-0.3);
        assert!((step.dense.end[1] - exact).abs() < 1e-13);
        assert!((step.dense.end[0] - exact / (1.0 - 1e-6)).abs() < 1e-12);
    }
}
