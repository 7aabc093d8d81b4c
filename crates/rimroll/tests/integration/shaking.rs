//! Motions on a table that moves.

use proptest::prelude::*;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::{
    AirDrag, Coulomb, PivotingFriction, Resistance, RollingResistance, Stribeck, Tabulated, Viscous,
};
use rimroll::motion::{COLUMNS, FlatLanding, Side};
use rimroll::turn::turn_limit;
use rimroll::{
    Body, ContactLaw, FrictionLaw, Motion, Options, State, Status, presets, simulate, simulate_on,
};
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::given::bodies;
use crate::given::cases;
use bodies::{any_body, powers_of_ten};
use cases::cases;

/// A solid stone cylinder of 1000 kg, 4 m high.
fn column() -> Body {
    Body::new(1000.0, 0.5, 2.0, 1_395.833_333_333_333_3, 125.0).unwrap()
}

/// A sine pulse.
fn sine(amplitude: [f64; 3], period: f64, cycles: f64) -> Pulse {
    Pulse {
        amplitude,
        shape: Shape::Sine { period },
        duration: cycles * period,
    }
}

/// A constant acceleration for a time, s.
fn constant(amplitude: [f64; 3], duration: f64) -> Arc<Ground> {
    ground(vec![Pulse {
        amplitude,
        shape: Shape::Constant,
        duration,
    }])
}

fn ground(pulses: Vec<Pulse>) -> Arc<Ground> {
    Arc::new(Ground::pulses(pulses).unwrap())
}

/// The pulse of the first reference motion.
fn two_sines() -> Vec<Pulse> {
    vec![
        sine([3.0, 0.0, 0.0], 1.2, 1.0),
        sine([0.0, 1.5, 0.0], 0.8, 1.0),
    ]
}

fn tight(duration: f64) -> Options {
    Options {
        duration,
        gravity: 9.81,
        rtol: 1e-12,
        ..Options::default()
    }
}

fn shaken(
    ground: Arc<Ground>,
    body: &Body,
    start: &State,
    law: impl Into<ContactLaw>,
    options: &Options,
) -> Motion {
    let watch = |_| ControlFlow::Continue(());
    let law = law.into();
    let start = allowed(start, &law);
    simulate_on(Some(ground), body, &start, law, options, watch).unwrap()
}

/// The start with the spin rate that the law demands, where it does.
fn allowed(start: &State, law: &ContactLaw) -> State {
    let mut start = *start;
    if law.friction == FrictionLaw::InPlace {
        start.spin_rate = -start.yaw_rate;
    }
    start
}

fn leaning() -> State {
    State {
        tilt: 0.05,
        yaw: 0.3,
        ..State::default()
    }
}

/// A quantity at a time, s.
fn value(motion: &Motion, t: f64, column: &str) -> f64 {
    let index = COLUMNS.iter().position(|name| *name == column).unwrap();
    motion.observables(&motion.trajectory.at(t))[index]
}

/// The reference values of a case: column, time, value.
fn references(case: &str) -> Vec<(String, f64, f64)> {
    let table = include_str!("given/shaken_motions.csv");
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<&str> = lines.next().unwrap().split(',').skip(2).collect();
    let mut values = Vec::new();
    for line in lines {
        let mut entries = line.split(',');
        if entries.next() == Some(case) {
            let t: f64 = entries.next().unwrap().parse().unwrap();
            for (column, entry) in columns.iter().zip(entries) {
                values.push(((*column).to_owned(), t, entry.parse().unwrap()));
            }
        }
    }
    assert!(!values.is_empty());
    values
}

/// The reference motions have 13 digits; 2e-12 leaves room for the digits of the yaw rate, which is up to 8 rad/s.
fn compare_with_references(case: &str, motion: &Motion, body: &Body) {
    let rho = body.radius() * libm::cos(0.05) - body.height() * libm::sin(0.05);
    for (column, t, expected) in references(case) {
        let found = match column.as_str() {
            "x" => value(motion, t, "x") + rho * libm::cos(0.3),
            "y" => value(motion, t, "y") + rho * libm::sin(0.3),
            "normal_over_weight" => value(motion, t, "normal_force") / (body.mass() * 9.81),
            other => value(motion, t, other),
        };
        let error = (found - expected).abs();
        assert!(error < 2e-12, "{column} at {t} s: {found}, not {expected}");
    }
}

#[test]
fn a_column_rolls_as_in_the_reference_motions() {
    let vertical = sine([0.0, 0.0, 2.0], 0.5, 2.0);
    for (case, more) in [("s1", None), ("s2", Some(vertical))] {
        let pulses = two_sines().into_iter().chain(more).collect();
        let law = FrictionLaw::NoSlip;
        let motion = shaken(ground(pulses), &column(), &leaning(), law, &tight(2.6));
        compare_with_references(case, &motion, &column());
    }
}

#[test]
fn a_column_wobbles_in_place_as_in_the_reference_motion() {
    let law = FrictionLaw::InPlace;
    let motion = shaken(ground(two_sines()), &column(), &leaning(), law, &tight(2.6));
    compare_with_references("s6", &motion, &column());
}

/// A record with a straight line between samples gives the same motion as the sum of its parts: here one line of
/// 0.5 s, cut into samples of 0.01 s, under every law.
#[test]
fn corners_without_a_kink_change_nothing() {
    let samples = |count: i32| {
        let sample = |i| {
            let t = 0.5 * f64::from(i) / f64::from(count);
            [1.0 + 2.0 * t, -0.5 + 3.0 * t, 1.5 * t]
        };
        let step = 0.5 / f64::from(count);
        Arc::new(Ground::sampled(step, (0..=count).map(sample).collect()).unwrap())
    };
    // The tests of the energy budget follow the other resistances.
    let without = |law: &ContactLaw| law.resistance.is_none();
    for law in laws()
        .into_iter()
        .filter(without)
        .chain([laws().swap_remove(1)])
    {
        let [one, many] = [1, 50]
            .map(|count| shaken(samples(count), &can(), &tipped(), law.clone(), &tight(0.6)));
        for column in ["tilt", "yaw", "spin", "x", "y", "ground_work"] {
            for t in [0.1, 0.3, 0.5, 0.6] {
                let [a, b] = [&one, &many].map(|motion| value(motion, t, column));
                let allowed = 1e-8 * (1.0 + a.abs());
                assert!(
                    (a - b).abs() < allowed,
                    "{law:?}: {column} at {t} s: {a} and {b}"
                );
            }
        }
    }
}

