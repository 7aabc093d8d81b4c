//! Derivatives of motions on a table that moves, against difference quotients of neighbouring motions and against
//! closed forms.

use core::ops::ControlFlow;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::{PivotingFriction, Resistance, RollingResistance, Viscous};
use rimroll::motion::{
    FlatLanding, SHAKEN_PARAMETERS, ShakenSensitivity, ShakenSlope, Side, shaken,
};
use rimroll::{Body, ContactLaw, FrictionLaw, Motion, Options, State, presets, simulate_on};
use std::sync::Arc;

/// The parameters of a motion, in the order of [`SHAKEN_PARAMETERS`].
type Numbers = [f64; SHAKEN_PARAMETERS.len()];

/// What a motion consists of, except for the numbers.
struct Case {
    name: &'static str,
    law: ContactLaw,
    ground: Ground,
    flat: FlatLanding,
    duration: f64,
    numbers: Numbers,
    times: [f64; 3],
    /// The error that a derivative may have, relative to the largest change of the value that a parameter makes.
    accuracy: f64,
}

/// The differences are right to 1e-8; where a motion amplifies changes, the rounding errors of motions make that 1e-6.
const ACCURACY: f64 = 1e-6;

/// The state at three times, and what remains in the end: the largest tilt, the displacement and the yaw.
const VALUES: usize = 3 * 6 + 4;

impl Case {
    fn new(
        name: &'static str,
        law: FrictionLaw,
        ground: Ground,
        state: [f64; 6],
        body: &Body,
    ) -> Case {
        Case {
            name,
            law: law.into(),
            ground,
            flat: FlatLanding::Stop,
            duration: 1.9,
            numbers: with_body(state, body),
            times: [0.3, 0.9, 1.4],
            accuracy: ACCURACY,
        }
    }

    fn given(&self, numbers: &Numbers) -> (Arc<Ground>, Body, State, Options) {
        let [state @ .., m, r, h, a, c, gravity, scale] = *numbers;
        let options = Options {
            duration: self.duration,
            gravity,
            rtol: 1e-13,
            flat: self.flat,
            ..Options::default()
        };
        (
            Arc::new(self.ground.scaled(scale)),
            Body::new(m, r, h, a, c).expect("a body"),
            State::from_numbers(state),
            options,
        )
    }

    fn motion(&self, numbers: &Numbers) -> Motion {
        let (ground, body, start, options) = self.given(numbers);
        let law = self.law.clone();
        simulate_on(Some(ground), &body, &start, law, &options, |_| CONTINUE).expect("valid input")
    }

    fn values(&self, numbers: &Numbers) -> [f64; VALUES] {
        let motion = self.motion(numbers);
        let states = self
            .times
            .map(|t| motion.trajectory.at(t).state().numbers());
        let (ground, body, start, options) = self.given(numbers);
        let outcome = shaken(Some(ground), &body, &start, &self.law, &options, |_| {
            CONTINUE
        });
        let outcome = outcome.expect("valid input");
        let [x, y] = outcome.residual_displacement;
        let rest = [outcome.max_tilt, x, y, outcome.residual_yaw];
        core::array::from_fn(|i| match i {
            0..18 => states[i / 6][i % 6],
            _ => rest[i - 18],
        })
    }

    /// The units of the values.
    fn units(&self) -> [f64; VALUES] {
        let [.., r, _, _, _, g, _] = self.numbers;
        let rate = (g / r).sqrt();
        core::array::from_fn(|i| match i {
            19 | 20 => r,
            1 | 3 | 5 | 7 | 9 | 11 | 13 | 15 | 17 => rate,
            _ => 1.0,
        })
    }

    fn slopes(&self, motion: &Motion) -> [ShakenSlope; VALUES] {
        let sensitivity = derivatives(motion);
        let states = self.times.map(|t| sensitivity.at(motion, t));
        let [x, y] = sensitivity.residual_displacement();
        let rest = [
            sensitivity.max_tilt(motion),
            x,
            y,
            sensitivity.residual_yaw(),
        ];
        core::array::from_fn(|i| match i {
            0..18 => states[i / 6][i % 6],
            _ => rest[i - 18],
        })
    }

