#[path = "../../tests/integration/given/cases.rs"]
mod cases;

use super::resolve;
use crate::law::Parameters;
use crate::solve::{Stepper, System};
use crate::state::Coordinates;
use cases::cases;
use proptest::prelude::*;

/// The kinetic energy, J, from the velocity of the centre of mass and the angular velocity.
fn kinetic(k: &Parameters<f64>, u: &Coordinates<f64>) -> f64 {
    let [rolling_x, rolling_y] = k.rolling_velocity(u);
    let (vx, vy) = (rolling_x + u.slip_x, rolling_y + u.slip_y);
    let vz = k.rho(u) * u.p + u.gap_rate;
    let translation = k.m * (vx * vx + vy * vy + vz * vz);
    0.5 * (translation + k.a * (u.p * u.p + u.w * u.w) + k.c * u.s * u.s)
}

/// The speed of the centre of mass if all its terms had the same sign, m/s. The coordinates carry the
/// velocity as a sum of these terms, so its rounding error is relative to this speed.
fn sum_of_speeds(k: &Parameters<f64>, u: &Coordinates<f64>) -> f64 {
    let vx = (k.z(u) * u.p).abs() + u.slip_x.abs();
    let vy = (k.r * u.s).abs() + (k.h * u.w).abs() + u.slip_y.abs();
    let vz = (k.rho(u) * u.p).abs() + u.gap_rate.abs();
    (vx * vx + vy * vy + vz * vz).sqrt()
}

/// A body of mass 1 on a rim of radius 1.
fn mild_parameters() -> impl Strategy<Value = Parameters<f64>> {
    let height = prop_oneof![1 => Just(0.0), 4 => 0.05..5.0];
    (height, 0.05..5.0, 0.05..2.0).prop_map(|(h, a, ratio)| parameters(h, a, ratio * a))
}

/// Parameters from needles to plates, with the mass at the axis or far from it: b/a is up to 10⁹.
fn wild_parameters() -> impl Strategy<Value = Parameters<f64>> {
    let power = |low: f64, high: f64| (low..high).prop_map(|x| libm::pow(10.0, x));
    let height = prop_oneof![1 => Just(0.0), 4 => power(-3.0, 3.0)];
    let axial = prop_oneof![1 => Just(2.0), 4 => power(-9.0, 0.3)];
    (height, power(-6.0, 3.0), axial).prop_map(|(h, a, ratio)| parameters(h, a, ratio * a))
}

fn any_parameters() -> impl Strategy<Value = Parameters<f64>> {
    prop_oneof![mild_parameters(), wild_parameters()]
}

fn parameters(h: f64, a: f64, c: f64) -> Parameters<f64> {
    Parameters {
        m: 1.0,
        r: 1.0,
        h,
        a,
        c,
        g: 9.8,
    }
}

/// A state just before impact, at any tilt and with any rates, with slips of all orders of magnitude.
fn any_strike() -> impl Strategy<Value = Coordinates<f64>> {
    let size = (-12.0..2.0).prop_map(|x| libm::pow(10.0, x));
    let slip = prop_oneof![1 => Just(0.0), 6 => size];
    let rate = || -5.0..5.0;
    (
        1e-6..3.1,
        rate(),
        rate(),
        rate(),
        slip,
        -4.0..4.0,
        1e-6..10.0,
    )
        .prop_map(
            |(tilt, p, w, s, slip, direction, v): (f64, _, _, _, f64, _, f64)| {
                let (sin, cos) = libm::sincos(tilt);
                let (across, along) = libm::sincos(direction);
                Coordinates {
                    sin,
                    cos,
                    p,
                    w,
                    s,
                    slip_x: slip * along,
                    slip_y: slip * across,
                    gap_rate: -v,
                    ..Coordinates::zero()
                }
            },
        )
}

fn any_friction() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 4 => 0.0..3.0]
}

fn any_restitution() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 1 => Just(1.0), 3 => 0.0..1.0]
}

