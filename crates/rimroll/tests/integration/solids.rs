//! Bodies composed of solids, against sums over point masses and textbook moments of inertia.

use crate::given::cases;

use cases::cases;
use core::f64::consts::PI;
use proptest::prelude::*;
use rimroll::{Body, Solid, presets};

/// A mass (kg) at a position (m).
type Point = (f64, [f64; 3]);

/// Points equally spaced round the axis: three or more have the second moments of a thin ring.
fn points_of_ring(mass: f64, radius: f64, height: f64) -> impl Iterator<Item = Point> {
    (0..5).map(move |i| {
        let (sin, cos) = libm::sincos(2.0 * PI * f64::from(i) / 5.0);
        (mass / 5.0, [radius * cos, radius * sin, height])
    })
}

/// Rings at the two Gauss points of the length: they have the second moments of a wall.
fn points_of_wall(mass: f64, radius: f64, length: f64, base: f64) -> Vec<Point> {
    let (middle, away) = (base + 0.5 * length, 0.5 * length / 3f64.sqrt());
    points_of_ring(0.5 * mass, radius, middle - away)
        .chain(points_of_ring(0.5 * mass, radius, middle + away))
        .collect()
}

/// Walls whose mean square radius is that of the annulus between two circles.
fn points_of_hollow_cylinder(mass: f64, [a, b]: [f64; 2], length: f64, base: f64) -> Vec<Point> {
    points_of_wall(mass, (0.5 * (a * a + b * b)).sqrt(), length, base)
}

/// Mass, height of the centre of mass, A about it and C, by summing over the points.
fn sums(points: &[Point]) -> [f64; 4] {
    let mass: f64 = points.iter().map(|(m, _)| m).sum();
    let height = points.iter().map(|(m, r)| m * r[2]).sum::<f64>() / mass;
    let about = |f: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(|(m, r)| m * f(r)).sum::<f64>();
    let axial = about(&|r| r[0] * r[0] + r[1] * r[1]);
    let transverse = about(&|r| r[1] * r[1] + (r[2] - height) * (r[2] - height));
    [mass, height, transverse, axial]
}

fn numbers(body: &Body) -> [f64; 4] {
    [
        body.mass(),
        body.height(),
        body.transverse_inertia(),
        body.axial_inertia(),
    ]
}

fn agree(a: [f64; 4], b: [f64; 4], tolerance: f64) -> bool {
    a.iter()
        .zip(b)
        .all(|(x, y)| (x - y).abs() <= tolerance * y.abs())
}

proptest! {
    #![proptest_config(cases(200))]

    /// A can made of two discs, a wall, a thick ring and a filling, combined by the parallel-axis theorem.
    #[test]
    fn parallel_axes_agree_with_a_sum_over_point_masses(
        masses in prop::array::uniform4(0.01..1.0),
        radius in 0.01..0.5,
        length in 0.01..1.0,
        inner in 0.0..1.0,
        base in 0.0..0.1,
        density in 500.0..2000.0,
    ) {
        let [bottom, lid, wall, ring] = masses;
        let inner = inner * radius;
        let solids = [
            Solid::disk(bottom, radius, base),
            Solid::disk(lid, 0.8 * radius, base + length),
            Solid::wall(wall, radius, length, base),
            Solid::hollow_cylinder(ring, inner, radius, 0.3 * length, base),
            Solid::filling(density, radius, 0.5 * length, base),
        ]
        .map(|solid| solid.expect("a solid"));
        let filling = density * PI * radius * radius * 0.5 * length;
        let points: Vec<Point> = [
            points_of_hollow_cylinder(bottom, [0.0, radius], 0.0, base),
            points_of_hollow_cylinder(lid, [0.0, 0.8 * radius], 0.0, base + length),
            points_of_wall(wall, radius, length, base),
            points_of_hollow_cylinder(ring, [inner, radius], 0.3 * length, base),
            points_of_hollow_cylinder(filling, [0.0, radius], 0.5 * length, base),
        ]
        .concat();
        let body = Body::from_solids(radius, &solids).expect("a body");
        // The rounding error of a sum of fifty terms.
        prop_assert!(agree(numbers(&body), sums(&points), 1e-13));
        prop_assert_eq!(body.radius(), radius);
    }
}

/// The mL²/12 of n thin, equally spaced discs is smaller than that of the cylinder by the fraction 1/n².
#[test]
fn a_cylinder_is_a_stack_of_discs() {
    const COUNT: u32 = 1000;
    let (mass, radius, length) = (2.0, 0.3, 0.8);
    let n = f64::from(COUNT);
    let discs: Vec<Solid> = (0..COUNT)
        .map(|i| {
            let height = length * (f64::from(i) + 0.5) / n;
            Solid::disk(mass / n, radius, height).expect("a disk")
        })
        .collect();
    let stack = Body::from_solids(radius, &discs).expect("a body");
    let cylinder = Solid::cylinder(mass, radius, length, 0.0).expect("a cylinder");
    let whole = Body::from_solids(radius, &[cylinder]).expect("a body");
    let mut expected = numbers(&whole);
    expected[2] -= mass * length * length / 12.0 / (n * n);
    assert!(agree(numbers(&stack), expected, 1e-13));
}

