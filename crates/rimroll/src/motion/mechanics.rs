//! The mechanics of one phase as the solver sees it.

use crate::law::Law;
use crate::solve::System;
use crate::state::{COORDINATES, Coordinates, MOVING};

/// A law, and the sizes that errors are compared with.
pub(super) struct Mechanics<'a> {
    pub law: &'a dyn Law<f64>,
    mass: f64,
    radius: f64,
    /// √(g/R): the rate of falling, a yardstick for rates.
    pub falling_rate: f64,
    only_moves: bool,
    slows_with_slip: bool,
}

impl<'a> Mechanics<'a> {
    pub(super) fn new(law: &'a dyn Law<f64>) -> Self {
        let k = law.parameters();
        Mechanics {
            law,
            mass: k.m,
            radius: k.r,
            falling_rate: (k.g / k.r).sqrt(),
            only_moves: law.only_moves(),
            slows_with_slip: false,
        }
    }

    /// For dry friction, whose direction changes at a rate that grows like 1/|u| as the slip ends: a
    /// clock that slows down with the slip makes the end as smooth as the rest.
    pub(super) fn slowing_with_slip(law: &'a dyn Law<f64>) -> Self {
        Mechanics {
            slows_with_slip: true,
            ..Mechanics::new(law)
        }
    }

    /// How fast the solver's clock goes, as a part of τ.
    pub(super) fn clock(&self, u: &Coordinates<f64>) -> f64 {
        // A slip this slow, beside the other velocities, is about to end.
        const SLOW: f64 = 0.05;
        if !self.slows_with_slip {
            return 1.0;
        }
        let fall = u.sin * self.falling_rate;
        let speed = (u.slip_x * u.slip_x + u.slip_y * u.slip_y).sqrt();
        let slow = SLOW * self.radius * (u.p * u.p + u.w * u.w + fall * fall).sqrt();
        speed / (speed + slow)
    }

    /// A speed (m/s) to compare sideways slip with: what w and s, which are held to their own sizes,
    /// make of it.
    pub(super) fn sideways_speed(&self, u: &Coordinates<f64>) -> f64 {
        self.radius * (u.w.abs() + u.sin * u.s.abs())
    }

    /// A rate (rad/s) to compare the tilt rate with.
    pub(super) fn tilt_rate_scale(&self, u: &Coordinates<f64>) -> f64 {
        u.p.abs() + u.w.abs() + u.sin * self.falling_rate
    }
}

impl System<COORDINATES> for Mechanics<'_> {
    fn rates(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        let u = Coordinates::from_array(u);
        let rates = self.law.rates(&u).into_array();
        if !self.slows_with_slip {
            return rates;
        }
        let clock = self.clock(&u);
        rates.map(|rate| clock * rate)
    }

    /// w and s obey linear equations and pass through the tipping phase as small as the start made
    /// them, to become large in the collision; so each is held to its own size, with a floor of what
    /// the other one feeds into it. sin φ is held to its own size for the same reason. The slip
    /// across e_x1 feeds w and is fed by it: an error of the one is as good as one of the other. A slow
    /// slip is about to begin or to end, and its direction matters less the slower it is.
    fn scale(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        const NEVER_ZERO: f64 = 1e-200;
        let u = Coordinates::from_array(u);
        // Well below what counts as stopped, a tenth of the tolerance.
        const SLOW: f64 = 1e-2;
        let tilting = self.tilt_rate_scale(&u);
        let speed = u.slip_speed() + SLOW * self.radius * tilting;
        let sideways = u.w.abs() + u.sin * u.s.abs();
        let fallen = self.falling_rate * self.falling_rate;
        let energy = self.mass
            * self.radius
            * self.radius
            * (tilting * tilting + u.s * u.s + u.sin * fallen);
        Coordinates {
            yaw: 1.0,
            spin: 1.0,
            x: self.radius,
            y: self.radius,
            t: 1.0 / self.falling_rate,
            sin: u.sin + NEVER_ZERO,
            cos: 1.0,
            p: tilting,
            w: sideways + NEVER_ZERO,
            s: u.s.abs() + u.sin * u.w.abs() + NEVER_ZERO,
            slip_x: speed,
            slip_y: u.slip_y.abs() + speed * sideways / tilting + NEVER_ZERO,
            gap: u.gap.abs() + 1e-6 * self.radius,
            gap_rate: u.gap_rate.abs() + 1e-6 * self.radius * self.falling_rate,
            friction_loss: energy,
            resistance_loss: energy,
            impact_loss: energy,
        }
        .into_array()
    }

    const FIRST: usize = MOVING;

    fn only_first(&self) -> bool {
        self.only_moves
    }
}
