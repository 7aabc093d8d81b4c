//! Steps from sample to sample in lanes: one step of each of sixteen motions, each with its own body and record. All steps
//! have the same order.

use super::{N, Order, Reduced, Rolling, SampleInterval, StepEnd};
use crate::motion::run::SampleStep;
use crate::real::{Bits, LANES, Lanes, Mask, Part, SimdKernel, Vector, run_widest};
use crate::solve::ErrorEstimate;

/// The motions.
#[derive(Clone)]
pub(in crate::motion) struct SamplesInLanes {
    rolling: Rolling<Lanes>,
    at: StepEnd<Lanes>,
    between: SampleInterval<Lanes>,
    direction: Lanes,
    order: Order,
    end: StepEnd<Lanes>,
    margin: Lanes,
    error_squared: Lanes,
    allowed: Lanes,
}

impl SamplesInLanes {
    /// Lanes that all hold the same motion.
    pub(in crate::motion) fn filled_with(sample: &SampleStep) -> Self {
        let zero = Lanes::from(0.0);
        let at = StepEnd {
            u: [zero; N],
            rates: [zero; N],
            margin: zero,
        };
        let mut lanes = SamplesInLanes {
            rolling: sample.rolling.map(|&number| Lanes::from(number)),
            at,
            between: SampleInterval {
                from: [zero; 3],
                to: [zero; 3],
                h: zero,
            },
            direction: zero,
            order: sample.order(),
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
    pub(in crate::motion) fn put(&mut self, lane: usize, sample: &SampleStep) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        sample.rolling.write(&mut self.rolling, write);
        sample.at.write(&mut self.at, write);
        self.direction.0[lane] = sample.direction;
        self.aim(lane, &sample.between());
    }

    /// Sets the step of a lane.
    #[inline]
    pub(in crate::motion) fn aim(&mut self, lane: usize, between: &SampleInterval<f64>) {
        for i in 0..3 {
            self.between.from[i].0[lane] = between.from[i];
            self.between.to[i].0[lane] = between.to[i];
        }
        self.between.h.0[lane] = between.h;
    }

    /// The motion in a lane.
    pub(in crate::motion) fn at(&self, lane: usize) -> StepEnd<f64> {
        let number = |lanes: &Lanes| lanes.0[lane];
        self.at.map(number)
    }

    /// The end of the last step of a lane.
    pub(in crate::motion) fn end(&self, lane: usize) -> StepEnd<f64> {
        let number = |lanes: &Lanes| lanes.0[lane];
        self.end.map(number)
    }

    /// Sets the motion in a lane, and the sign of its tilt rate.
    pub(in crate::motion) fn turn_back(&mut self, lane: usize, at: &StepEnd<f64>, direction: f64) {
        at.write(&mut self.at, |number, lanes| lanes.0[lane] = *number);
        self.direction.0[lane] = direction;
    }

    /// The estimate of the error of the last step in a lane.
    #[inline]
    pub(in crate::motion) fn estimate(&self, lane: usize) -> ErrorEstimate<f64> {
        ErrorEstimate {
            error_squared: self.error_squared.0[lane],
            allowed: self.allowed.0[lane],
        }
    }

    /// Attempts a step in each lane.
    pub(in crate::motion) fn step(&mut self) -> Stepped {
        run_widest(Step(self))
    }
}

/// What has become of an attempted step, with a bit for each lane.
#[derive(Debug, Clone, Copy)]
pub(in crate::motion) struct Stepped {
    /// The lanes that are at the end of the step; the others are at its start.
    pub moved: Bits,
    /// The lanes at the start of a step that counts and that contains an extremum of the tilt.
    pub reverses: Bits,
}

struct Step<'a>(&'a mut SamplesInLanes);