    /// Compares the derivatives by all parameters that are not excepted with differences of neighbouring motions. The
    /// names of the parameters without derivatives at the end are returned.
    fn compare(&self, excepted: &[&str]) -> Vec<&'static str> {
        let motion = self.motion(&self.numbers);
        let (slopes, units) = (self.slopes(&motion), self.units());
        let mut without = Vec::new();
        for (i, name) in SHAKEN_PARAMETERS.iter().enumerate() {
            if slopes[VALUES - 1][i].is_nan() {
                without.push(*name);
            }
            if excepted.contains(name) || slopes.iter().all(|slope| slope[i].is_nan()) {
                continue;
            }
            let expected = differences(i, &self.numbers, |numbers| self.values(numbers));
            for (k, slope) in slopes.iter().enumerate() {
                let size = scaled_size(slope, &self.numbers) + 0.1 * units[k];
                let error = (slope[i] - expected[k]).abs() * size_of(i, &self.numbers);
                assert!(
                    error < self.accuracy * size || slope[i].is_nan(),
                    "{}: value {k} by {name}: {} not {}",
                    self.name,
                    slope[i],
                    expected[k]
                );
            }
        }
        without
    }
}

const CONTINUE: ControlFlow<()> = ControlFlow::Continue(());

fn derivatives(motion: &Motion) -> ShakenSensitivity {
    let derivatives = motion.shaken_sensitivity(|_| CONTINUE);
    derivatives.expect("a smooth motion").expect("not stopped")
}

/// Body and gravity.
fn with_body(state: [f64; 6], body: &Body) -> Numbers {
    let [tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate] = state;
    let (a, c) = (body.transverse_inertia(), body.axial_inertia());
    let [m, r, h] = [body.mass(), body.radius(), body.height()];
    [
        tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate, m, r, h, a, c, 9.81, 1.0,
    ]
}

/// A solid stone cylinder of 1000 kg, 4 m high.
fn column() -> Body {
    Body::new(1000.0, 0.5, 2.0, 1_395.833_333_333_333_3, 125.0).unwrap()
}

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn sine(amplitude: [f64; 3], period: f64, cycles: f64) -> Pulse {
    Pulse {
        amplitude,
        shape: Shape::Sine { period },
        duration: cycles * period,
    }
}

fn two_sines() -> Ground {
    let pulses = vec![
        sine([3.0, 0.0, 0.0], 1.2, 1.0),
        sine([0.0, 1.5, 0.0], 0.8, 1.0),
        sine([0.0, 0.0, 2.0], 0.5, 2.0),
    ];
    Ground::pulses(pulses).unwrap()
}

/// Samples of a smooth function with different periods along the three axes.
fn record(size: f64) -> Ground {
    let sample = |i: usize| {
        let t = 0.02 * i as f64;
        let wave = |rate: f64, phase: f64| libm::sin(rate * t + phase) - libm::sin(phase);
        [
            size * wave(7.0, 0.3),
            0.7 * size * wave(11.0, 1.0),
            0.4 * size * wave(17.0, 2.0),
        ]
    };
    Ground::sampled(0.02, (0..150).map(sample).collect()).unwrap()
}

/// The size of a parameter's changes that a motion notices about as much as those of the others.
fn size_of(index: usize, numbers: &Numbers) -> f64 {
    let rate = (numbers[11] / numbers[7]).sqrt();
    match index {
        0 => numbers[0],
        1 | 3 | 5 => 0.1 * rate,
        2 | 4 => 1.0,
        _ => numbers[index],
    }
}

/// Central differences of three widths, extrapolated to a relative error of about 1e-8.
fn differences<const N: usize>(
    index: usize,
    numbers: &Numbers,
    f: impl Fn(&Numbers) -> [f64; N],
) -> [f64; N] {
    let width = 5e-4 * size_of(index, numbers);
    let slope = |width: f64| {
        let neighbour = |by: f64| {
            let mut numbers = *numbers;
            numbers[index] += by;
            f(&numbers)
        };
        let (after, before) = (neighbour(width), neighbour(-width));
        core::array::from_fn::<f64, N, _>(|i| (after[i] - before[i]) / (2.0 * width))
    };
    let [wide, middle, narrow] = [width, 0.5 * width, 0.25 * width].map(slope);
    core::array::from_fn(|i| {
        let better = (4.0 * middle[i] - wide[i]) / 3.0;
        let best = (4.0 * narrow[i] - middle[i]) / 3.0;
        (16.0 * best - better) / 15.0
    })
}

