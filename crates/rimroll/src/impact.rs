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
    if now.v <= rest {
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
        let slipping = now.slip != [0.0; 2];
        if !(slipping && self.slide(now, friction, until)) {
            self.go_on(now, friction, until);
        }
    }

    /// Follows a slip in two dimensions; true when the part is over before the slip is.
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

impl System<8> for SlidingImpact<'_> {
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
