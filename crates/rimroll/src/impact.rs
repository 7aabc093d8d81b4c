//! Landing: the impulse of the table on a rim that strikes it.
//!
//! Routh's incremental method with Coulomb friction. As the normal impulse P grows from zero, the
//! velocity (u_x, u_y, v) of the rim's lowest point changes by
//!
//! ```text
//! du_x = a (dP_x + κ dP),   du_y = b dP_y,   dv = d dP + κ du_x,
//!
//! a = 1/m + z²/A,   b = 1/m + R²/C + H²/A,   κ = −mρz/(A + mz²),   d = 1/m + ρ²/(A + mz²),
//! ```
//!
//! and while it slips the friction is (dP_x, dP_y) = −μ (u_x, u_y)/|u| dP. Where slip stops it stays
//! stopped if |dP_x| ≤ μ dP holds it, else it goes on along e_x1. Compression ends at v = 0, and
//! restitution when the part e² of the work of compression is given back, so that no landing can gain
//! energy. Source: W. J. Stronge, *Impact Mechanics* (2000), chapters 3 to 5.
//!
//! The impulses of friction, the change of the body's motion and the energy lost all follow from P and
//! from the change of (u_x, u_y): a slip cannot end without the impulse that ends it.
//!
//! The direction of slip turns infinitely fast as slip ends; on the clock ζ with dP = |u| dζ it does
//! not, and the equations are smooth. There u_y decays as exp(−μbζ), whatever else happens, so explicit
//! steps follow the slip until it has stopped or has turned into e_x1. That takes some 70/(μb) at most,
//! which are a few hundred steps for every body: the rates are a few times μb, or the slip turns as much
//! sooner. From there on everything is linear in P, however many times slower than u_y the slip u_x decays.

use crate::law::Parameters;
use crate::solve::{Stepper, System};
use crate::state::Coordinates;
use core::ops::ControlFlow;

/// How the rim's lowest point answers impulses at it.
#[derive(Debug, Clone, Copy)]
struct Mobility {
    /// a, 1/kg.
    along: f64,
    /// b, 1/kg.
    across: f64,
    /// d, of v while u_x is held, 1/kg.
    held: f64,
    /// κ. An impulse −κ along e_x1 holds u_x against a normal impulse of 1.
    carry: f64,
}

/// What has happened so far.
#[derive(Debug, Clone, Copy)]
struct Striking {
    slip: [f64; 2],
    /// P, N s.
    pressed: f64,
    /// The work done by the normal impulse, J.
    work: f64,
}

/// What ends the present part of an impact.
#[derive(Debug, Clone, Copy)]
enum Until {
    /// v = 0.
    Compressed,
    /// The work has come back up to this, J.
    Restored(f64),
}

/// A landing: where it began, and what governs it.
struct Impact {
    mobility: Mobility,
    friction: f64,
    /// The slip at its beginning, m/s.
    slip: [f64; 2],
    /// v at its beginning, negative.
    approach: f64,
}

/// The coordinates after a body at `u` has struck the table, whose coefficients of friction and
/// restitution are given. A rebound slower than `rest` (m/s) is none. The energy lost is put on its
/// account. None where the slip cannot be followed to the end.
pub(crate) fn land(
    k: &Parameters<f64>,
    u: &Coordinates<f64>,
    friction: f64,
    restitution: f64,
    rest: f64,
) -> Option<Coordinates<f64>> {
    let impact = Impact {
        mobility: Mobility::new(k, u),
        friction,
        slip: [u.slip_x, u.slip_y],
        approach: u.gap_rate,
    };
    let compressed = impact.press(impact.begun(), Until::Compressed)?;
    if restitution > 0.0 {
        let back = compressed.work * (1.0 - restitution * restitution);
        let restored = impact.press(compressed, Until::Restored(back))?;
        let rebound = impact.velocity(&restored);
        if rebound > rest {
            return Some(impact.after(k, u, &restored, rebound));
        }
    }
    Some(impact.after(k, u, &compressed, 0.0))
}

impl Mobility {
    fn new(k: &Parameters<f64>, u: &Coordinates<f64>) -> Self {
        let (rho, z) = (k.rho(u), k.z(u));
        let inertia = k.a + k.m * z * z;
        Mobility {
            along: inertia / (k.m * k.a),
            across: k.sideways_mobility(),
            held: 1.0 / k.m + rho * rho / inertia,
            carry: -k.m * rho * z / inertia,
        }
    }
}

