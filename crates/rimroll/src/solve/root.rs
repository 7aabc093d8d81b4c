//! Roots of a function of one variable.

/// The root of f in the bracket from a to b, to the last bits of x.
///
/// The method is regula falsi with the Illinois weights (Dowell & Jarratt, BIT 11, 1971) and a bisection in
/// every third round, which bounds the work. If f is zero at an end, that end is returned. If f does not
/// change sign, the end with the smaller |f| is returned.
pub fn bracketed_root(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    bracketed_root_in(200, a, b, f)
}

/// An approximation of [`bracketed_root`] in at most `rounds` rounds.
pub fn bracketed_root_in(rounds: usize, mut a: f64, mut b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return a;
    }
    if fb == 0.0 {
        return b;
    }
    if (fa < 0.0) == (fb < 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    for round in 1..=rounds {
        let mut x = b - fb * (b - a) / (fb - fa);
        if round % 3 == 0 || x == a || x == b {
            x = 0.5 * (a + b);
            if x == a || x == b {
                break;
            }
        }
        let fx = f(x);
        if fx == 0.0 {
            return x;
        }
        if (fx < 0.0) == (fb < 0.0) {
            // The end a stays. Half its weight moves the next guess to the other side of the root.
            fa *= 0.5;
        } else {
            a = b;
            fa = fb;
        }
        b = x;
        fb = fx;
        if (b - a).abs() <= 2.0 * f64::EPSILON * b.abs().max(a.abs()) {
            break;
        }
    }
    b
}

#[cfg(test)]
mod tests {
    use super::bracketed_root;

    #[test]
    fn finds_roots_to_the_last_bits() {
        let root = bracketed_root(0.0, 2.0, |x| x * x - 2.0);
        assert!((root - core::f64::consts::SQRT_2).abs() <= 4e-16);
        // A function so flat at its root that the secant method alone would converge slowly.
        let root = bracketed_root(-1.0, 1.5, |x| x * x * x * x * x);
        assert!(root.abs() < 1e-15);
        assert_eq!(bracketed_root(0.0, 1.0, |x| x), 0.0);
        assert_eq!(bracketed_root(0.0, 1.0, |x| x - 1.0), 1.0);
    }
}
