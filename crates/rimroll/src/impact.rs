//! Landing: the impulse of the table on a rim that strikes it.
//!
//! Routh's incremental method with Coulomb friction. As the normal impulse P grows from zero, the
//! velocity (u_x, u_y, v_n) of the rim's lowest point changes by the contact's mobility,
//!
//! ```text
//! du_x = (1/m + z²/A) dP_x − (ρz/A) dP,   du_y = (1/m + R²/C + H²/A) dP_y,
//! dv_n = (1/m + ρ²/A) dP − (ρz/A) dP_x,
//! ```
//!
//! and while it slips the friction is (dP_x, dP_y) = −μ (u_x, u_y)/|u| dP. Where slip stops it stays
//! stopped if |dP_x| ≤ μ dP holds it, else it goes on along e_x1. Compression ends at v_n = 0, and
//! restitution when the part e² of the work of compression is given back, so that no landing can gain
//! energy. Source: W. J. Stronge, *Impact Mechanics* (2000), chapters 3 to 5.
//!
//! The direction of slip turns infinitely fast as slip ends; on the clock ζ with dP = |u| dζ it does
//! not, and the equations are smooth.

use crate::law::Parameters;
use crate::solve::{Stepper, System};
use crate::state::Coordinates;

/// How the rim's lowest point answers impulses at it.
struct Mobility {
    along: f64,
    across: f64,
    normal: f64,
    /// Of u_x to P, and of v_n to P_x.
    coupling: f64,
}

/// What has happened so far.
#[derive(Clone, Copy)]
struct Striking {
    slip: [f64; 2],
    v: f64,
    impulse: [f64; 3],
    /// Of the normal impulse.
    work: f64,
    /// Of friction.
    friction_work: f64,
}

/// What ends the present part of an impact.
#[derive(Clone, Copy)]
enum Until {
    /// v_n = 0.
    Compressed,
    /// The work has come back up to this, J.
    Restored(f64),
}

impl Until {
    /// Negative before, zero at the end.
    fn level(self, now: &Striking) -> f64 {
        match self {
            Until::Compressed => now.v,
            Until::Restored(work) => now.work - work,
        }
    }
}

/// The coordinates after a body at `u` has struck the table, whose coefficients of friction and
/// restitution are given. A rebound slower than `rest` (m/s) is none. The energy lost is put on its
/// account.
pub(crate) fn land(
    k: &Parameters<f64>,
    u: &Coordinates<f64>,
    friction: f64,
    restitution: f64,
    rest: f64,
) -> Coordinates<f64> {
    let (rho, z) = (k.rho(u), k.z(u));
    let mobility = Mobility {
        along: 1.0 / k.m + z * z / k.a,
        across: k.sideways_mobility(),
        normal: 1.0 / k.m + rho * rho / k.a,
        coupling: -rho * z / k.a,
    };
    let mut now = Striking {
        slip: [u.slip_x, u.slip_y],
        v: u.gap_rate,
        impulse: [0.0; 3],
        work: 0.0,
        friction_work: 0.0,
    };
    mobility.press(&mut now, friction, Until::Compressed);
    let compressed = now;
    if restitution > 0.0 {
        let back = now.work * (1.0 - restitution * restitution);
        mobility.press(&mut now, friction, Until::Restored(back));
    }
    if restitution == 0.0 || now.v <= rest {
        now = Striking {
            v: 0.0,
            ..compressed
        };
    }
    let [px, py, pn] = now.impulse;
    let mut after = *u;
    after.p += (px * z - pn * rho) / k.a;
    after.w += k.h * py / k.a;
    after.s -= k.r * py / k.c;
    [after.slip_x, after.slip_y] = now.slip;
    after.gap = 0.0;
    after.gap_rate = now.v;
    after.impact_loss -= now.work + now.friction_work;
    after
}

impl Mobility {
    fn press(&self, now: &mut Striking, friction: f64, until: Until) {
        if until.level(now) >= 0.0 {
            return;
        }
        let turning = now.slip != [0.0; 2] && !self.slips_on(now, friction);
        if !(turning && self.slide(now, friction, until)) {
            self.go_on(now, friction, until);
        }
    }

    /// Whether the slip is along e_x1, but for rounding, and friction too weak to stop it: it may grow so
    /// slowly that no number of steps would see its end.
    fn slips_on(&self, now: &Striking, friction: f64) -> bool {
        let [ux, uy] = now.slip;
        uy.abs() <= 1e-15 * ux.abs()
            && ux * self.coupling > 0.0
            && self.coupling.abs() > friction * self.along
    }