fn resolved(
    k: &Parameters<f64>,
    u: &Coordinates<f64>,
    friction: f64,
    restitution: f64,
) -> Coordinates<f64> {
    resolve(k, u, friction, restitution, 0.0).expect("the slip is followed to the end")
}

/// The impulses along e_x1, e_y1 and upward, from the change of momentum.
fn impulse(k: &Parameters<f64>, u: &Coordinates<f64>, after: &Coordinates<f64>) -> [f64; 3] {
    let velocity = |u: &Coordinates<f64>| {
        let [x, y] = k.rolling_velocity(u);
        [x + u.slip_x, y + u.slip_y, k.rho(u) * u.p + u.gap_rate]
    };
    let (before, after) = (velocity(u), velocity(after));
    core::array::from_fn(|i| k.m * (after[i] - before[i]))
}

proptest! {
    #![proptest_config(cases(2000))]

    /// The energy balance is exact, so the tolerance allows only for the rounding of the energy and of the
    /// velocity of the centre of mass, which the coordinates carry as a sum.
    #[test]
    fn no_impact_gains_energy_pulls_or_leaves_the_friction_cone(
        k in any_parameters(),
        u in any_strike(),
        friction in any_friction(),
        restitution in any_restitution(),
    ) {
        let after = resolved(&k, &u, friction, restitution);
        let energy = kinetic(&k, &u);
        let parts = sum_of_speeds(&k, &u) + sum_of_speeds(&k, &after);
        let allowed = 1e-12 * energy + 1e-14 * parts * (k.m * energy).sqrt();
        prop_assert!(after.impact_loss >= -allowed, "{:e}", after.impact_loss / energy);
        let jump = kinetic(&k, &after) + after.impact_loss - energy;
        prop_assert!(jump.abs() <= allowed, "{:e}", jump / energy);
        prop_assert!(after.gap_rate >= 0.0);
        let [px, py, pn] = impulse(&k, &u, &after);
        let rounding = 1e-14 * k.m * parts;
        prop_assert!(pn > -rounding);
        let excess = libm::hypot(px, py) - friction * pn;
        prop_assert!(excess <= (1.0 + friction) * rounding, "{px} {py} {pn}");
        if restitution == 0.0 {
            prop_assert_eq!(after.gap_rate, 0.0);
        }
        if friction == 0.0 {
            // Only v changes, to −e v.
            let v = -restitution * u.gap_rate;
            prop_assert!((after.gap_rate - v).abs() < 1e-11 * (u.gap_rate.abs() + u.slip_x.abs()));
            prop_assert_eq!((after.w, after.s), (u.w, u.s));
        }
    }

    /// The final slip equals that computed in logarithmic variables, which are not stiff at any ratio of
    /// the mobilities.
    #[test]
    fn impacts_agree_with_those_in_logarithmic_variables(
        k in any_parameters(),
        u in any_strike(),
        friction in 1e-3..3.0,
        restitution in any_restitution(),
    ) {
        prop_assume!(u.slip_y != 0.0);
        let after = resolved(&k, &u, friction, restitution);
        let by_logarithms = Logarithms::resolve(&k, &u, friction, restitution);
        let found = [after.slip_x, after.slip_y, after.gap_rate];
        let speed = u.slip_speed() - u.gap_rate;
        for (found, expected) in found.into_iter().zip(by_logarithms) {
            let off = (found - expected).abs() / speed;
            prop_assert!(off <= 1e-9, "{off:e}: {after:?} {by_logarithms:?}");
        }
    }

    /// Routh's three cases of a plane impact without rebound: the slip persists, stops for good, or
    /// reverses (W. J. Stronge, Impact Mechanics, 2000, section 3.4).
    #[test]
    fn plane_impacts_are_rouths(
        k in mild_parameters(),
        u in any_strike(),
        friction in 0.0..3.0_f64,
    ) {
        let u = Coordinates { w: 0.0, s: 0.0, slip_y: 0.0, ..u };
        let (rho, z) = (k.rho(&u), k.z(&u));
        let (along, normal, coupling) =
            (1.0 / k.m + z * z / k.a, 1.0 / k.m + rho * rho / k.a, -rho * z / k.a);
        // While dP_x = ratio dP, u_x changes by slip_change(ratio) P and v by v_change(ratio) P.
        let slip_change = |ratio: f64| coupling + along * ratio;
        let v_change = |ratio: f64| normal + coupling * ratio;
        let ratio = if u.slip_x == 0.0 { 0.0 } else { -friction * u.slip_x.signum() };
        let to_stop = -u.slip_x / slip_change(ratio);
        let to_compress = -u.gap_rate / v_change(ratio);
        // Where friction alone sustains the compression (Painlevé), compression ends only after the slip.
        let lasts = u.slip_x != 0.0
            && v_change(ratio) > 0.0
            && (to_stop <= 0.0 || to_stop >= to_compress);
        let (px, pn, slip) = if lasts {
            (ratio * to_compress, to_compress, u.slip_x + slip_change(ratio) * to_compress)
        } else {
            let first = if u.slip_x == 0.0 { 0.0 } else { to_stop };
            let later_ratio = (-coupling / along).clamp(-friction, friction);
            let second = (-u.gap_rate - v_change(ratio) * first) / v_change(later_ratio);
            (
                ratio * first + later_ratio * second,
                first + second,
                slip_change(later_ratio) * second,
            )
        };
        let after = resolved(&k, &u, friction, 0.0);
        let [got_x, _, got_n] = impulse(&k, &u, &after);
        let size = 1e-9 * (1.0 + pn + u.slip_x.abs());
        prop_assert!((got_x - px).abs() < size && (got_n - pn).abs() < size, "{got_x} {px}, {got_n} {pn}");
        prop_assert!((after.slip_x - slip).abs() < size * (1.0 + along), "{} {slip}", after.slip_x);
        prop_assert_eq!((after.w, after.s, after.slip_y), (0.0, 0.0, 0.0));
    }
}

