//! Steps from sample to sample in lanes: one step of each of sixteen motions, each with its own body and record.

use super::{At, Between, N, Order, Reduced, Rolling};
use crate::motion::run::OnSamples;
use crate::real::{Bits, LANES, Lanes, Mask, Part, SimdKernel, Vector, run_widest};
use crate::solve::Estimate;

/// The motions.
#[derive(Clone)]
pub(in crate::motion) struct SamplesInLanes {
    rolling: Rolling<Lanes>,
    at: At<Lanes>,
    between: Between<Lanes>,
    direction: Lanes,
    /// 1 in the lanes whose next step has order 8, otherwise 0.
    high_order: Lanes,
    end: At<Lanes>,
    margin: Lanes,
    error_squared: Lanes,
    allowed: Lanes,
}

impl SamplesInLanes {
    /// Lanes that all hold the same motion.
    pub(in crate::motion) fn filled_with(sample: &OnSamples) -> Self {
        let zero = Lanes::from(0.0);
        let at = At {
            u: [zero; N],
            rates: [zero; N],
            margin: zero,
        };
        let mut lanes = SamplesInLanes {
            rolling: sample.rolling.map(|&number| Lanes::from(number)),
            at,
            between: Between {
                from: [zero; 3],
                to: [zero; 3],
                h: zero,
            },
            direction: zero,
            high_order: zero,
            end: at,
            margin: zero,
            error_squared: zero,
            allowed: zero,
        };
        for lane in 0..LANES {
            lanes.put(lane, sample);
        }
        lanes
    }

    /// Puts a motion into a lane.
    pub(in crate::motion) fn put(&mut self, lane: usize, sample: &OnSamples) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        sample.rolling.write(&mut self.rolling, write);
        sample.at.write(&mut self.at, write);
        self.direction.0[lane] = sample.direction;
        self.aim(lane, sample.order(), &sample.between());
    }

    /// Sets the step of a lane.
    #[inline]
    pub(in crate::motion) fn aim(&mut self, lane: usize, order: Order, between: &Between<f64>) {
        self.high_order.0[lane] = f64::from(u8::from(order == Order::Eight));
        for i in 0..3 {
            self.between.from[i].0[lane] = between.from[i];
            self.between.to[i].0[lane] = between.to[i];
        }
        self.between.h.0[lane] = between.h;
    }

    /// The motion in a lane.
    pub(in crate::motion) fn at(&self, lane: usize) -> At<f64> {
        let number = |lanes: &Lanes| lanes.0[lane];
        self.at.map(number)
    }

    /// The estimate of the error of the last step in a lane.
    #[inline]
    pub(in crate::motion) fn estimate(&self, lane: usize) -> Estimate<f64> {
        Estimate {
            error_squared: self.error_squared.0[lane],
            allowed: self.allowed.0[lane],
        }
    }

    /// Attempts a step in each lane whose next step has this order. Lanes whose bits are set in the result are at its end,
    /// the others at its start.
    pub(in crate::motion) fn step(&mut self, order: Order) -> Bits {
        run_widest(Step(self, order))
    }
}

struct Step<'a>(&'a mut SamplesInLanes, Order);

impl SimdKernel for Step<'_> {
    type Done = Bits;

    #[inline(always)]
    fn run<V: Vector>(self) -> Bits {
        let Step(lanes, order) = self;
        // Each order is compiled by itself.
        match order {
            Order::Five => lanes.attempt_all::<V>(Order::Five),
            Order::Eight => lanes.attempt_all::<V>(Order::Eight),
        }
        lanes.accept::<V>(order)
    }
}

impl SamplesInLanes {
    #[inline(always)]
    fn attempt_all<V: Vector>(&mut self, order: Order) {
        self.attempt::<V::Part>(order, 0);
        if V::Part::PARTS > 1 {
            self.attempt::<V::Part>(order, 1);
        }
    }

    /// Attempts the step in a part of the lanes.
    #[inline(always)]
    fn attempt<P: Part>(&mut self, order: Order, part: usize) {
        const { assert!(P::PARTS <= 2) };
        // Checked here once, so that the compiler drops the check for every number.
        assert!(part < P::PARTS, "part out of range");
        let load = |lanes: &Lanes| P::load_part(lanes, part);
        let between = Between {
            from: P::load_parts(&self.between.from, part),
            to: P::load_parts(&self.between.to, part),
            h: load(&self.between.h),
        };
        let at = At {
            u: P::load_parts(&self.at.u, part),
            rates: P::load_parts(&self.at.rates, part),
            margin: load(&self.at.margin),
        };
        let rolling = self.rolling.map(load);
        let attempt = rolling.attempt(order, &at, &between, load(&self.direction));
        P::store_parts(attempt.end.u, &mut self.end.u, part);
        P::store_parts(attempt.end.rates, &mut self.end.rates, part);
        attempt.end.margin.store_part(&mut self.end.margin, part);
        attempt.margin.store_part(&mut self.margin, part);
        let estimate = attempt.estimate;
        estimate
            .error_squared
            .store_part(&mut self.error_squared, part);
        estimate.allowed.store_part(&mut self.allowed, part);
    }

