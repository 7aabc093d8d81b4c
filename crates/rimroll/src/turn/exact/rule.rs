//! Gauss-Legendre rules for even functions: the n nodes in (0, 1) of the rule with 2n on (−1, 1).

use std::sync::LazyLock;

/// How many nodes each rule of the ladder has.
pub(super) const LADDER: [usize; 16] =
    [4, 6, 8, 10, 12, 14, 16, 18, 20, 24, 28, 34, 42, 56, 80, 120];

/// The first rung with so many nodes; the last has at most its own.
pub(super) fn rung_with(nodes: f64) -> usize {
    let enough = LADDER.iter().position(|&n| n as f64 >= nodes);
    enough.unwrap_or(LADDER.len() - 1)
}

/// About how many nodes resolve a piece from the smallest tilt, `length` long in η: with each unit of
/// η the time grows e-fold over it.
pub(super) fn nodes_from_lowest(length: f64) -> f64 {
    9.0 + 0.8 * length
}

/// The first rung whose rule is about enough for a piece to the largest tilt, `length` long in η, where
/// the tilt's energy has its next root, beyond the balance point, farther by `gap`: there, at
/// i √(gap/length), ends the integrand's continuation in the plane of τ.
pub(super) fn rung_to_highest(length: f64, gap: f64) -> usize {
    let reach = gap / length;
    let enough = RUNGS.iter().position(|rung| rung.square_reach <= reach);
    enough.unwrap_or(LADDER.len() - 1)
}

/// Nodes and weights on (0, 1), exact for even polynomials up to degree 4n − 2.
pub(super) struct Rule {
    pub(super) nodes: Vec<Node>,
    /// For which (gap/length) it is enough.
    square_reach: f64,
}

/// One of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// τ.
    pub(super) at: f64,
    pub(super) weight: f64,
    /// Weight, times P_{2n−2} at the node and its norm: what sums to the coefficient of the last
    /// Legendre polynomial that the rule can see.
    pub(super) last: f64,
    /// The same of P_{2n−6}.
    pub(super) before: f64,
}

/// The rule on a rung of the [`LADDER`].
pub(super) fn rule(rung: usize) -> &'static Rule {
    &RUNGS[rung]
}

static RUNGS: LazyLock<Vec<Rule>> =
    LazyLock::new(|| LADDER.iter().map(|&n| Rule::new(n)).collect());

impl Rule {
    fn new(n: usize) -> Rule {
        // The error falls off like exp(−4n asinh(reach)).
        const DIGITS: f64 = 6.7;
        let reach = libm::sinh(DIGITS / (n as f64 - 2.5));
        Rule {
            nodes: (0..n).map(|i| node(2 * n, i)).collect(),
            square_reach: reach * reach,
        }
    }
}

/// Node i of the rule with `degree` nodes, counted from the middle, by Newton's iteration on the
/// Legendre polynomial (Numerical Recipes' first guess).
fn node(degree: usize, i: usize) -> Node {
    let outward = (degree / 2 - 1 - i) as f64;
    let guess = core::f64::consts::PI * (outward + 0.75) / (degree as f64 + 0.5);
    let mut x = libm::cos(guess);
    for _ in 0..6 {
        let (value, slope) = legendre(degree, x);
        x -= value / slope;
    }
    let (_, slope) = legendre(degree, x);
    let weight = 2.0 / ((1.0 - x * x) * slope * slope);
    let of_degree = |m: usize| weight * (2 * m + 1) as f64 * legendre(m, x).0;
    Node {
        at: x,
        weight,
        last: of_degree(degree - 2),
        before: of_degree(degree - 6),
    }
}

/// P_n(x) and its slope, for n ≥ 1.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        let next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
        before = value;
        value = next;
    }
    (value, n as f64 * (before - x * value) / (1.0 - x * x))
}

#[cfg(test)]
mod tests {
    use super::{LADDER, rule};

    #[test]
    fn each_rule_integrates_even_polynomials() {
        for (rung, n) in LADDER.iter().enumerate() {
            for power in (0..=(4 * n - 2).min(300)).step_by(2) {
                let power = power as i32;
                let nodes = &rule(rung).nodes;
                let sum: f64 = nodes.iter().map(|k| k.weight * k.at.powi(power)).sum();
                assert!(
                    (sum * f64::from(power + 1) - 1.0).abs() < 1e-13,
                    "{n} {power} {sum}"
                );
            }
        }
    }
}