impl Impact {
    fn begun(&self) -> Striking {
        Striking {
            slip: self.slip,
            pressed: 0.0,
            work: 0.0,
        }
    }

    /// v.
    fn velocity(&self, now: &Striking) -> f64 {
        let Mobility { held, carry, .. } = self.mobility;
        self.approach + held * now.pressed + carry * (now.slip[0] - self.slip[0])
    }

    /// Negative before a part is over, zero at its end.
    fn level(&self, until: Until, now: &Striking) -> f64 {
        match until {
            Until::Compressed => self.velocity(now),
            Until::Restored(work) => now.work - work,
        }
    }

    /// One part of the impact; none where the slip cannot be followed.
    fn press(&self, mut now: Striking, until: Until) -> Option<Striking> {
        if self.level(until, &now) >= 0.0 {
            return Some(now);
        }
        if self.friction == 0.0 {
            let (_, to_end) = self.slips_straight(&now, 0.0, until);
            return Some(self.pressed_on(&now, 0.0, to_end));
        }
        if now.slip[1] != 0.0 {
            match self.slide(now, until)? {
                ControlFlow::Break(end) => return Some(end),
                ControlFlow::Continue(straight) => now = straight,
            }
        }
        if now.slip[0] != 0.0 {
            let friction_force = -self.friction * now.slip[0].signum();
            let (to_stop, to_end) = self.slips_straight(&now, friction_force, until);
            if to_end <= to_stop {
                return Some(self.pressed_on(&now, friction_force, to_end));
            }
            now = self.pressed_on(&now, friction_force, to_stop);
            now.slip[0] = 0.0;
        }
        let friction_force = (-self.mobility.carry).clamp(-self.friction, self.friction);
        let (_, to_end) = self.slips_straight(&now, friction_force, until);
        Some(self.pressed_on(&now, friction_force, to_end))
    }

    /// Follows a slip in two dimensions to the end of the part, or until it has stopped or keeps to e_x1
    /// and the part continues.
    fn slide(&self, mut now: Striking, until: Until) -> Option<ControlFlow<Striking, Striking>> {
        const MAX_STEPS: usize = 10_000;
        let Mobility {
            along,
            across,
            held,
            carry,
        } = self.mobility;
        let speed = libm::hypot(now.slip[0], now.slip[1]);
        let turning = self.friction * (along + across) + carry.abs() * along;
        let pressing = held * speed / self.approach.abs();
        let sliding = Sliding {
            impact: self,
            rate: turning + pressing,
        };
        let stopped = f64::EPSILON * (speed + self.approach.abs());
        let mut stepper = Stepper::new(&sliding, now.as_array(), 0.01 / sliding.rate, 1e-14);
        let level = |a: &[f64; 4]| self.level(until, &Striking::from_array(a));
        for _ in 0..MAX_STEPS {
            let [ux, uy] = now.slip;
            if libm::hypot(ux, uy) <= stopped {
                now.slip = [0.0; 2];
                return Some(ControlFlow::Continue(now));
            }
            if uy.abs() <= 0.5 * f64::EPSILON * ux.abs() {
                now.slip[1] = 0.0;
                return Some(ControlFlow::Continue(now));
            }
            let step = stepper.advance().ok()?;
            if level(&step.end) >= 0.0 {
                let dense = step.dense(&sliding);
                let end = dense.at(dense.root(0.0, 1.0, level));
                return Some(ControlFlow::Break(Striking::from_array(&end)));
            }
            now = Striking::from_array(&step.end);
        }
        None
    }

