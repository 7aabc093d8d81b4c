//! Routh's impact in other variables: the slip's speed as ln |u| and its direction as σ with
//! u_x/|u_y| = sinh σ. With ′ = d/dζ = |u| d/dP, c = κa and k = μ (b − a),
//!
//! ```text
//! σ′ = c + k tanh σ,   (ln |u|)′ = c tanh σ − μ (a tanh² σ + b sech² σ).
//! ```
//!
//! These equations are not stiff at any ratio of a and b. The independent variable θ with
//! dζ = (ζ + 1/rate) dθ resolves rates of all orders of magnitude. The velocity v and the work are integrated
//! from the mobilities of Newton's and Euler's equations.

use crate::law::Parameters;
use crate::solve::{Stepper, System};
use crate::state::Coordinates;

/// Mobilities, μ and an upper estimate of the rates.
pub struct Logarithms {
    along: f64,
    across: f64,
    normal: f64,
    coupling: f64,
    friction: f64,
    rate: f64,
    /// m/s.
    speed: f64,
}

const DIRECTION: usize = 0;
const LOG_SPEED: usize = 1;
const VELOCITY: usize = 2;
const WORK: usize = 3;
const ZETA: usize = 4;
type Path = [f64; 5];

/// The motion of the rim's lowest point when the slip has stopped or the phase has ended.
struct End {
    slip: [f64; 2],
    v: f64,
    work: f64,
    /// Whether the phase has ended.
    over: bool,
}

impl Logarithms {
    /// (u_x, u_y, v) after an impact.
    pub fn resolve(
        k: &Parameters<f64>,
        u: &Coordinates<f64>,
        friction: f64,
        restitution: f64,
    ) -> [f64; 3] {
        let (rho, z) = (k.rho(u), k.z(u));
        let slip = libm::hypot(u.slip_x, u.slip_y);
        let mut this = Logarithms {
            along: 1.0 / k.m + z * z / k.a,
            across: 1.0 / k.m + k.r * k.r / k.c + k.h * k.h / k.a,
            normal: 1.0 / k.m + rho * rho / k.a,
            coupling: -rho * z / k.a,
            friction,
            rate: 0.0,
            speed: slip - u.gap_rate,
        };
        this.rate = friction * (this.along + this.across)
            + this.coupling.abs()
            + this.normal * slip / -u.gap_rate;
        let side = u.slip_y.signum();
        let direction = libm::asinh(u.slip_x / u.slip_y.abs());
        let start = [direction, libm::log(slip), u.gap_rate, 0.0, 0.0];
        let (mut path, mut end) = this.follow(start, side, |path| path[VELOCITY]);
        let slips = end.over;
        if !slips {
            end = this.compressed_from_rest(end);
        }
        if restitution > 0.0 {
            let back = end.work * (1.0 - restitution * restitution);
            if slips {
                path[ZETA] = 0.0;
                (_, end) = this.follow(path, side, |path| path[WORK] - back);
            }
            if !(slips && end.over) {
                end = this.restored_from_rest(end, back);
            }
        }
        [end.slip[0], end.slip[1], end.v]
    }

    fn follow(&self, start: Path, side: f64, event: impl Fn(&Path) -> f64) -> (Path, End) {
        let mut stepper = Stepper::new(self, start, 1e-3, 1e-13);
        for _ in 0..100_000 {
            let step = stepper.advance().expect("nothing is stiff");
            let mut path = step.end;
            let over = event(&path) >= 0.0;
            if over {
                let dense = step.dense(self);
                path = dense.at(dense.root(0.0, 1.0, &event));
            }
            let slip = libm::exp(path[LOG_SPEED]);
            if over || slip < 1e-17 * self.speed {
                let [along, across] = [
                    libm::tanh(path[DIRECTION]),
                    side / libm::cosh(path[DIRECTION]),
                ];
                let slip = if over { slip } else { 0.0 };
                let end = End {
                    slip: [slip * along, slip * across],
                    v: path[VELOCITY],
                    work: path[WORK],
                    over,
                };
                return (path, end);
            }
        }
        panic!("no end");
    }

    /// du_x/dP and dv/dP once the slip has stopped.
    fn changes_from_rest(&self) -> (f64, f64) {
        let ratio = (-self.coupling / self.along).clamp(-self.friction, self.friction);
        let sticks = ratio.abs() < self.friction;
        let slipping = self.coupling + self.along * ratio;
        let rising = self.normal + self.coupling * ratio;
        (if sticks { 0.0 } else { slipping }, rising)
    }

    fn compressed_from_rest(&self, end: End) -> End {
        let (slipping, rising) = self.changes_from_rest();
        End {
            slip: [end.slip[0] - slipping * end.v / rising, 0.0],
            v: 0.0,
            work: end.work - 0.5 * end.v * end.v / rising,
            over: true,
        }
    }

    fn restored_from_rest(&self, end: End, back: f64) -> End {
        let (slipping, rising) = self.changes_from_rest();
        let v = (end.v * end.v + 2.0 * rising * (back - end.work)).sqrt();
        End {
            slip: [end.slip[0] + slipping * (v - end.v) / rising, 0.0],
            v,
            work: back,
            over: true,
        }
    }
}

impl System<f64, 5> for Logarithms {
    fn rates(&self, path: &Path) -> Path {
        let (tanh, sech) = (
            libm::tanh(path[DIRECTION]),
            1.0 / libm::cosh(path[DIRECTION]),
        );
        let (friction, slip) = (self.friction, libm::exp(path[LOG_SPEED]));
        let zeta_rate = path[ZETA] + 1.0 / self.rate;
        [
            self.coupling + friction * (self.across - self.along) * tanh,
            self.coupling * tanh
                - friction * (self.along * tanh * tanh + self.across * sech * sech),
            slip * (self.normal - friction * self.coupling * tanh),
            slip * path[VELOCITY],
            1.0,
        ]
        .map(|rate| zeta_rate * rate)
    }

    fn scale(&self, path: &Path) -> Path {
        let work = self.speed * self.speed / self.normal;
        let direction = 1.0 + path[DIRECTION].abs();
        [
            direction,
            1.0,
            self.speed,
            work,
            path[ZETA] + 1.0 / self.rate,
        ]
    }
}