/// A cylinder with a bore is a solid cylinder minus its core.
#[test]
fn a_bore_takes_its_own_moments_away() {
    let (density, length) = (PI * 1000.0, 0.4);
    let cylinder = |radius: f64| {
        let mass = density * radius * radius * length;
        Solid::cylinder(mass, radius, length, 0.1).expect("a cylinder")
    };
    let (outer, bore) = (cylinder(0.3), cylinder(0.2));
    let hollow = Solid::hollow_cylinder(outer.mass - bore.mass, 0.2, 0.3, length, 0.1);
    let hollow = hollow.expect("a hollow cylinder");
    let taken = |whole: f64, part: f64, rest: f64| ((whole - part) / rest - 1.0).abs() < 1e-14;
    assert!(taken(
        outer.axial_inertia,
        bore.axial_inertia,
        hollow.axial_inertia
    ));
    assert!(taken(
        outer.transverse_inertia,
        bore.transverse_inertia,
        hollow.transverse_inertia
    ));
    assert_eq!(hollow.height, outer.height);
}

/// For mass, radius and length 1: Landau & Lifshitz, Mechanics, §32, problem 2.
#[test]
fn moments_of_inertia_are_the_textbook_ones() {
    for (solid, transverse, axial) in [
        (
            Solid::cylinder(1.0, 1.0, 1.0, 0.0),
            1.0 / 4.0 + 1.0 / 12.0,
            0.5,
        ),
        (Solid::disk(1.0, 1.0, 0.0), 0.25, 0.5),
        (Solid::ring(1.0, 1.0, 0.0), 0.5, 1.0),
        (Solid::wall(1.0, 1.0, 1.0, 0.0), 0.5 + 1.0 / 12.0, 1.0),
        (Solid::filling(1.0 / PI, 1.0, 1.0, 0.0), 1.0 / 3.0, 0.5),
    ] {
        let solid = solid.expect("a solid");
        assert!((solid.mass - 1.0).abs() < 1e-15);
        assert!((solid.transverse_inertia - transverse).abs() < 1e-15);
        assert!((solid.axial_inertia - axial).abs() < 1e-15);
    }
}

/// K and J are the moments about a horizontal axis through the base's centre and about a tangent to
/// the rim.
#[test]
fn base_and_rim_inertia_are_those_of_the_points() {
    let (mass, radius, length) = (0.5, 0.04, 0.15);
    let cylinder = Solid::cylinder(mass, radius, length, 0.0).expect("a cylinder");
    let body = Body::from_solids(radius, &[cylinder]).expect("a body");
    let points = points_of_hollow_cylinder(mass, [0.0, radius], length, 0.0);
    let about = |x: f64| -> f64 {
        let square = |r: &[f64; 3]| (r[0] - x) * (r[0] - x) + r[2] * r[2];
        points.iter().map(|(m, r)| m * square(r)).sum()
    };
    assert!((body.base_inertia() / about(0.0) - 1.0).abs() < 1e-14);
    assert!((body.rim_inertia() / about(radius) - 1.0).abs() < 1e-14);
    assert!((libm::tan(body.balance_tilt()) - radius / body.height()).abs() < 1e-15);
}

/// Masses of everyday objects: exact where a maker states them, otherwise those of the nominal sizes.
#[test]
fn presets_have_the_masses_that_they_claim() {
    for (body, mass, slack) in [
        (presets::can_2007(), 0.070, 1e-15),
        (presets::soda_can(0.0), 0.011, 0.0005),
        (presets::soda_can(1.0), 0.341, 0.010),
        (presets::beer_bottle(0.0), 0.2, 0.03),
        (presets::coin(), 7.5e-3, 1e-15),
        (presets::battery(), 23e-3, 1e-15),
        (presets::euler_disk(), 0.44, 0.005),
    ] {
        let body = body.expect("a preset");
        assert!(
            (body.mass() - mass).abs() < slack,
            "{} kg, not {mass} kg",
            body.mass()
        );
    }
}

#[test]
fn a_preset_has_a_name_and_takes_its_sizes_in_order() {
    let sizes = [0.4, 0.1];
    for &name in presets::NAMES {
        assert!(presets::named(name, &sizes).is_ok(), "{name}");
    }
    let pairs = [
        ("coin", presets::coin()),
        ("soda_can", presets::soda_can(0.4)),
        ("ring", presets::ring(0.4)),
        ("cylinder", presets::cylinder(0.4, 0.1)),
    ];
    for (name, body) in pairs {
        assert_eq!(presets::named(name, &sizes).unwrap(), body.unwrap());
    }
    for (name, sizes) in [("teapot", &sizes[..]), ("ring", &[]), ("cylinder", &[0.1])] {
        assert!(presets::named(name, sizes).is_err(), "{name} {sizes:?}");
    }
}

/// A can with a little drink left in it stands steadiest.
#[test]
fn a_can_is_lowest_with_a_little_left_in_it() {
    let height = |fill| presets::soda_can(fill).expect("a can").height();
    assert!(height(0.2) < 0.5 * height(0.0) && height(0.2) < 0.5 * height(1.0));
}