fn scaled_size(slope: &ShakenSlope, numbers: &Numbers) -> f64 {
    let terms = slope
        .iter()
        .enumerate()
        .map(|(i, slope)| (slope * size_of(i, numbers)).abs())
        .filter(|size| size.is_finite());
    terms.fold(0.0, f64::max)
}

/// The events of a motion.
fn kinds(motion: &Motion) -> Vec<&'static str> {
    let events = motion.events.iter();
    events.map(|event| event.kind.name()).collect()
}

const LEANING: [f64; 6] = [0.05, 0.0, 0.3, 0.0, 0.0, 0.0];
const WOBBLING: [f64; 6] = [0.2, -0.3, 0.4, 0.5, -0.1, 0.3];
const STANDING: [f64; 6] = [0.0; 6];

#[test]
fn the_state_changes_with_each_parameter_as_neighbouring_motions_say() {
    let in_place = [0.2, -0.3, 0.4, 0.5, -0.1, 0.0];
    let no_slip = FrictionLaw::NoSlip;
    let sticking = FrictionLaw::coulomb(20.0);
    for (case, without) in [
        (
            Case::new("rolls", no_slip.clone(), two_sines(), LEANING, &column()),
            &[][..],
        ),
        (
            Case::new("rolls on a record", no_slip, record(1.0), WOBBLING, &can()),
            &[],
        ),
        (
            Case::new("sticks", sticking, record(0.5), LEANING, &column()),
            &[],
        ),
        (
            Case::new(
                "slides",
                FrictionLaw::Frictionless,
                record(1.0),
                WOBBLING,
                &can(),
            ),
            &[],
        ),
        (
            Case::new(
                "in place",
                FrictionLaw::InPlace,
                two_sines(),
                in_place,
                &column(),
            ),
            // It is not free: it is the opposite of the yaw rate.
            &["spin_rate"],
        ),
    ] {
        assert_eq!(case.compare(&[]), without, "{}", case.name);
    }
}

/// A body that stands has no derivatives by a tilt or a rotation, with which it would not stand.
const NOT_STANDING: [&str; 4] = ["tilt", "tilt_rate", "yaw_rate", "spin_rate"];

/// The acceleration comes to the limit at a time that depends on the parameters, or jumps over it at a fixed time.
#[test]
fn a_body_that_is_lifted_has_derivatives() {
    let cosine = Pulse {
        amplitude: [3.0, 1.0, 0.0],
        shape: Shape::Cosine { period: 1.1 },
        duration: 1.1,
    };
    let delayed = Pulse {
        shape: Shape::Sine { period: 0.7 },
        duration: 1.4,
        amplitude: [0.0, 0.7, 0.3],
    };
    let jumping = Ground::pulses(vec![cosine, delayed]).unwrap();
    let no_slip = FrictionLaw::NoSlip;
    for (case, time_varies) in [
        (
            Case::new("sines", no_slip.clone(), two_sines(), STANDING, &column()),
            true,
        ),
        (
            Case::new("record", no_slip.clone(), record(1.5), STANDING, &column()),
            true,
        ),
        (
            Case::new("jump", no_slip, jumping, STANDING, &column()),
            false,
        ),
        (
            Case::new(
                "in place",
                FrictionLaw::InPlace,
                record(1.5),
                STANDING,
                &column(),
            ),
            true,
        ),
    ] {
        let motion = case.motion(&case.numbers);
        assert_eq!(kinds(&motion)[0], "uplift", "{}", case.name);
        assert_eq!(case.compare(&[]), NOT_STANDING, "{}", case.name);
        let found = derivatives(&motion).uplift_time().expect("it is lifted");
        let uplift = |numbers: &Numbers| [case.motion(numbers).events[0].at.t];
        for name in ["radius", "height", "gravity", "ground_scale"] {
            let i = SHAKEN_PARAMETERS
                .iter()
                .position(|one| *one == name)
                .unwrap();
            let [expected] = differences(i, &case.numbers, uplift);
            assert_eq!(found[i] != 0.0, time_varies, "{} {name}", case.name);
            // Times of uplift are located to about 1e-15 s.
            let error = (found[i] - expected).abs() * size_of(i, &case.numbers);
            assert!(
                error < 1e-9,
                "{} {name}: {} {expected}",
                case.name,
                found[i]
            );
        }
    }
}

