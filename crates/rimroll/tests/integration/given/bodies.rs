//! Random bodies for the property tests.

use proptest::prelude::*;
use rimroll::Body;

/// 10^x for x uniform in a range.
pub fn powers_of_ten(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|x| libm::pow(10.0, x))
}

/// Masses from grams to tonnes, sizes from millimetres to metres, disks to columns, mass near the axis or far
/// from it. The draw of C ensures C ≤ 2A.
pub fn any_body() -> impl Strategy<Value = Body> {
    let height = prop_oneof![1 => Just(0.0), 4 => 0.05..5.0];
    let axial = prop_oneof![1 => Just(2.0), 4 => 0.05..2.0];
    (
        powers_of_ten(-3.0, 3.0),
        powers_of_ten(-3.0, 0.0),
        height,
        0.05..5.0,
        axial,
    )
        .prop_map(|(mass, radius, slenderness, transverse, axial)| {
            let a = transverse * mass * radius * radius;
            Body::new(mass, radius, slenderness * radius, a, axial * a).expect("a rigid body")
        })
}

/// Extreme bodies of mass and radius 1: needles, plates, all mass at the axis or at the centre.
pub fn wild_body() -> impl Strategy<Value = Body> {
    let height = prop_oneof![1 => Just(0.0), 4 => powers_of_ten(-3.0, 3.0)];
    let axial = powers_of_ten(-6.0, 3.0);
    let spread = prop_oneof![1 => Just(0.5), 3 => powers_of_ten(-0.3, 6.0)];
    (height, axial, spread).prop_map(|(height, c, spread)| {
        // C ≤ 2A.
        let a = (spread * c).clamp(0.5 * c, 1e3_f64.max(c));
        Body::new(1.0, 1.0, height, a, c).expect("a rigid body")
    })
}