fn can() -> Body {
    presets::can_2007().unwrap()
}

fn tipped() -> State {
    State {
        tilt: 0.4,
        tilt_rate: -0.2,
        yaw: 0.7,
        yaw_rate: 0.4,
        spin_rate: -0.3,
        ..State::default()
    }
}

/// A contact law of each kind, without and with resistance.
fn laws() -> Vec<ContactLaw> {
    let frictions: [FrictionLaw; 6] = [
        FrictionLaw::NoSlip,
        FrictionLaw::Frictionless,
        FrictionLaw::InPlace,
        Coulomb::uniform(0.25).into(),
        Viscous { coefficient: 0.3 }.into(),
        Stribeck {
            friction: 0.2,
            static_friction: 0.3,
            stribeck_speed: 0.05,
            creep_speed: 0.01,
        }
        .into(),
    ];
    let resistance = Resistance {
        rolling: RollingResistance {
            dry: 1e-3,
            viscous: 1e-4,
        },
        pivoting: PivotingFriction { length: 1e-4 },
        air: AirDrag::default(),
    };
    let with_resistance = |friction: &FrictionLaw| ContactLaw {
        resistance,
        ..friction.clone().into()
    };
    frictions
        .iter()
        .flat_map(|friction| [friction.clone().into(), with_resistance(friction)])
        .collect()
}

/// The sum of energies and losses less the work of the ground, which does not change, over the largest of them.
fn imbalance(motion: &Motion) -> f64 {
    let budget = |instant: rimroll::motion::Instant| {
        let moment = motion.observables(&instant);
        let number = |name| moment[COLUMNS.iter().position(|column| *column == name).unwrap()];
        let energy = number("kinetic_energy") + number("potential_energy");
        let losses = number("friction_loss") + number("resistance_loss") + number("impact_loss");
        let work = number("ground_work");
        (energy + losses - work, energy.abs() + losses + work.abs())
    };
    let nodes: Vec<_> = motion.trajectory.nodes().map(budget).collect();
    let size = nodes.iter().map(|node| node.1).fold(0.0, f64::max);
    let start = nodes[0].0;
    nodes
        .iter()
        .map(|node| (node.0 - start).abs())
        .fold(0.0, f64::max)
        / size.max(f64::MIN_POSITIVE)
}

#[test]
fn the_energy_budget_closes_under_every_law() {
    for law in laws() {
        let vertical = sine([1.0, 0.0, 3.0], 0.3, 3.0);
        let pulses = two_sines().into_iter().chain([vertical]).collect();
        let motion = shaken(ground(pulses), &can(), &tipped(), law.clone(), &tight(2.0));
        let error = imbalance(&motion);
        assert!(error < 1e-9, "{law:?}: {error:e}");
        assert!(value(&motion, 0.2, "ground_work") != 0.0);
    }
}

/// A table falls away under a body, at twice the acceleration of a free fall, and then keeps its velocity. The bounces of the level
/// base are a geometric series, whatever their number.
#[test]
fn a_level_base_bounces_until_its_bounces_have_vanished() {
    let (g, falls) = (9.81, 0.05);
    for restitution in [0.0, 0.2, 0.58, 0.89, 0.97] {
        let law = ContactLaw {
            restitution,
            ..FrictionLaw::coulomb(0.4).into()
        };
        let table = constant([0.0, 0.0, -2.0 * g], falls);
        let motion = shaken(table, &column(), &State::standing(), law, &tight(12.0));
        let times: Vec<_> = (motion.events.iter())
            .filter(|event| event.kind.name() == "land")
            .map(|event| event.at.t)
            .collect();
        let speed = 2.0_f64.sqrt() * g * falls;
        let first = falls * (2.0 + 2.0_f64.sqrt());
        let last = first + 2.0 * speed / g * restitution / (1.0 - restitution);
        assert!((times[0] - first).abs() < 1e-12, "{}", times[0]);
        let end = times[times.len() - 1];
        assert!((end - last).abs() < 1e-7, "{restitution}: {end} not {last}");
    }
}

/// A body that is only just lifted has little energy when resistance lets its base fall flat. The table works on it until
/// then.
#[test]
fn the_energy_budget_closes_as_resistance_lets_a_base_fall_flat() {
    let mut stood = 0;
    for (slenderness, above, viscous) in [
        (0.5, 1.02, 1e-3),
        (1.5, 1.05, 1e-3),
        (2.0, 1.1, 1e-2),
        (4.0, 1.03, 1e-4),
        (4.0, 1.2, 1e-2),
    ] {
        let (r, h) = (0.3, 0.3 * slenderness);
        let body = Body::new(2.0, r, h, 2.0 * (0.25 * r * r + h * h / 3.0), r * r).unwrap();
        for friction in [FrictionLaw::NoSlip, FrictionLaw::coulomb(3.0)] {
            let rolling = RollingResistance { dry: 0.0, viscous };
            let resistance = Resistance {
                rolling,
                ..Resistance::default()
            };
            let law = ContactLaw {
                resistance,
                ..friction.into()
            };
            let amplitude = above * 9.81 / slenderness;
            let shaking = vec![sine([0.6 * amplitude, 0.8 * amplitude, 0.0], 0.4, 1.5)];
            let motion = shaken(ground(shaking), &body, &State::standing(), law, &tight(1.0));
            stood += motion
                .events
                .iter()
                .filter(|one| one.kind.name() == "stand")
                .count();
            let error = imbalance(&motion);
            assert!(error < 1e-7, "{slenderness} {above} {viscous}: {error:e}");
        }
    }
    assert!(stood > 10, "{stood}");
}