/// A body that is shaken along a line rocks in a plane. There the coordinates across the plane are exactly zero, so that they
/// do not limit the steps; their derivatives are zero, too, however fast a deviation would decay or oscillate.
#[test]
fn derivatives_stay_in_the_plane_of_a_motion() {
    let ground = || Ground::pulses(vec![sine([4.0, 0.0, 0.0], 1.2, 1.0)]).unwrap();
    let strong = FrictionLaw::from(Viscous { coefficient: 1e7 });
    let resistance = |pivoting: f64, rolling: f64| Resistance {
        pivoting: PivotingFriction { length: pivoting },
        rolling: RollingResistance {
            dry: 0.0,
            viscous: rolling,
        },
        ..Resistance::default()
    };
    let laws = [
        (FrictionLaw::NoSlip, Resistance::default()),
        (FrictionLaw::NoSlip, resistance(1e-4, 0.0)),
        (FrictionLaw::coulomb(0.7), resistance(0.0, 10.0)),
        (strong.clone(), Resistance::default()),
        (strong, resistance(1e-4, 0.0)),
    ];
    for (friction, resistance) in laws {
        for yaw in [0.0, -0.37] {
            let mut case = Case::new("plane", friction.clone(), ground(), STANDING, &column());
            case.law.resistance = resistance;
            case.numbers[2] = yaw;
            let motion = case.motion(&case.numbers);
            assert!(kinds(&motion).contains(&"uplift"));
            let found = derivatives(&motion);
            for t in [0.3, 0.4, 0.5] {
                let [tilt, _, yaw, _, spin, _] = found.at(&motion, t);
                for (i, name) in SHAKEN_PARAMETERS.iter().enumerate().skip(6) {
                    let size = size_of(i, &case.numbers);
                    let heading = size * (yaw[i].abs() + spin[i].abs());
                    assert!(
                        heading < 1e-7,
                        "{:?} by {name} at {t} s: {heading}",
                        case.law
                    );
                    assert!(
                        (size * tilt[i]).abs() < 10.0,
                        "{:?} by {name}: {}",
                        case.law,
                        tilt[i]
                    );
                }
            }
        }
    }
}

/// Planar motions come down flat. Beside the plane they do not, so there is no derivative by what takes the motion out of
/// it. Neighbouring motions turned by another yaw are planar only within rounding, so they have no differences by it.
#[test]
fn a_body_that_comes_down_flat_has_derivatives_in_its_plane() {
    let planar = || Ground::pulses(vec![sine([3.4, 0.0, 0.0], 0.9, 3.0)]).unwrap();
    let leaning = [0.05, 0.0, 0.0, 0.0, 0.2, 0.0];
    let no_slip = FrictionLaw::NoSlip;
    let beside = ["yaw", "yaw_rate", "spin_rate"];
    let housner = FlatLanding::Housner;
    for (flat, law, state) in [
        (housner, no_slip.clone(), leaning),
        (housner, no_slip.clone(), STANDING),
        (
            FlatLanding::Restitution(0.8),
            FrictionLaw::InPlace,
            STANDING,
        ),
        (FlatLanding::Smooth(Side::Left), no_slip.clone(), leaning),
        (FlatLanding::Smooth(Side::Drawn(3)), no_slip, leaning),
    ] {
        let case = Case {
            flat,
            duration: 1.2,
            times: [0.3, 0.7, 1.1],
            ..Case::new("flat", law, planar(), state, &column())
        };
        let motion = case.motion(&case.numbers);
        assert!(kinds(&motion).contains(&"face_down"));
        let without: &[&str] = if state == STANDING {
            &NOT_STANDING
        } else {
            &beside
        };
        assert_eq!(case.compare(&["yaw"]), without, "{flat:?}");
    }
    // Without friction the body falls on a table that shakes as on one at rest, whatever the direction.
    let case = Case {
        flat: FlatLanding::Smooth(Side::Right),
        ..Case::new(
            "frictionless",
            FrictionLaw::Frictionless,
            two_sines(),
            LEANING,
            &column(),
        )
    };
    assert!(kinds(&case.motion(&case.numbers)).contains(&"face_down"));
    assert_eq!(case.compare(&[]), ["yaw_rate", "spin_rate"]);
}

