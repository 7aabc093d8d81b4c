//! Turns by quadrature have the same outcome as turns by steps, for throws of all kinds, including those in
//! which the normal force becomes negative only for a moment.

use rimroll::motion::Outcome;
use rimroll::motion::{Options, Status, fall};
use rimroll::turn::exact::{Exact, ExactTurn};
use rimroll::{Body, IdealLaw, State};

const GRAVITY: f64 = 9.8;

/// (law, [R, H, A, C] for a mass of 1 kg, [tilt, tilt rate, yaw rate, spin rate]).
type Throw = (IdealLaw, [f64; 4], [f64; 4]);

const SLIM: [f64; 4] = [
    0.010394625928446454,
    0.045733974346101686,
    0.0002263396466462631,
    9.233936522848272e-05,
];

/// The normal force is negative at once.
const PULLED: [Throw; 2] = [
    (
        IdealLaw::NoSlip,
        SLIM,
        [
            0.8854073545246323,
            -13.925896618344582,
            0.2316571939266128,
            0.0007671947988457334,
        ],
    ),
    (
        IdealLaw::Frictionless,
        SLIM,
        [
            1.1293924182178958,
            18.347041990849792,
            5.189889138441835,
            0.14892407947754144,
        ],
    ),
];

/// The normal force becomes negative later, while the logarithm of the tilt changes by at most a tenth.
const PULLED_FOR_A_MOMENT: [Throw; 3] = [
    (
        IdealLaw::NoSlip,
        [
            0.04366595084391816,
            0.0029442291232566367,
            0.0003294932868726987,
            0.0005958410177744957,
        ],
        [
            0.1923739748227827,
            0.5037611440017886,
            -7.843566273595107,
            0.04427191234809908,
        ],
    ),
    (
        IdealLaw::NoSlip,
        [
            0.09113049995280993,
            0.29805136644647245,
            0.04976168500774462,
            0.002757788818076462,
        ],
        [
            0.20408976219941036,
            -3.2131617545966704,
            0.5317332935264714,
            -5.181172906591001,
        ],
    ),
    (
        IdealLaw::NoSlip,
        [
            0.13333444628639707,
            0.3785722411776899,
            0.036329896369753645,
            0.013889789658325264,
        ],
        [
            0.20921183317255798,
            3.5769153421875046,
            -10.989356694688773,
            1.3751898663109106,
        ],
    ),
];

fn body([radius, height, transverse, axial]: [f64; 4]) -> Body {
    Body::new(1.0, radius, height, transverse, axial).unwrap()
}

fn state([tilt, tilt_rate, yaw_rate, spin_rate]: [f64; 4]) -> State {
    State {
        tilt,
        tilt_rate,
        yaw_rate,
        spin_rate,
        ..State::default()
    }
}

/// By quadrature, for one start and in a batch.
fn by_quadrature((law, constants, start): &Throw) -> ExactTurn {
    let exact = Exact::new(&body(*constants), *law, GRAVITY, None).unwrap();
    let alone = exact.turn(&state(*start)).unwrap();
    let among = exact.turns(&[state(*start)]).unwrap()[0];
    assert_eq!(
        alone.ending, among.ending,
        "{law:?} {constants:?} {start:?}"
    );
    alone
}

/// By steps: the outcome, and the turn if there is one.
fn by_steps((law, constants, start): &Throw) -> (Outcome, Option<f64>) {
    let options = Options {
        duration: 1000.0,
        gravity: GRAVITY,
        rtol: 1e-13,
        ..Options::default()
    };
    let fall = fall(&body(*constants), &state(*start), &(*law).into(), &options).unwrap();
    let ending = match (fall.status, &fall.turn) {
        (Status::Finished, Some(_)) => Outcome::Rocked,
        (Status::Toppled, Some(_)) => Outcome::Toppled,
        (Status::Toppled, None) => Outcome::FellBack,
        (Status::LiftedOff, _) => Outcome::LiftedOff,
        (Status::FaceDown, _) => Outcome::FaceDown,
        (status, _) => panic!("{status:?} of {constants:?} {start:?}"),
    };
    (ending, fall.turn.map(|turn| turn.angle))
}

#[test]
fn a_rim_that_has_to_be_pulled_at_once_lifts_off_without_a_turn() {
    for throw in &PULLED {
        assert_eq!(by_steps(throw), (Outcome::LiftedOff, None));
        let exact = by_quadrature(throw);
        assert_eq!(exact.ending, Outcome::LiftedOff);
        assert!(exact.turn.is_nan() && exact.time.is_nan());
    }
}

#[test]
fn a_rim_that_has_to_be_pulled_for_a_moment_lifts_off() {
    for throw in &PULLED_FOR_A_MOMENT {
        let (ending, turn) = by_steps(throw);
        let exact = by_quadrature(throw);
        assert_eq!(
            (exact.ending, ending),
            (Outcome::LiftedOff, Outcome::LiftedOff)
        );
        assert_eq!(exact.turn.is_nan(), turn.is_none(), "{throw:?}");
        assert!(turn.is_none_or(|turn| (exact.turn - turn).abs() < 1e-8));
    }
}