/// A rim that slides as resistance lets its base fall flat is turned by friction until then, and held by resistance.
#[test]
fn the_energy_budget_closes_as_a_sliding_base_falls_flat() {
    let frictions = [
        FrictionLaw::coulomb(0.3),
        Viscous { coefficient: 5.0 }.into(),
        Viscous { coefficient: 0.5 }.into(),
    ];
    let flats = [FlatLanding::Housner, FlatLanding::Restitution(0.4)];
    let mut landings = 0;
    for case in 0..180 {
        let part = |n: usize, step: usize| (case / step % n) as f64;
        let (r, slenderness, spin) = (0.12, [0.5, 2.0, 4.0][case % 3], part(5, 3) - 2.1);
        let h = r * slenderness;
        let body = Body::new(1.0, r, h, 0.25 * r * r + h * h / 3.0, 0.4 * r * r).unwrap();
        let rate = (9.81 / r).sqrt();
        let start = State {
            tilt: (0.02 + 0.05 * part(2, 15)) * libm::atan(r / h),
            tilt_rate: -0.05 * rate,
            yaw_rate: 0.3 * rate,
            spin_rate: 0.5 * spin * rate,
            ..State::default()
        };
        let rolling = RollingResistance {
            dry: 1e-3,
            viscous: 0.0,
        };
        let law = ContactLaw {
            resistance: Resistance {
                rolling,
                ..Resistance::default()
            },
            ..frictions[case / 30 % 3].clone().into()
        };
        let options = Options {
            flat: flats[case / 90],
            ..tight(6.0 / rate)
        };
        let motion = shaken(ground(two_sines()), &body, &start, law, &options);
        landings += motion
            .events
            .iter()
            .filter(|one| one.kind.name() == "face_down")
            .count();
        let error = imbalance(&motion);
        assert!(error < 1e-7, "{case}: {error:e}");
    }
    assert!(landings > 100, "{landings}");
}

#[test]
fn a_body_without_friction_stays_behind_and_does_not_turn() {
    let a = [2.0, -3.0, 0.0];
    let options = tight(1.5);
    let law = FrictionLaw::Frictionless;
    let motion = shaken(constant(a, 10.0), &can(), &tipped(), law.clone(), &options);
    let watch = |_| ControlFlow::Continue(());
    let at_rest = simulate(&can(), &tipped(), law, &options, watch).unwrap();
    for t in [0.1, 0.5, 1.0, 1.5] {
        for column in ["tilt", "yaw", "spin", "tilt_rate", "normal_force"] {
            let [found, expected] = [&motion, &at_rest].map(|motion| value(motion, t, column));
            let allowed = 1e-10 * (1.0 + expected.abs());
            assert!(
                (found - expected).abs() < allowed,
                "{column}: {found}, {expected}"
            );
        }
        for (i, column) in [(0, "x"), (1, "y")] {
            let (found, expected) = (value(&motion, t, column), -0.5 * a[i] * t * t);
            assert!(
                (found - expected).abs() < 1e-10,
                "{column}: {found}, {expected}"
            );
        }
    }
}

#[test]
fn a_constant_horizontal_acceleration_has_a_potential() {
    for law in laws() {
        let a = [1.5, -0.8, 0.0];
        let motion = shaken(
            constant(a, 10.0),
            &can(),
            &tipped(),
            law.clone(),
            &tight(1.0),
        );
        for t in [0.2, 0.6, 1.0] {
            let [x, y] = ["x", "y"].map(|column| value(&motion, t, column));
            let expected = -can().mass() * (a[0] * x + a[1] * y);
            let work = value(&motion, t, "ground_work");
            assert!(
                (work - expected).abs() < 1e-11,
                "{law:?}: {work}, not {expected}"
            );
        }
    }
}

#[test]
fn a_constant_vertical_acceleration_is_another_gravity() {
    // The smooth sign in resistances has a width of √(g/R)/1000, which is not that of the larger gravity.
    for law in laws().into_iter().filter(|law| law.resistance.is_none()) {
        let ground = constant([0.0, 0.0, 2.5], 10.0);
        let motion = shaken(ground, &can(), &tipped(), law.clone(), &tight(1.5));
        let options = Options {
            gravity: 9.81 + 2.5,
            ..tight(1.5)
        };
        let watch = |_| ControlFlow::Continue(());
        let heavier = simulate(
            &can(),
            &allowed(&tipped(), &law),
            law.clone(),
            &options,
            watch,
        )
        .unwrap();
        for t in [0.1, 0.7, 1.5] {
            for column in ["tilt", "yaw", "spin", "x", "y"] {
                let [a, b] = [&motion, &heavier].map(|motion| value(motion, t, column));
                let error = (a - b).abs() / (1.0 + b.abs());
                assert!(error < 1e-9, "{law:?}: {column} at {t} s: {a}, {b}");
            }
        }
    }
}

/// A body that is larger by L, and times longer by √L, under the same accelerations.
#[test]
fn larger_bodies_move_alike_in_longer_times() {
    const L: f64 = 3.7;
    let small = column();
    let (m, r, h) = (small.mass(), L * small.radius(), L * small.height());
    let [a, c] = [small.transverse_inertia(), small.axial_inertia()].map(|inertia| L * L * inertia);
    let large = Body::new(m, r, h, a, c).unwrap();
    let slower = |pulse: Pulse, factor: f64| match pulse.shape {
        Shape::Sine { period } => sine(pulse.amplitude, factor * period, pulse.duration / period),
        _ => pulse,
    };
    for law in [
        FrictionLaw::NoSlip,
        FrictionLaw::InPlace,
        FrictionLaw::coulomb(0.2),
    ] {
        let [fast, slow] = [(small, 1.0), (large, L.sqrt())].map(|(body, factor)| {
            let pulses = two_sines().into_iter().map(|pulse| slower(pulse, factor));
            let options = tight(2.0 * factor);
            shaken(
                ground(pulses.collect()),
                &body,
                &leaning(),
                law.clone(),
                &options,
            )
        });
        for t in [0.4, 1.0, 1.6, 2.0] {
            for column in ["tilt", "yaw", "spin"] {
                let (a, b) = (value(&fast, t, column), value(&slow, L.sqrt() * t, column));
                assert!(
                    (a - b).abs() < 1e-8,
                    "{law:?}: {column} at {t} s: {a} and {b}"
                );
            }
        }
    }
}