/// The rim strikes without slip, and the friction is smaller by a factor 1 − 10⁻⁴ than what would keep it
/// from slipping. The slip grows so slowly that it stays comparable with rounding errors for a long time.
#[test]
fn a_slip_that_friction_nearly_prevents_is_followed_to_the_end() {
    let k = Parameters {
        m: 1.0,
        r: 1.0,
        h: 2.0,
        a: 0.85,
        c: 0.04,
        g: 9.8,
    };
    let (sin, cos) = (0.96, -0.28);
    for [slip_x, slip_y] in [[0.0, 0.0], [1e-9, 0.0], [1e-9, 1e-10]] {
        let u = Coordinates {
            sin,
            cos,
            slip_x,
            slip_y,
            gap_rate: -1e-6,
            ..Coordinates::zero()
        };
        let (rho, z) = (k.rho(&u), k.z(&u));
        let holding = (rho * z / k.a).abs() / (1.0 / k.m + z * z / k.a);
        let friction = holding * (1.0 - 1e-4);
        let after = resolved(&k, &u, friction, 1.0);
        let [px, py, pn] = impulse(&k, &u, &after);
        assert!((libm::hypot(px, py) - friction * pn).abs() < 1e-3 * slip_y + 1e-16);
        assert!(after.slip_x > slip_x);
    }
}

/// Routh's impact in other variables: the slip's speed as ln |u| and its direction as σ with
/// u_x/|u_y| = sinh σ. With ′ = d/dζ = |u| d/dP, c = κa and k = μ (b − a),
///
/// ```text
/// σ′ = c + k tanh σ,   (ln |u|)′ = c tanh σ − μ (a tanh² σ + b sech² σ).
/// ```
///
/// These equations are not stiff at any ratio of a and b. The independent variable θ with
/// dζ = (ζ + 1/rate) dθ resolves rates of all orders of magnitude. The velocity v and the work are integrated
/// from the mobilities of Newton's and Euler's equations. `rate` is an upper estimate of the rates.
struct Logarithms {
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
    fn resolve(
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