    /// Follows a slip in two dimensions until it stops or keeps one direction; true when the part is over
    /// before that.
    fn slide(&self, now: &mut Striking, friction: f64, until: Until) -> bool {
        let sliding = SlidingImpact {
            mobility: self,
            friction,
            speed: libm::hypot(now.slip[0], now.slip[1]) + now.v.abs(),
        };
        let rate = friction * (self.along + self.across) + self.coupling.abs() + self.normal;
        let stopped = 1e-14 * sliding.speed;
        let mut stepper = Stepper::new(&sliding, now.as_array(), 0.01 / rate, 1e-14);
        // Slip decays like e^−ζ or faster: some hundred steps at most.
        for _ in 0..10_000 {
            let Ok(step) = stepper.advance() else { break };
            let dense = step.dense(&sliding);
            let end = Striking::from_array(&dense.end);
            if until.level(&end) >= 0.0 {
                let x = dense.root(0.0, 1.0, |a| until.level(&Striking::from_array(a)));
                *now = Striking::from_array(&dense.at(x));
                return true;
            }
            *now = end;
            if self.slips_on(now, friction) {
                return false;
            }
            if libm::hypot(now.slip[0], now.slip[1]) <= stopped {
                break;
            }
        }
        now.slip = [0.0; 2];
        false
    }

    /// From where slip has stopped, or from a slip along e_x1 only: everything is linear in P.
    fn go_on(&self, now: &mut Striking, friction: f64, until: Until) {
        let holding = -self.coupling / self.along;
        let pull = holding.clamp(-friction, friction);
        let rising = self.normal + self.coupling * pull;
        let slip = self.coupling + self.along * pull;
        // v² grows by 2 · rising · work.
        let v = match until {
            Until::Compressed => 0.0,
            Until::Restored(work) => (now.v * now.v + 2.0 * rising * (work - now.work))
                .max(0.0)
                .sqrt(),
        };
        let impulse = (v - now.v) / rising;
        now.work += 0.5 * (v + now.v) * impulse;
        now.impulse[0] += pull * impulse;
        now.impulse[2] += impulse;
        now.v = v;
        if pull != holding {
            now.friction_work += pull * impulse * (now.slip[0] + 0.5 * slip * impulse);
            now.slip[0] += slip * impulse;
        }
    }
}

impl Striking {
    fn as_array(&self) -> [f64; 8] {
        let [ux, uy] = self.slip;
        let [px, py, pn] = self.impulse;
        [ux, uy, self.v, px, py, pn, self.work, self.friction_work]
    }

    fn from_array(a: &[f64; 8]) -> Self {
        Striking {
            slip: [a[0], a[1]],
            v: a[2],
            impulse: [a[3], a[4], a[5]],
            work: a[6],
            friction_work: a[7],
        }
    }
}

/// The slip, the impulses and the work on the clock ζ.
struct SlidingImpact<'a> {
    mobility: &'a Mobility,
    friction: f64,
    /// A speed to compare errors with.
    speed: f64,
}