/// A step of the acceleration makes a rim slip or leave the table at once.
#[test]
fn a_jump_of_the_acceleration_changes_the_contact_at_once() {
    let law = FrictionLaw::coulomb(0.3);
    let later = |amplitude| {
        let mut samples = vec![[0.0; 3]; 11];
        samples.push(amplitude);
        samples.extend(vec![amplitude; 20]);
        Arc::new(Ground::sampled(0.01, samples).unwrap())
    };
    let phase = |ground, t| {
        let motion = shaken(ground, &column(), &leaning(), law.clone(), &tight(0.3));
        motion.trajectory.at(t).phase.name()
    };
    assert_eq!(phase(later([0.0; 3]), 0.15), "rolling");
    assert_eq!(phase(later([12.0, 0.0, 0.0]), 0.15), "sliding");
    assert_eq!(phase(later([0.0, 0.0, -12.0]), 0.15), "flying");
}

/// Two constant accelerations, of which one ends while the other goes on.
#[test]
fn a_jump_changes_the_contact_at_the_very_time_of_the_jump() {
    const JUMP: f64 = 0.1537;
    let jumping = |a: [f64; 3]| {
        let balanced = constant(a, JUMP).scaled(-1.0);
        Arc::new(constant(a, 1.0).plus(&balanced).unwrap())
    };
    let contact = |a, law: FrictionLaw| {
        let motion = shaken(jumping(a), &column(), &leaning(), law, &tight(0.3));
        let changes = motion.events.iter();
        let times = changes.filter(|event| matches!(event.kind.name(), "slip" | "lift_off"));
        times.map(|event| event.at.t).next()
    };
    let dry = FrictionLaw::coulomb(0.3);
    assert_eq!(contact([12.0, 5.0, 0.0], dry.clone()), Some(JUMP));
    for law in [dry, FrictionLaw::NoSlip, FrictionLaw::InPlace] {
        assert_eq!(contact([0.0, 1.0, -12.0], law), Some(JUMP));
    }
}

fn any_law() -> impl Strategy<Value = ContactLaw> {
    let all = laws();
    let dry = (0.0..1.5).prop_map(|friction| FrictionLaw::coulomb(friction).into());
    prop_oneof![1 => prop::sample::select(all), 2 => dry]
}

fn any_vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    let component = move || prop_oneof![1 => Just(0.0), 4 => -size..size];
    (component(), component(), component()).prop_map(|(x, y, z)| [x, y, z])
}

fn any_pulse() -> impl Strategy<Value = Pulse> {
    let shape = prop_oneof![
        Just(Shape::Constant),
        (0.05..2.0).prop_map(|period| Shape::Sine { period }),
        (0.05..2.0).prop_map(|period| Shape::Cosine { period }),
        (0.05..2.0).prop_map(|period| Shape::Ricker {
            period,
            center: 1.5 * period
        }),
    ];
    (any_vector(15.0), shape, 0.01..3.0).prop_map(|(amplitude, shape, duration)| Pulse {
        amplitude,
        shape,
        duration,
    })
}

/// Pulses, and records of two samples and more: of noise with spikes of 100 g, with free fall and faster, and with zeros.
/// Some are zero or in free fall throughout.
fn any_ground() -> impl Strategy<Value = Arc<Ground>> {
    let pulses = prop::collection::vec(any_pulse(), 0..4).prop_map(ground);
    let sample = || {
        prop_oneof![
            8 => any_vector(5.0),
            1 => any_vector(981.0),
            1 => Just([0.0, 0.0, -9.81]),
            1 => Just([0.0, 0.0, -15.0]),
            1 => Just([0.0; 3]),
        ]
    };
    let samples = prop_oneof![
        8 => prop::collection::vec(sample(), 2..120),
        2 => prop::collection::vec(sample(), 2..4),
        1 => Just(vec![[0.0; 3]; 20]),
        1 => Just(vec![[0.0, 0.0, -9.81]; 20]),
    ];
    let record = (powers_of_ten(-3.0, 0.0), samples)
        .prop_map(|(step, samples)| Arc::new(Ground::sampled(step, samples).unwrap()));
    prop_oneof![pulses, record]
}

proptest! {
    #![proptest_config(cases(60))]

    /// No panic, no endless loop and no number that is not finite; the energy budget closes, and the ending is that of
    /// the last moment.
    #[test]
    fn any_body_on_any_ground_ends_in_a_truthful_way(
        (body, law, ground) in (any_body(), any_law(), any_ground()),
        (tilt, yaw) in (0.001..1.4, -3.0..3.0),
        (p, w, s) in (-2.0..2.0, -2.0..2.0, -2.0..2.0),
    ) {
        let start = State { tilt, tilt_rate: p, yaw, yaw_rate: w, spin: 0.0, spin_rate: s };
        let options = Options { duration: 2.0, gravity: 9.81, rtol: 1e-10, max_steps: 20_000, ..Options::default() };
        let motion = shaken(ground, &body, &start, law.clone(), &options);
        expect_truthful_ending(&motion, &body, &law, &options);
    }

    /// Bodies that come down flat or stand at the start also end in a truthful way.
    #[test]
    fn any_flat_landing_on_any_ground_ends_in_a_truthful_way(
        (body, law, ground) in (any_body(), any_law(), any_ground()),
        (stands, flat) in (any::<bool>(), any_flat_landing()),
        (tilt, yaw, p) in (powers_of_ten(-3.0, 0.1), -3.0..3.0, -2.0..2.0),
    ) {
        let planar = State { tilt, tilt_rate: p, yaw, ..State::default() };
        let start = if stands { State { yaw, ..State::standing() } } else { planar };
        let options = Options { flat, duration: 2.0, gravity: 9.81, rtol: 1e-10, max_steps: 20_000, ..Options::default() };
        let motion = shaken(ground.clone(), &body, &start, law.clone(), &options);
        expect_truthful_ending(&motion, &body, &law, &options);
        expect_rest_where_it_stands(&motion, &ground, &body, &law);
    }
}

