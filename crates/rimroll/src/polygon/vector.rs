//! Vectors in the body frame.

/// Components along the axes of the body; the third is the axis of symmetry.
pub(super) type Vector = [f64; 3];

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a + factor · b.
pub(super) fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    core::array::from_fn(|i| a[i] + factor * b[i])
}

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    plus(a, -1.0, b)
}

pub(super) fn times(factor: f64, a: Vector) -> Vector {
    a.map(|component| factor * component)
}

pub(super) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}