impl SimdKernel for Step<'_> {
    type Done = Stepped;

    #[inline(always)]
    fn run<V: Vector>(self) -> Stepped {
        let Step(lanes) = self;
        // Each order is compiled by itself.
        match lanes.order {
            Order::Five => lanes.attempt_all::<V>(Order::Five),
            Order::Eight => lanes.attempt_all::<V>(Order::Eight),
        }
        lanes.accept::<V>()
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
        let between = SampleInterval {
            from: P::load_parts(&self.between.from, part),
            to: P::load_parts(&self.between.to, part),
            h: load(&self.between.h),
        };
        let at = StepEnd {
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

    /// Moves the lanes whose step counts to its end, if the tilt has no extremum in it.
    #[inline(always)]
    fn accept<V: Vector>(&mut self) -> Stepped {
        let (error_squared, allowed) = (V::load(&self.error_squared), V::load(&self.allowed));
        let within_tolerance = error_squared
            .at_most(allowed)
            .and(error_squared.at_most(V::from(f64::MAX)));
        let uneventful = V::from(0.0).at_most(V::load(&self.margin));
        let counts = within_tolerance.and(uneventful).opaque();
        let continues = V::from(0.0).at_most(V::load(&self.direction) * V::load(&self.end.u[2]));
        let moves = counts.and(continues).opaque();
        for i in 0..N {
            let (u, end) = (V::load(&self.at.u[i]), V::load(&self.end.u[i]));
            self.at.u[i] = moves.choose(end, u).store();
            let (rates, end) = (V::load(&self.at.rates[i]), V::load(&self.end.rates[i]));
            self.at.rates[i] = moves.choose(end, rates).store();
        }
        let (margin, end) = (V::load(&self.at.margin), V::load(&self.end.margin));
        self.at.margin = moves.choose(end, margin).store();
        let moved = moves.bits();
        Stepped {
            moved,
            reverses: counts.bits() & !moved,
        }
    }
}

impl<T> StepEnd<T> {
    fn map<U>(&self, f: impl Fn(&T) -> U + Copy) -> StepEnd<U> {
        StepEnd {
            u: core::array::from_fn(|i| f(&self.u[i])),
            rates: core::array::from_fn(|i| f(&self.rates[i])),
            margin: f(&self.margin),
        }
    }

    fn write<U>(&self, to: &mut StepEnd<U>, f: impl Fn(&T, &mut U)) {
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
    use super::{LANES, Lanes, Order, SamplesInLanes, Step, Stepped};
    use crate::contact_law::ContactLaw;
    use crate::law::IdealLaw;
    use crate::motion::contacts::Contacts;
    use crate::motion::options::Options;
    use crate::motion::sample_to_sample::{Rolling, SampleInterval, StepEnd, reduce};
    use crate::presets;
    use crate::real::{SimdKernel, Vector, in_every_width};
    use crate::state::{Coordinates, State};

    const ACCELERATION: [f64; 3] = [1.0, -2.0, 0.5];

    /// The start of a lane, and its step.
    fn lane(rolling: &Rolling<f64>, lane: usize) -> (StepEnd<f64>, SampleInterval<f64>) {
        let part = lane as f64 / LANES as f64;
        let start = State {
            tilt: 0.05 + 0.2 * part,
            // The tilt has a maximum in the step of the last lane.
            tilt_rate: 1.0 - 1.06 * part,
            yaw: -40.0 * part,
            yaw_rate: 1.0 + part,
            ..State::default()
        };
        let from = ACCELERATION.map(|a| a * part);
        let at = rolling.at(&reduce(&Coordinates::from_state(&start)), from);
        let (to, h) = (ACCELERATION, 5e-4 * (1.0 + part));
        (at, SampleInterval { from, to, h })
    }

    struct Owned(SamplesInLanes);

    impl SimdKernel for Owned {
        type Done = (Stepped, SamplesInLanes);

        fn run<V: Vector>(mut self) -> Self::Done {
            let stepped = Step(&mut self.0).run::<V>();
            (stepped, self.0)
        }
    }

    #[test]
    fn lanes_of_any_width_have_the_bits_of_a_motion_alone() {
        let can = presets::can_2007().expect("the paper's can");
        let law = ContactLaw::from(IdealLaw::NoSlip);
        let contacts = Contacts::new(&can, &law, 9.8, 1e-9);
        let rolling = Rolling::new(&contacts, &Options::default());
        let zero = Lanes::from(0.0);
        let (first, between) = lane(&rolling, 0);
        let all = |number: &f64| Lanes::from(*number);
        for order in [Order::Five, Order::Eight] {
            let mut lanes = SamplesInLanes {
                rolling: rolling.map(all),
                at: first.map(all),
                between: SampleInterval {
                    from: between.from.map(Lanes::from),
                    to: between.to.map(Lanes::from),
                    h: Lanes::from(between.h),
                },
                direction: Lanes::from(1.0),
                order,
                end: first.map(all),
                margin: zero,
                error_squared: zero,
                allowed: zero,
            };
            let mut alone = Vec::new();
            for i in 0..LANES {
                let (at, between) = lane(&rolling, i);
                at.write(&mut lanes.at, |number, lanes| lanes.0[i] = *number);
                lanes.aim(i, &between);
                alone.push((at, rolling.attempt_alone(order, &at, &between, 1.0)));
            }
            let [mut moved, mut reversed, mut rejected] = [0; 3];
            for (stepped, lanes) in in_every_width(|| Owned(lanes.clone())) {
                for (i, (at, attempt)) in alone.iter().enumerate() {
                    let reverses = attempt.is_accepted() && attempt.end.u[2] < 0.0;
                    let moves = attempt.is_accepted() && !reverses;
                    assert_eq!(stepped.moved >> i & 1 == 1, moves);
                    assert_eq!(stepped.reverses >> i & 1 == 1, reverses);
                    let (end, now) = (lanes.end(i), lanes.at(i));
                    let at = if moves { &attempt.end } else { at };
                    assert_eq!((now.u, now.rates), (at.u, at.rates));
                    assert_eq!((end.u, end.rates), (attempt.end.u, attempt.end.rates));
                    moved += u32::from(moves);
                    reversed += u32::from(reverses);
                    rejected += u32::from(!attempt.is_accepted());
                }
            }
            assert!(moved > 0 && reversed > 0 && (rejected > 0 || order == Order::Eight));
        }
    }
}