fn any_flat_landing() -> impl Strategy<Value = FlatLanding> {
    let side = prop_oneof![
        Just(Side::Left),
        Just(Side::Right),
        any::<u64>().prop_map(Side::Drawn)
    ];
    prop_oneof![
        Just(FlatLanding::Stop),
        side.prop_map(FlatLanding::Smooth),
        Just(FlatLanding::Housner),
        Just(FlatLanding::Restitution(0.0)),
        Just(FlatLanding::Restitution(1.0)),
        (0.0..1.0).prop_map(FlatLanding::Restitution),
    ]
}

/// The numbers are finite, the rim is not under the table, the energy budget closes, and the status is that of the last
/// moment.
fn expect_truthful_ending(motion: &Motion, body: &Body, law: &ContactLaw, options: &Options) {
    let message = motion.message();
    let column = |name: &str| COLUMNS.iter().position(|column| *column == name).unwrap();
    for node in motion.trajectory.nodes() {
        let moment = motion.observables(&node);
        assert!(
            moment[..8].iter().all(|number| number.is_finite()),
            "{message}"
        );
        assert!((0.0..=options.duration).contains(&node.t), "{message}");
        let gap = moment[column("gap")];
        assert!(gap > -1e-8 * body.radius(), "{gap:e}: {message}");
    }
    let end = motion.trajectory.end();
    let tilt = motion.observables(&end)[column("tilt")];
    let (flies, is_dry) = match law.friction {
        FrictionLaw::NoSlip | FrictionLaw::Frictionless | FrictionLaw::InPlace => (false, false),
        FrictionLaw::Viscous(_) => (true, false),
        _ => (true, true),
    };
    match motion.status {
        Status::Finished => assert_eq!(end.t, options.duration),
        // By default a body topples on its side, and a disk never does.
        Status::Toppled => assert!(
            body.height() > 0.0 && tilt > core::f64::consts::FRAC_PI_2 - 1e-9,
            "{tilt}: {message}"
        ),
        Status::FaceDown => assert!(libm::sin(tilt) < 1e-6, "{tilt}: {message}"),
        Status::LiftedOff => assert!(!flies, "{message}"),
        Status::Painleve => assert!(is_dry, "{message}"),
        // Out of steps: a light wobble can take thousands of turns, each of which takes some tens of steps.
        Status::Failed => assert!(
            is_dry || motion.work.steps < 200 * motion.events.len(),
            "{} events: {message}",
            motion.events.len()
        ),
        Status::AtRest | Status::Interrupted => panic!("{message}"),
    }
    if motion.status != Status::Failed {
        let error = imbalance(motion);
        assert!(error < 1e-6, "{error:e}: {message}");
    }
}

/// A body that stands does not move, and neither does the table move it.
fn expect_rest_where_it_stands(motion: &Motion, ground: &Ground, body: &Body, law: &ContactLaw) {
    // Times of departure have errors, and accelerations change by up to 2 · 981 m/s² within 1 ms.
    const ALLOWED: f64 = 1e-6;
    let nodes: Vec<_> = motion.trajectory.nodes().collect();
    for pair in nodes.windows(2) {
        if pair[1].phase.name() != "standing" || pair[0].t == pair[1].t {
            continue;
        }
        for i in 1..40 {
            let t = pair[0].t + (pair[1].t - pair[0].t) * f64::from(i) / 40.0;
            let at = motion.trajectory.at(t);
            assert_eq!(at.phase.name(), "standing");
            for column in ["tilt", "tilt_rate", "kinetic_energy", "slip_x", "slip_y"] {
                assert!(
                    value(motion, t, column) == 0.0,
                    "{column}: {}",
                    motion.message()
                );
            }
            let [x, y, z] = ground.acceleration(t);
            let (horizontal, gravity) = (libm::hypot(x, y), 9.81 + z);
            assert!(gravity > -ALLOWED, "{gravity}");
            assert!(horizontal * body.height() < gravity * body.radius() + ALLOWED);
            if let FrictionLaw::Coulomb(dry) = &law.friction {
                assert!(horizontal < dry.static_friction * gravity + ALLOWED);
            }
        }
    }
}

fn overturns(body: &Body, gravity: f64, amplitude: f64, duration: f64) -> bool {
    let ground = constant([amplitude, 0.0, 0.0], duration);
    let options = Options {
        topple_tilt: Some(0.9),
        gravity,
        ..tight(60.0)
    };
    let motion = shaken(
        ground,
        body,
        &State::standing(),
        FrictionLaw::NoSlip,
        &options,
    );
    assert!(
        matches!(motion.status, Status::Toppled | Status::FaceDown),
        "{}",
        motion.message()
    );
    motion.status == Status::Toppled
}

/// The least duration of a rectangular pulse that overturns a body that stands flat.
#[test]
fn rectangular_pulses_overturn_from_the_exact_duration_on() {
    let can = presets::can_2007().unwrap();
    // From quadrature of the planar motion: at the end of the pulse, the energy suffices to reach the balance tilt.
    for (body, gravity, factor, least) in [
        (column(), 9.81, 1.2, 0.944_283_985_340_178_3),
        (column(), 9.81, 1.5, 0.580_520_881_038_642_9),
        (can, 9.8, 2.0, 0.085_462_990_117_159_76),
    ] {
        let amplitude = factor * gravity * body.radius() / body.height();
        assert!(!overturns(&body, gravity, amplitude, least - 1e-9));
        assert!(overturns(&body, gravity, amplitude, least + 1e-9));
    }
}