/// Housner's impacts bring a column to rest on its base, from which a second pulse lifts it.
#[test]
fn a_body_that_stands_again_keeps_its_derivatives() {
    let mut samples = vec![[0.0; 3]; 8001];
    for start in [200, 6000] {
        for (k, sample) in samples[start..start + 61].iter_mut().enumerate() {
            sample[0] = 3.5 * libm::sin(core::f64::consts::PI * k as f64 / 60.0);
        }
    }
    let case = Case {
        duration: 32.0,
        flat: FlatLanding::Housner,
        times: [1.2, 25.0, 30.2],
        // The many impacts amplify the rounding errors of derivatives across the plane.
        accuracy: 1e-5,
        ..Case::new(
            "stands",
            FrictionLaw::NoSlip,
            Ground::sampled(0.005, samples).unwrap(),
            STANDING,
            &column(),
        )
    };
    let motion = case.motion(&case.numbers);
    let names = kinds(&motion);
    let count = |kind| names.iter().filter(|name| **name == kind).count();
    assert_eq!((count("uplift"), count("stand")), (2, 1));
    // Each of these motions takes thousands of steps, and others of the tests vary the other parameters.
    let excepted = [
        "yaw",
        "spin",
        "mass",
        "transverse_inertia",
        "axial_inertia",
        "gravity",
    ];
    assert_eq!(case.compare(&excepted), NOT_STANDING);
}

/// A body whose wobble has ended stands, and the table's acceleration lifts it in the same moment, which depends on the
/// parameters.
#[test]
fn a_body_that_stands_for_no_time_is_lifted_at_a_time_with_derivatives() {
    let push = Pulse {
        amplitude: [-4.0, 0.0, -2.0],
        shape: Shape::Constant,
        duration: 1.0,
    };
    let body = Body::new(109.0, 0.0555, 0.0586, 0.0695, 0.0816).unwrap();
    let state = [0.0305, 0.00958, 0.815, -0.0798, 2.07, 0.617];
    let mut case = Case {
        duration: 0.4,
        flat: FlatLanding::Smooth(Side::Right),
        times: [0.1, 0.2, 0.35],
        accuracy: 1e-4,
        ..Case::new(
            "stands for no time",
            FrictionLaw::NoSlip,
            Ground::pulses(vec![push]).unwrap(),
            state,
            &body,
        )
    };
    case.law.resistance.rolling.dry = 0.003;
    let gravity = SHAKEN_PARAMETERS.iter().position(|name| *name == "gravity");
    case.numbers[gravity.unwrap()] = 5.866;
    let motion = case.motion(&case.numbers);
    let times = ["stand", "uplift"].map(|kind| {
        let mut events = motion.events.iter();
        events.find(|event| event.kind.name() == kind).unwrap().at.t
    });
    assert_eq!(times[0], times[1]);
    case.compare(&["mass", "spin"]);
}

/// A constant vertical acceleration is another gravity.
#[test]
fn the_scale_of_a_vertical_acceleration_acts_as_gravity() {
    let upward = Pulse {
        amplitude: [0.0, 0.0, 1.5],
        shape: Shape::Constant,
        duration: 10.0,
    };
    let ground = Ground::pulses(vec![upward]).unwrap();
    for law in [FrictionLaw::NoSlip, FrictionLaw::Frictionless] {
        let case = Case::new("vertical", law, ground.clone(), WOBBLING, &can());
        for slope in case.slopes(&case.motion(&case.numbers)) {
            let [.., gravity, scale] = slope;
            let rounding = 1e-9 * scaled_size(&slope, &case.numbers);
            assert!(
                (scale - 1.5 * gravity).abs() < rounding,
                "{scale} {gravity}"
            );
        }
    }
}