impl System<f64, 8> for SlidingImpact<'_> {
    fn rates(&self, a: &[f64; 8]) -> [f64; 8] {
        let Mobility {
            along,
            across,
            normal,
            coupling,
        } = *self.mobility;
        let [ux, uy, v, ..] = *a;
        let (px, py, pn) = (
            -self.friction * ux,
            -self.friction * uy,
            (ux * ux + uy * uy).sqrt(),
        );
        [
            along * px + coupling * pn,
            across * py,
            normal * pn + coupling * px,
            px,
            py,
            pn,
            v * pn,
            ux * px + uy * py,
        ]
    }

    fn scale(&self, a: &[f64; 8]) -> [f64; 8] {
        let slip = (a[0] * a[0] + a[1] * a[1]).sqrt();
        let speed = self.speed;
        let impulse = speed / self.mobility.normal;
        [
            slip,
            slip,
            speed,
            impulse,
            impulse,
            impulse,
            speed * impulse,
            speed * impulse,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::land;
    use crate::law::Parameters;
    use crate::state::Coordinates;
    use proptest::prelude::*;

    /// J, from the velocities of the centre of mass and the angular velocity.
    fn kinetic(k: &Parameters<f64>, u: &Coordinates<f64>) -> f64 {
        let [rolling_x, rolling_y] = k.rolling_velocity(u);
        let (vx, vy) = (rolling_x + u.slip_x, rolling_y + u.slip_y);
        let vz = k.rho(u) * u.p + u.gap_rate;
        let translation = k.m * (vx * vx + vy * vy + vz * vz);
        0.5 * (translation + k.a * (u.p * u.p + u.w * u.w) + k.c * u.s * u.s)
    }

    /// A body of mass 1 on a rim of radius 1.
    fn any_parameters() -> impl Strategy<Value = Parameters<f64>> {
        let height = prop_oneof![1 => Just(0.0), 4 => 0.05..5.0];
        (height, 0.05..5.0, 0.05..2.0).prop_map(|(h, a, ratio)| Parameters {
            m: 1.0,
            r: 1.0,
            h,
            a,
            c: ratio * a,
            g: 9.8,
        })
    }

    /// About to strike the table, at any tilt and in any motion, with slips of all sizes.
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

    /// The impulses along e_x1, e_y1 and upward, from the momentum that the body has gained.
    fn impulse(k: &Parameters<f64>, u: &Coordinates<f64>, after: &Coordinates<f64>) -> [f64; 3] {
        let velocity = |u: &Coordinates<f64>| {
            let [x, y] = k.rolling_velocity(u);
            [x + u.slip_x, y + u.slip_y, k.rho(u) * u.p + u.gap_rate]
        };
        let (before, after) = (velocity(u), velocity(after));
        core::array::from_fn(|i| k.m * (after[i] - before[i]))
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_landing_gains_energy_pulls_or_leaves_the_friction_cone(
            k in any_parameters(),
            u in any_strike(),
            friction in prop_oneof![1 => Just(0.0), 4 => 0.0..3.0],
            restitution in prop_oneof![1 => Just(0.0), 1 => Just(1.0), 3 => 0.0..1.0],
        ) {
            let after = land(&k, &u, friction, restitution, 0.0);
            let energy = kinetic(&k, &u);
            prop_assert!(after.impact_loss >= -1e-12 * energy, "{:e}", after.impact_loss / energy);
            prop_assert!(after.gap_rate >= 0.0);
            let [px, py, pn] = impulse(&k, &u, &after);
            let rounding = 1e-11 * energy.sqrt();
            prop_assert!(pn > -rounding);
            prop_assert!(libm::hypot(px, py) <= friction * pn + rounding, "{px} {py} {pn}");
            if restitution == 0.0 {
                prop_assert_eq!(after.gap_rate, 0.0);
            }
            if friction == 0.0 {
                // Only v_n changes, to −e v_n.
                prop_assert!((after.gap_rate + restitution * u.gap_rate).abs() < 1e-11 * (1.0 + energy.sqrt()));
                prop_assert_eq!((after.w, after.s), (u.w, u.s));
            }
        }

        /// Routh's three cases of a plane landing without rebound: the slip lasts, stops and stays
        /// stopped, or is reversed (W. J. Stronge, Impact Mechanics, 2000, section 3.4).
        #[test]
        fn plane_landings_are_rouths(
            k in any_parameters(),
            u in any_strike(),
            friction in 0.0..3.0_f64,
        ) {
            let u = Coordinates { w: 0.0, s: 0.0, slip_y: 0.0, ..u };
            let (rho, z) = (k.rho(&u), k.z(&u));
            let (along, normal, coupling) =
                (1.0 / k.m + z * z / k.a, 1.0 / k.m + rho * rho / k.a, -rho * z / k.a);
            // While dP_x = pull dP, u_x changes by `slipping` P and v_n by `rising` P.
            let slipping = |pull: f64| coupling + along * pull;
            let rising = |pull: f64| normal + coupling * pull;
            let pull = if u.slip_x == 0.0 { 0.0 } else { -friction * u.slip_x.signum() };
            let to_stop = -u.slip_x / slipping(pull);
            let to_press = -u.gap_rate / rising(pull);
            // Where friction alone keeps pressing (Painlevé) the first slip has to stop.
            let lasts = u.slip_x != 0.0
                && rising(pull) > 0.0
                && (to_stop <= 0.0 || to_stop >= to_press);
            let (px, pn, slip) = if lasts {
                (pull * to_press, to_press, u.slip_x + slipping(pull) * to_press)
            } else {
                let first = if u.slip_x == 0.0 { 0.0 } else { to_stop };
                let then = (-coupling / along).clamp(-friction, friction);
                let second = (-u.gap_rate - rising(pull) * first) / rising(then);
                (pull * first + then * second, first + second, slipping(then) * second)
            };
            let after = land(&k, &u, friction, 0.0, 0.0);
            let [got_x, _, got_n] = impulse(&k, &u, &after);
            let size = 1e-9 * (1.0 + pn + u.slip_x.abs());
            prop_assert!((got_x - px).abs() < size && (got_n - pn).abs() < size, "{got_x} {px}, {got_n} {pn}");
            prop_assert!((after.slip_x - slip).abs() < size * (1.0 + along), "{} {slip}", after.slip_x);
            prop_assert_eq!((after.w, after.s, after.slip_y), (0.0, 0.0, 0.0));
        }
    }

    /// A rim that comes down without slip on a table whose friction falls short of what would hold it by a
    /// ten-thousandth: the slip grows so slowly that it is as small as rounding for long.
    #[test]
    fn a_slip_that_friction_all_but_holds_is_followed_to_the_end() {
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
            let after = land(&k, &u, friction, 1.0, 0.0);
            let [px, py, pn] = impulse(&k, &u, &after);
            assert!((libm::hypot(px, py) - friction * pn).abs() < 1e-3 * slip_y + 1e-16);
            assert!(after.slip_x > slip_x);
        }
    }
}