#[test]
fn a_rim_that_has_to_be_pulled_where_the_tilt_would_be_largest_lifts_off_without_a_turn() {
    let throw = (
        IdealLaw::Frictionless,
        [
            0.05,
            0.002352595253962928,
            0.0006529654567666472,
            0.0013031804094904235,
        ],
        [
            0.08404701033950154,
            6.247632144970591,
            -15.814874120519539,
            -17.08765390847556,
        ],
    );
    assert_eq!(by_steps(&throw), (Outcome::LiftedOff, None));
    let exact = by_quadrature(&throw);
    assert_eq!(exact.ending, Outcome::LiftedOff);
    assert!(exact.turn.is_nan());
}

/// The i-th point of Halton's sequence in one dimension, in [0, 1).
fn halton(mut i: usize, base: usize) -> f64 {
    let (mut sum, mut unit) = (0.0, 1.0);
    while i > 0 {
        unit /= base as f64;
        sum += unit * (i % base) as f64;
        i /= base;
    }
    sum
}

/// Throws of flat to slender bodies, at tilts up to 89 degrees, fast and slow, in both directions.
fn thrown(i: usize) -> Throw {
    let between = |base, min: f64, max: f64| min + (max - min) * halton(i, base);
    let radius: f64 = 0.05;
    let height = radius / libm::exp(between(2, libm::log(0.1), libm::log(30.0)));
    let axial = radius * radius * between(3, 0.1, 1.0);
    let transverse = 0.5 * axial + height * height * between(5, 0.05, 1.0);
    let natural = (GRAVITY / libm::hypot(radius, height)).sqrt();
    let fast = natural * between(19, 0.03, 3.0);
    let law = if i.is_multiple_of(2) {
        IdealLaw::NoSlip
    } else {
        IdealLaw::Frictionless
    };
    (
        law,
        [radius, height, transverse, axial],
        [
            between(7, 0.02, 89_f64.to_radians()),
            fast * between(11, -1.0, 1.0),
            fast * between(13, -1.0, 1.0),
            fast * between(17, -1.0, 1.0),
        ],
    )
}

/// Whether a tiny change of the start changes the outcome, so that rounding decides.
fn is_on_an_edge(throw: &Throw) -> bool {
    const HAIR: f64 = 1e-7;
    let ending = by_quadrature(throw).ending;
    [-HAIR, HAIR].iter().any(|offset| {
        (0..4).any(|i| {
            let mut neighbour = *throw;
            neighbour.2[i] *= 1.0 + offset;
            by_quadrature(&neighbour).ending != ending
        })
    })
}

#[test]
fn throws_of_all_kinds_end_and_turn_by_quadrature_as_by_steps() {
    let mut met = Vec::new();
    for throw in (1..=600).map(thrown) {
        let (ending, turn) = by_steps(&throw);
        let exact = by_quadrature(&throw);
        if exact.ending != ending {
            assert!(is_on_an_edge(&throw), "{ending:?} {exact:?} {throw:?}");
            continue;
        }
        assert_eq!(exact.turn.is_nan(), turn.is_none(), "{throw:?}");
        let off = turn.map_or(0.0, |turn| (exact.turn - turn).abs());
        assert!(off < 1e-8, "{off:e} {throw:?}");
        met.push(ending);
    }
    assert!(met.len() > 590, "too many on an edge: {}", met.len());
    for ending in [
        Outcome::Rocked,
        Outcome::Toppled,
        Outcome::FellBack,
        Outcome::LiftedOff,
    ] {
        let count = met.iter().filter(|&&one| one == ending).count();
        assert!(count > 50, "{count} {ending:?}");
    }
}

/// A row of the table of turns in multiprecision arithmetic, by column name.
struct Tabulated<'a> {
    names: &'a [&'a str],
    row: Vec<&'a str>,
}

impl Tabulated<'_> {
    fn text(&self, name: &str) -> &str {
        self.row[self.names.iter().position(|&one| one == name).unwrap()]
    }

    fn number(&self, name: &str) -> f64 {
        self.text(name).parse().unwrap()
    }

    fn exact(&self, law: IdealLaw) -> Exact {
        let [m, r, h, a, c] = [
            "mass",
            "radius",
            "height",
            "transverse_inertia",
            "axial_inertia",
        ]
        .map(|name| self.number(name));
        let body = Body::new(m, r, h, a, c).unwrap();
        let topple_tilt = self.text("topple_tilt").parse().ok();
        Exact::new(&body, law, self.number("gravity"), topple_tilt).unwrap()
    }
}

#[test]
fn turns_alone_and_among_many_are_those_of_the_table_in_multiprecision_to_1e_12() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/given/exact_turns.csv"
    );
    let table = std::fs::read_to_string(path).unwrap();
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    for line in lines {
        let row = Tabulated {
            names: &names,
            row: line.split(',').collect(),
        };
        let start =
            state(["tilt", "tilt_rate", "yaw_rate", "spin_rate"].map(|name| row.number(name)));
        for (law, of_law) in [
            (IdealLaw::NoSlip, "no_slip"),
            (IdealLaw::Frictionless, "frictionless"),
        ] {
            let exact = row.exact(law);
            let alone = exact.turn(&start).unwrap();
            let among = exact.turns(&[start]).unwrap()[0];
            let known = row.number(&format!("turn_{of_law}"));
            for found in [alone, among] {
                assert_eq!(
                    found.ending.name(),
                    row.text(&format!("outcome_{of_law}")),
                    "{line}"
                );
                assert_eq!(found.turn.is_nan(), known.is_nan(), "{line}");
                assert!(
                    known.is_nan() || (found.turn - known).abs() < 1e-12,
                    "{line}"
                );
            }
        }
    }
}