fn event_times(motion: &Motion, kind: &str) -> Vec<f64> {
    let events = motion
        .events
        .iter()
        .filter(|event| event.kind.name() == kind);
    events.map(|event| event.at.t).collect()
}

/// a(t) = 3 sin(2πt/1.2) m/s² lifts the column where it reaches g R/H, and it turns about the side away from a.
#[test]
fn a_column_lifts_where_the_acceleration_reaches_the_limit() {
    for angle in [0.0, 0.8, -2.5] {
        let pulse = sine([3.0, 0.0, 0.0], 1.2, 1.0);
        let ground = Arc::new(Ground::pulses(vec![pulse]).unwrap().rotated(angle));
        let motion = shaken(
            ground,
            &column(),
            &State::standing(),
            FrictionLaw::NoSlip,
            &tight(0.5),
        );
        let expected = 1.2 / core::f64::consts::TAU * libm::asin(9.81 * 0.25 / 3.0);
        let found = event_times(&motion, "uplift");
        assert_eq!(found.len(), 1);
        assert!(
            (found[0] - expected).abs() < 2e-9,
            "{} {expected}",
            found[0]
        );
        assert!((value(&motion, 0.4, "yaw") - angle).abs() < 1e-12);
        assert!(value(&motion, 0.4, "tilt") > 1e-3);
        // Before, the table accelerates it by friction.
        let force = libm::hypot(
            value(&motion, 0.1, "friction_x"),
            value(&motion, 0.1, "friction_y"),
        );
        let needed = 1000.0 * 3.0 * libm::sin(core::f64::consts::TAU * 0.1 / 1.2);
        assert!((force - needed).abs() < 1e-9 * needed);
    }
}

/// Below the friction R/H a body slides flat; the slip follows from the impulse.
#[test]
fn a_slippery_column_slides_flat() {
    let (a, friction, pulse, g) = (2.0, 0.1, 0.5, 9.81);
    let ground = constant([a, 0.0, 0.0], pulse);
    let law = FrictionLaw::coulomb(friction);
    let motion = shaken(ground, &column(), &State::standing(), law, &tight(3.0));
    let speed = (a - friction * g) * pulse;
    let braking = speed / (friction * g);
    let distance = 0.5 * speed * pulse + 0.5 * speed * braking;
    assert!((value(&motion, pulse, "slip_x") + speed).abs() < 1e-9);
    assert!((value(&motion, 3.0, "x") + distance).abs() < 1e-9);
    let stops = event_times(&motion, "stick");
    assert!(
        stops.len() == 1 && (stops[0] - pulse - braking).abs() < 1e-6,
        "{stops:?}"
    );
    assert!(motion.status == Status::Finished && value(&motion, 3.0, "tilt") == 0.0);
    let lost = value(&motion, 3.0, "friction_loss");
    assert!((lost - friction * g * 1000.0 * distance).abs() < 1e-6 * lost);
    assert!(imbalance(&motion) < 1e-9);
}

/// The table falls away with 15 m/s² for 0.1 s, and the body lands on it again.
#[test]
fn a_body_leaves_a_table_that_falls_and_lands_on_it() {
    let ground = constant([0.5, 0.0, -15.0], 0.1);
    let law = FrictionLaw::coulomb(0.2);
    let motion = shaken(ground, &column(), &State::standing(), law, &tight(1.0));
    assert_eq!(event_times(&motion, "lift_off"), [0.0]);
    let (rise, speed) = (0.5 * 5.19 * 0.01, 5.19 * 0.1_f64);
    let expected = 0.1 + (speed + (speed * speed + 2.0 * 9.81 * rise).sqrt()) / 9.81;
    let landed = event_times(&motion, "land");
    assert!((landed[0] - expected).abs() < 1e-9, "{landed:?} {expected}");
    assert_eq!(motion.trajectory.end().phase.name(), "standing");
    assert!(imbalance(&motion) < 1e-9);
}

/// A disk cannot be lifted by a horizontal acceleration; without slip it stands until the table falls faster than g.
#[test]
fn a_disk_leaves_the_table_where_that_falls_faster_than_the_disk() {
    const STEP: f64 = 0.0443;
    let disk = Body::new(0.5, 0.1, 0.0, 1.25e-3, 2.5e-3).unwrap();
    let fall = vec![[0.0; 3], [-186.0, 306.0, -224.0]];
    let ground = Arc::new(Ground::sampled(STEP, fall).unwrap());
    let start = State::standing();
    let motion = shaken(ground, &disk, &start, FrictionLaw::NoSlip, &tight(1.0));
    assert_eq!(motion.status, Status::LiftedOff, "{}", motion.message());
    assert!((motion.trajectory.end().t - STEP * 9.81 / 224.0).abs() < 1e-12);
}

/// Where a record has −g at a sample and more before and after it, the body is free for a moment only.
#[test]
fn a_moment_of_free_fall_does_not_hold_a_motion_up() {
    let free = [0.0, 0.0, -9.81];
    let samples = vec![free, [3.0, 2.0, 0.5], free, [1.0, 0.0, 2.0], free];
    let ground = Arc::new(Ground::sampled(0.1, samples).unwrap());
    for friction in [0.2, 0.1] {
        let law = FrictionLaw::coulomb(friction);
        let start = State::standing();
        let motion = shaken(ground.clone(), &column(), &start, law, &tight(1.0));
        assert_eq!(motion.status, Status::Finished, "{}", motion.message());
        assert!(value(&motion, 0.3, "slip_x") < 0.0);
        assert!(imbalance(&motion) < 1e-9);
    }
}