    /// Moves the lanes whose step counts to its end.
    #[inline(always)]
    fn accept<V: Vector>(&mut self, order: Order) -> Bits {
        let (error_squared, allowed) = (V::load(&self.error_squared), V::load(&self.allowed));
        let within_tolerance = error_squared
            .at_most(allowed)
            .and(error_squared.at_most(V::from(f64::MAX)));
        let uneventful = V::from(0.0).at_most(V::load(&self.margin));
        let high_order = V::from(0.5).at_most(V::load(&self.high_order));
        let of_this_order = match order {
            Order::Five => !high_order,
            Order::Eight => high_order,
        };
        let moves = within_tolerance.and(uneventful).and(of_this_order).opaque();
        for i in 0..N {
            let (u, end) = (V::load(&self.at.u[i]), V::load(&self.end.u[i]));
            self.at.u[i] = moves.choose(end, u).store();
            let (rates, end) = (V::load(&self.at.rates[i]), V::load(&self.end.rates[i]));
            self.at.rates[i] = moves.choose(end, rates).store();
        }
        let (margin, end) = (V::load(&self.at.margin), V::load(&self.end.margin));
        self.at.margin = moves.choose(end, margin).store();
        moves.bits()
    }
}

impl<T> At<T> {
    fn map<U>(&self, f: impl Fn(&T) -> U + Copy) -> At<U> {
        At {
            u: core::array::from_fn(|i| f(&self.u[i])),
            rates: core::array::from_fn(|i| f(&self.rates[i])),
            margin: f(&self.margin),
        }
    }

    fn write<U>(&self, to: &mut At<U>, f: impl Fn(&T, &mut U)) {
        let (u, rates): (&Reduced<T>, &Reduced<T>) = (&self.u, &self.rates);
        for i in 0..N {
            f(&u[i], &mut to.u[i]);
            f(&rates[i], &mut to.rates[i]);
        }
        f(&self.margin, &mut to.margin);
    }
}

#[cfg(test)]
mod tests {
    use super::{LANES, Lanes, Order, SamplesInLanes, Step};
    use crate::contact_law::ContactLaw;
    use crate::law::IdealLaw;
    use crate::motion::contacts::Contacts;
    use crate::motion::samples::{At, Between, Rolling, reduce};
    use crate::presets;
    use crate::real::{Bits, SimdKernel, Vector, in_every_width};
    use crate::state::{Coordinates, State};

    const ACCELERATION: [f64; 3] = [1.0, -2.0, 0.5];

    /// The start of a lane, and its step.
    fn lane(rolling: &Rolling<f64>, lane: usize) -> (At<f64>, Between<f64>) {
        let part = lane as f64 / LANES as f64;
        let start = State {
            tilt: 0.05 + 0.2 * part,
            // The tilt has a minimum in the last lanes.
            tilt_rate: -1.0 + 1.005 * part,
            yaw: -40.0 * part,
            yaw_rate: 1.0 + part,
            ..State::default()
        };
        let from = ACCELERATION.map(|a| a * part);
        let at = rolling.at(&reduce(&Coordinates::from_state(&start)), from);
        let (to, h) = (ACCELERATION, 1e-3 * (1.0 + part));
        (at, Between { from, to, h })
    }

    fn order(lane: usize) -> Order {
        if lane.is_multiple_of(3) {
            Order::Eight
        } else {
            Order::Five
        }
    }

    struct Owned(SamplesInLanes);

    impl SimdKernel for Owned {
        type Done = ([Bits; 2], SamplesInLanes);

        fn run<V: Vector>(mut self) -> Self::Done {
            let orders = [Order::Five, Order::Eight];
            let moved = orders.map(|order| Step(&mut self.0, order).run::<V>());
            (moved, self.0)
        }
    }

    #[test]
    fn lanes_of_any_width_have_the_bits_of_a_motion_alone() {
        let can = presets::can_2007().expect("the paper's can");
        let law = ContactLaw::from(IdealLaw::NoSlip);
        let contacts = Contacts::new(&can, &law, 9.8, 1e-9);
        let rolling = Rolling::new(&contacts, None, 1e-9);
        let zero = Lanes::from(0.0);
        let (first, between) = lane(&rolling, 0);
        let all = |number: &f64| Lanes::from(*number);
        let mut lanes = SamplesInLanes {
            rolling: rolling.map(all),
            at: first.map(all),
            between: Between {
                from: between.from.map(Lanes::from),
                to: between.to.map(Lanes::from),
                h: Lanes::from(between.h),
            },
            direction: Lanes::from(-1.0),
            high_order: zero,
            end: first.map(all),
            margin: zero,
            error_squared: zero,
            allowed: zero,
        };
        for i in 0..LANES {
            let (at, between) = lane(&rolling, i);
            at.write(&mut lanes.at, |number, lanes| lanes.0[i] = *number);
            lanes.aim(i, order(i), &between);
        }
        let alone: Vec<_> = (0..LANES)
            .map(|i| {
                let (at, between) = lane(&rolling, i);
                let attempt = rolling.attempt_alone(order(i), &at, &between, -1.0);
                let moves = attempt.estimate.is_accepted() && attempt.margin >= 0.0;
                (moves, if moves { attempt.end } else { at })
            })
            .collect();
        assert!(alone.iter().any(|one| one.0) && alone.iter().any(|one| !one.0));
        for ([five, eight], lanes) in in_every_width(|| Owned(lanes.clone())) {
            assert_eq!(five & eight, 0);
            for (i, (moves, at)) in alone.iter().enumerate() {
                assert_eq!((five | eight) >> i & 1 == 1, *moves);
                assert_eq!((lanes.at(i).u, lanes.at(i).rates), (at.u, at.rates));
            }
        }
    }
}