/// Without friction horizontal shaking turns nothing, and the body stays behind by the displacement of the table.
#[test]
fn without_friction_the_scale_moves_the_body_and_turns_nothing() {
    let (amplitude, period, duration) = (3.0, 1.2, 1.9);
    let pulse = sine([amplitude, 0.5 * amplitude, 0.0], period, 10.0);
    let ground = Ground::pulses(vec![pulse]).unwrap();
    let rate = core::f64::consts::TAU / period;
    let moved = amplitude / rate * (duration - libm::sin(rate * duration) / rate);
    for state in [WOBBLING, STANDING] {
        let law = FrictionLaw::Frictionless;
        let case = Case::new("frictionless", law, ground.clone(), state, &can());
        let slopes = case.slopes(&case.motion(&case.numbers));
        for (i, slope) in slopes.iter().enumerate() {
            let scale = slope[SHAKEN_PARAMETERS.len() - 1];
            let expected = match i {
                19 => -moved,
                20 => -0.5 * moved,
                _ => 0.0,
            };
            assert!((scale - expected).abs() < 1e-10, "{i}: {scale} {expected}");
        }
    }
}

/// A sine lifts a body where A sin ωt = gR/H, so that dt/ds = −tan(ωt)/ω, and −H dt/dH = R dt/dR = tan(ωt)/ω.
#[test]
fn the_time_of_uplift_follows_from_the_limit_of_standing() {
    let ground = Ground::pulses(vec![sine([4.0, 0.0, 0.0], 1.2, 1.0)]).unwrap();
    let case = Case::new("sine", FrictionLaw::NoSlip, ground, STANDING, &column());
    let motion = case.motion(&case.numbers);
    let found = derivatives(&motion).uplift_time().unwrap();
    let rate = core::f64::consts::TAU / 1.2;
    let expected = libm::tan(rate * motion.events[0].at.t) / rate;
    let [.., r, h, _, _, g, scale] = found;
    for (found, sign) in [
        (0.5 * r, 1.0),
        (2.0 * h, -1.0),
        (9.81 * g, 1.0),
        (scale, -1.0),
    ] {
        assert!(
            (found - sign * expected).abs() < 1e-13,
            "{found} {expected}"
        );
    }
}

/// At a corner at a fixed time the rates jump, but not the derivatives. A corner between two halves of the same sine
/// pulse changes nothing, and one where the acceleration jumps leaves them continuous.
#[test]
fn derivatives_are_continuous_at_corners() {
    let pulse = Pulse {
        amplitude: [2.0, 1.0, 0.5],
        shape: Shape::Constant,
        duration: 0.7,
    };
    let ground = Ground::pulses(vec![pulse]).unwrap();
    let case = Case::new("corner", FrictionLaw::NoSlip, ground, WOBBLING, &can());
    let motion = case.motion(&case.numbers);
    let sensitivity = derivatives(&motion);
    let [before, after] = [0.7 - 1e-9, 0.7 + 1e-9].map(|t| sensitivity.at(&motion, t));
    for (before, after) in before.iter().zip(&after) {
        let size = scaled_size(after, &case.numbers);
        for i in 0..SHAKEN_PARAMETERS.len() {
            let change = (after[i] - before[i]) * size_of(i, &case.numbers);
            // In 2e-9 s they change by about 1e-7 of their size.
            assert!(change.abs() < 1e-5 * size, "{change} {size}");
        }
    }
}

#[test]
fn motions_without_derivatives_are_refused() {
    let planar = Ground::pulses(vec![sine([3.4, 0.0, 0.0], 0.9, 3.0)]).unwrap();
    let leaning = [0.05, 0.0, 0.0, 0.0, 0.2, 0.0];
    let case = Case {
        flat: FlatLanding::Smooth(Side::Left),
        ..Case::new(
            "flat",
            FrictionLaw::coulomb(20.0),
            planar,
            leaning,
            &column(),
        )
    };
    let refusal = case.motion(&case.numbers).shaken_sensitivity(|_| CONTINUE);
    let refusal = refusal.err().expect("friction stays on").to_string();
    assert!(refusal.contains("smoothly under friction"), "{refusal}");
}