/// The slip across the plane of such a motion is a rounding error, relative to which no step is accurate.
#[test]
fn planar_motions_of_a_rim_that_slides_take_few_steps() {
    let viscous = FrictionLaw::from(Viscous { coefficient: 300.0 });
    let (housner, half) = (FlatLanding::Housner, FlatLanding::Restitution(0.5));
    let smooth = FlatLanding::Smooth(Side::Left);
    for (amplitude, period, heading, flat, tilt, rtol) in [
        (3.9, 0.53, -0.58, housner, 0.05, 1e-7),
        (7.4, 0.37, 0.17, half, 0.05, 1e-6),
        (2.6, 0.67, 0.84, smooth, 0.2, 1e-12),
        (5.6, 1.64, -1.85, smooth, 0.05, 1e-12),
        (5.3, 1.75, 0.56, half, 0.0, 1e-12),
    ] {
        let pulse = sine([amplitude, 0.0, 0.0], period, 2.0);
        let ground = Arc::new(Ground::pulses(vec![pulse]).unwrap().rotated(heading));
        let start = State {
            tilt,
            yaw: heading,
            ..State::default()
        };
        let start = if tilt == 0.0 {
            State::standing()
        } else {
            start
        };
        let options = Options {
            rtol,
            max_steps: 8000,
            ..with_flat(flat, 3.0)
        };
        for law in [FrictionLaw::Frictionless, viscous.clone()] {
            let motion = shaken(ground.clone(), &column(), &start, law, &options);
            assert_eq!(motion.status, Status::Finished, "{}", motion.message());
            assert!(imbalance(&motion) < 1e3 * rtol, "{}", imbalance(&motion));
        }
    }
    // The table falls away from a base that slides on a film, so that it begins to rock.
    let free = [0.0, 0.0, -9.81];
    let samples = vec![free, [3.0, 2.0, 0.5], free, [1.0, 0.0, 2.0], free];
    let ground = Arc::new(Ground::sampled(0.1, samples).unwrap());
    let motion = shaken(ground, &column(), &State::standing(), viscous, &tight(0.21));
    assert_eq!(motion.status, Status::Finished, "{}", motion.message());
    assert!(motion.work.steps < 2000, "{}", motion.work.steps);
    assert_eq!(event_times(&motion, "uplift").len(), 1);
}

/// Coulomb and tabulated friction, with a resistance.
fn any_dry_law() -> impl Strategy<Value = ContactLaw> {
    let coulomb = (0.1..1.0).prop_map(FrictionLaw::coulomb);
    let frictions = prop::collection::vec(0.1..1.0, 3);
    let tabulated = (powers_of_ten(-2.0, 0.0), frictions).prop_map(|(speed, frictions)| {
        let table = Tabulated::new(&[0.0, speed, 3.0 * speed], &frictions, None);
        FrictionLaw::Tabulated(table.unwrap())
    });
    prop_oneof![coulomb, tabulated].prop_map(|friction| ContactLaw {
        resistance: Resistance {
            rolling: RollingResistance {
                dry: 1e-3,
                ..RollingResistance::default()
            },
            ..Resistance::default()
        },
        ..friction.into()
    })
}

proptest! {
    #![proptest_config(cases(30))]

    /// In another heading the acceleration across the plane of a motion is a rounding error instead of zero. With
    /// resistance a body that begins to rock turns a little, so that it does not stay in its plane exactly.
    #[test]
    fn planar_motions_of_a_rim_that_slides_take_as_few_steps_in_any_heading(
        body in any_body().prop_filter("no disk", |body| body.height() > 0.0),
        law in any_dry_law(),
        along in prop::collection::vec(-5.0..5.0, 15),
        (heading, rtol) in (-3.0..3.0, powers_of_ten(-12.0, -7.0)),
    ) {
        let (radius, height) = (body.radius(), body.height());
        let tipping = 9.81 * (radius / height).min(2.0);
        let samples = along.iter().map(|x| [tipping * x, 0.0, 0.0]).collect();
        let step = 0.5 * ((radius + height) / 9.81).sqrt();
        let ground = Ground::sampled(step, samples).unwrap();
        let take = |yaw, max_steps| {
            let options = Options { rtol, max_steps, ..with_flat(FlatLanding::Housner, 15.0 * step) };
            let start = State { yaw, ..State::standing() };
            shaken(Arc::new(ground.rotated(yaw)), &body, &start, law.clone(), &options)
        };
        let straight = take(0.0, 3000);
        prop_assume!(straight.status != Status::Failed);
        let turned = take(heading, 200 + 2 * straight.work.steps);
        prop_assert_eq!(turned.status, straight.status, "{}", turned.message());
    }
}

fn with_flat(flat: FlatLanding, duration: f64) -> Options {
    Options {
        flat,
        ..tight(duration)
    }
}

/// Housner's column on a table at rest: each impact leaves the fraction (K − mR²)/J of the tilt rate, and it stands in
/// the end.
#[test]
fn impacts_on_the_flat_base_bring_a_column_to_rest() {
    let k: f64 = 1_395.833_333_333_333_3 + 1000.0 * 4.0;
    let factor = (k - 250.0) / (k + 250.0);
    assert!((factor - 0.911_439).abs() < 1e-6);
    let start = State {
        tilt: 0.1,
        ..State::default()
    };
    let ground = constant([0.0; 3], 1.0);
    let law = FrictionLaw::NoSlip;
    let housner = shaken(
        ground.clone(),
        &column(),
        &start,
        law.clone(),
        &with_flat(FlatLanding::Housner, 60.0),
    );
    let same = FlatLanding::Restitution(factor);
    let restitution = shaken(
        ground.clone(),
        &column(),
        &start,
        law.clone(),
        &with_flat(same, 60.0),
    );
    for motion in [&housner, &restitution] {
        let peaks: Vec<f64> = motion.turns.iter().map(|turn| turn.max_tilt).collect();
        let height = |tilt: f64| 0.5 * libm::sin(tilt) + 2.0 * (libm::cos(tilt) - 1.0);
        let mut before = height(0.1);
        for tilt in &peaks[..5] {
            let ratio = height(*tilt) / before;
            assert!(
                (ratio - factor * factor).abs() < 1e-9,
                "{ratio} {}",
                factor * factor
            );
            before = height(*tilt);
        }
        assert!(
            motion
                .turns
                .iter()
                .all(|turn| (turn.angle - core::f64::consts::PI).abs() < 1e-9)
        );
        assert_eq!(motion.trajectory.end().phase.name(), "standing");
        assert_eq!(motion.status, Status::Finished);
        assert!(imbalance(motion) < 1e-9);
    }
    // Without loss it rocks on, and the contact point runs round by the limiting turn.
    let smooth = with_flat(FlatLanding::Smooth(Side::Right), 5.0);
    let limit = turn_limit(&column(), rimroll::IdealLaw::NoSlip);
    for law in [law, FrictionLaw::InPlace] {
        let motion = shaken(ground.clone(), &column(), &start, law, &smooth);
        assert!(motion.turns.len() > 1);
        for turn in &motion.turns {
            assert!((turn.angle + limit).abs() < 1e-7, "{} {limit}", turn.angle);
            assert!((turn.max_tilt - 0.1).abs() < 1e-9);
        }
        assert!(imbalance(&motion) < 1e-9);
    }
}