    /// While dP_x = `friction_force` dP and u_y is none or not braked, all is linear in P: how much more of it stops
    /// u_x, and how much ends the part; infinite where it never does.
    fn slips_straight(&self, now: &Striking, friction_force: f64, until: Until) -> (f64, f64) {
        let (slipping, rising) = self.per_impulse(friction_force);
        let v = self.velocity(now);
        let to_stop = -now.slip[0] / slipping;
        let to_end = match until {
            Until::Compressed if rising > 0.0 => -v / rising,
            Until::Compressed => f64::INFINITY,
            Until::Restored(work) => {
                // v² grows by 2 · rising · work.
                let lacking = work - now.work;
                let end = (v * v + 2.0 * rising * lacking).sqrt();
                if v >= 0.0 {
                    2.0 * lacking / (v + end)
                } else {
                    (end - v) / rising
                }
            }
        };
        let positive = |p: f64| if p >= 0.0 { p } else { f64::INFINITY };
        (positive(to_stop), positive(to_end))
    }

    /// The growth of u_x and of v for a normal impulse of 1 while dP_x = `friction_force` dP.
    fn per_impulse(&self, friction_force: f64) -> (f64, f64) {
        let Mobility {
            along, held, carry, ..
        } = self.mobility;
        let slipping = along * (carry + friction_force);
        (slipping, held + carry * slipping)
    }

    fn pressed_on(&self, now: &Striking, friction_force: f64, by: f64) -> Striking {
        let (slipping, rising) = self.per_impulse(friction_force);
        let [ux, uy] = now.slip;
        Striking {
            slip: [ux + slipping * by, uy],
            pressed: now.pressed + by,
            work: now.work + (self.velocity(now) + 0.5 * rising * by) * by,
        }
    }

    /// The body after the impact, rebounding at `v`.
    fn after(
        &self,
        k: &Parameters<f64>,
        u: &Coordinates<f64>,
        end: &Striking,
        v: f64,
    ) -> Coordinates<f64> {
        let (rho, z) = (k.rho(u), k.z(u));
        let Mobility {
            along,
            across,
            carry,
            ..
        } = self.mobility;
        let change: [f64; 2] = core::array::from_fn(|i| end.slip[i] - self.slip[i]);
        let impulse = [
            change[0] / along - carry * end.pressed,
            change[1] / across,
            end.pressed,
        ];
        // An impulse works by the mean of the velocity before and after.
        let twice_mean = [
            self.slip[0] + end.slip[0],
            self.slip[1] + end.slip[1],
            self.approach + v,
        ];
        let work: f64 = (0..3).map(|i| 0.5 * twice_mean[i] * impulse[i]).sum();
        Coordinates {
            p: u.p + (k.m * z * change[0] - rho * end.pressed) / (k.a + k.m * z * z),
            w: u.w + k.h * impulse[1] / k.a,
            s: u.s - k.r * impulse[1] / k.c,
            slip_x: end.slip[0],
            slip_y: end.slip[1],
            gap: 0.0,
            gap_rate: v,
            impact_loss: u.impact_loss - work,
            ..*u
        }
    }
}

impl Striking {
    fn as_array(&self) -> [f64; 4] {
        [self.slip[0], self.slip[1], self.pressed, self.work]
    }

    fn from_array(&[ux, uy, pressed, work]: &[f64; 4]) -> Self {
        Striking {
            slip: [ux, uy],
            pressed,
            work,
        }
    }
}

/// The slip, the normal impulse and its work on the clock ζ.
struct Sliding<'a> {
    impact: &'a Impact,
    /// All the rates together, to compare with: per unit of ζ.
    rate: f64,
}

impl System<f64, 4> for Sliding<'_> {
    fn rates(&self, a: &[f64; 4]) -> [f64; 4] {
        let friction = self.impact.friction;
        let Mobility {
            along,
            across,
            carry,
            ..
        } = self.impact.mobility;
        let now = Striking::from_array(a);
        let [ux, uy] = now.slip;
        let pressing = (ux * ux + uy * uy).sqrt();
        [
            along * (carry * pressing - friction * ux),
            -across * friction * uy,
            pressing,
            self.impact.velocity(&now) * pressing,
        ]
    }

    fn scale(&self, a: &[f64; 4]) -> [f64; 4] {
        let [ux, uy, pressed, work] = *a;
        let slip = (ux * ux + uy * uy).sqrt();
        let impulse = pressed + slip / self.rate;
        let speed = self.impact.velocity(&Striking::from_array(a)).abs() + slip;
        // u_y is held to its own size, or it would stop decaying where errors as large as itself are good.
        [slip, uy.abs(), impulse, work.abs() + speed * impulse]
    }
}

#[cfg(test)]
mod tests;
