//! Bodies for ensembles with a body in each row.

use rimroll::Body;

/// Bodies that move alike, and of which no two are equal.
pub fn all_but_equal(body: &Body, n: usize) -> Vec<Body> {
    let heavier = |i: usize| {
        let more = 1.0 + 1e-13 * i as f64;
        let (transverse, axial) = (body.transverse_inertia(), body.axial_inertia());
        Body::new(
            more * body.mass(),
            body.radius(),
            body.height(),
            more * transverse,
            more * axial,
        )
    };
    (0..n).map(|i| heavier(i).expect("a body")).collect()
}