/// Under Housner's impacts a column that was lifted by one pulse stands again, and is lifted by the next.
#[test]
fn a_body_that_stands_again_is_lifted_by_the_next_pulse() {
    let mut samples = vec![[0.0; 3]; 8001];
    for start in [200, 6000] {
        for sample in &mut samples[start..start + 60] {
            *sample = [3.5, 1.0, 0.0];
        }
    }
    let ground = Arc::new(Ground::sampled(0.005, samples).unwrap());
    let options = with_flat(FlatLanding::Housner, 60.0);
    for law in [
        FrictionLaw::NoSlip,
        FrictionLaw::InPlace,
        FrictionLaw::coulomb(0.8),
    ] {
        let start = State::standing();
        let motion = shaken(ground.clone(), &column(), &start, law.clone(), &options);
        let (lifted, stood) = (
            event_times(&motion, "uplift"),
            event_times(&motion, "stand"),
        );
        assert_eq!(
            (lifted.len(), stood.len()),
            (2, 2),
            "{lifted:?} {stood:?} {}",
            motion.message()
        );
        assert!(lifted[0] < stood[0] && stood[0] < lifted[1] && lifted[1] < stood[1]);
        assert!((lifted[0] - 1.0).abs() < 0.01 && (lifted[1] - 30.0).abs() < 0.01);
        let moved = libm::hypot(value(&motion, 60.0, "x"), value(&motion, 60.0, "y"));
        assert!(law != FrictionLaw::InPlace || moved < 1e-6, "{moved}");
        assert!(imbalance(&motion) < 1e-9);
    }
}

#[test]
fn the_search_of_a_tiny_period_is_limited_by_the_number_of_steps() {
    let body = column();
    let hum = ground(vec![sine([0.1, 0.0, 0.0], 1e-12, 1e12)]);
    let options = Options {
        max_steps: 300,
        ..tight(1.0)
    };
    let law = FrictionLaw::NoSlip;
    let motion = shaken(
        Arc::clone(&hum),
        &body,
        &State::standing(),
        law.clone(),
        &options,
    );
    assert_eq!(motion.status, Status::Failed, "{}", motion.message());
    assert_eq!(motion.work.steps, 300);
    assert!(motion.trajectory.end().t < 1e-8);

    let interrupt = |_| ControlFlow::Break(());
    let start = State::standing();
    let motion = simulate_on(Some(hum), &body, &start, law, &tight(1.0), interrupt).unwrap();
    assert_eq!(motion.status, Status::Interrupted, "{}", motion.message());
}

/// Just after the uplift, resistance stops the contact point in far less time than the body takes to rise.
#[test]
fn a_column_with_resistance_lifts_lands_and_stands_again() {
    let pulses = vec![
        sine([3.0, 0.0, 0.0], 1.2, 2.0),
        sine([0.0, 1.5, 0.0], 0.8, 3.0),
        sine([0.0, 0.0, 0.5], 0.3, 2.0),
    ];
    let resistances = [
        Resistance {
            rolling: RollingResistance {
                dry: 2e-3,
                viscous: 0.0,
            },
            ..Resistance::default()
        },
        Resistance {
            rolling: RollingResistance {
                dry: 0.0,
                viscous: 10.0,
            },
            ..Resistance::default()
        },
        Resistance {
            pivoting: PivotingFriction { length: 1e-3 },
            ..Resistance::default()
        },
        Resistance {
            air: AirDrag {
                coefficient: 0.1,
                exponent: 2.5,
            },
            ..Resistance::default()
        },
    ];
    for resistance in resistances {
        for flat in [FlatLanding::Smooth(Side::Left), FlatLanding::Housner] {
            let law = ContactLaw {
                resistance,
                ..FrictionLaw::NoSlip.into()
            };
            let options = with_flat(flat, 4.0);
            let start = State::standing();
            for pulses in [pulses.clone(), pulses[..1].to_vec()] {
                let motion = shaken(ground(pulses), &column(), &start, law.clone(), &options);
                assert_eq!(motion.status, Status::Finished, "{}", motion.message());
                assert!(motion.work.steps < 20_000, "{:?}", motion.work);
                assert!(!event_times(&motion, "uplift").is_empty());
                assert!(imbalance(&motion) < 1e-9, "{:e}", imbalance(&motion));
            }
        }
    }
}

/// The direction of a slip that begins from rest relaxes at a rate that is infinite at first.
#[test]
fn a_slip_of_the_base_takes_few_steps() {
    let pulses = vec![
        sine([2.5, 0.0, 0.0], 1.2, 3.0),
        sine([0.0, 1.5, 0.0], 0.8, 3.0),
    ];
    let law = FrictionLaw::coulomb(0.2);
    let options = tight(4.0);
    let motion = shaken(ground(pulses), &column(), &State::standing(), law, &options);
    assert_eq!(motion.status, Status::Finished, "{}", motion.message());
    let slips = event_times(&motion, "slip").len();
    assert!(
        slips >= 3 && motion.work.steps < 1_000 * slips,
        "{slips} slips, {:?}",
        motion.work
    );
    assert!(imbalance(&motion) < 1e-9, "{:e}", imbalance(&motion));
}
