//! Gauss-Legendre rules for even functions: the n nodes in (0, 1) of the rule with 2n nodes on (−1, 1).
//!
//! These rules converge slowly for a function with singularities close to 0, at τ = ± i ε. The change of
//! variable τ = ε sinh(A u), sinh A = 1/ε, maps (0, 1) onto itself and moves the singularities to
//! u = ± i π/(2A), far from it.

use crate::real::{Real, approx_acosh, approx_asinh};
use std::sync::OnceLock;

/// The maximum length in η of the segment next to the largest tilt.
pub(super) const MAX_OUTER: f64 = 2.6;

/// The available numbers of nodes, in increasing order. An index into them is a rung.
const LADDER: [usize; 16] = [4, 6, 8, 10, 12, 14, 16, 18, 20, 24, 28, 34, 42, 56, 80, 120];

/// For each number of nodes, the first rung with at least as many.
const SMALLEST_RUNG: [u8; MAX_NODES + 1] = {
    let (mut smallest, mut nodes, mut rung) = ([0; MAX_NODES + 1], 0, 0);
    while nodes <= MAX_NODES {
        if nodes > LADDER[rung as usize] {
            rung += 1;
        }
        smallest[nodes] = rung;
        nodes += 1;
    }
    smallest
};
const MAX_NODES: usize = LADDER[LADDER.len() - 1];

/// Number of rungs to the next rule to try when a rule has not resolved its segment.
const CLIMB: usize = 1;

/// Number of changes of variable: the identity, then ε = 1, 1/2, 1/4 and so on.
const MAPS: usize = 13;

/// Number of rules.
pub(super) const RULES: usize = MAPS * LADDER.len();

static CACHE: [OnceLock<Rule>; RULES] = [const { OnceLock::new() }; RULES];

/// One of the rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Choice {
    /// The change of variable. 0: identity; k > 0: ε = 2^(1 − k).
    map: usize,
    rung: usize,
}

impl Choice {
    /// The rule with at least the given number of nodes, as far as available, without a change of variable.
    pub(super) fn plain(nodes: f64) -> Choice {
        // This rounds up without `ceil`, for which old processors have no instruction.
        let whole = nodes.min(MAX_NODES as f64 + 1.0) as usize;
        let smallest = SMALLEST_RUNG.get(whole + usize::from((whole as f64) < nodes));
        Choice {
            map: 0,
            rung: smallest.map_or(LADDER.len() - 1, |&rung| rung.into()),
        }
    }

    /// The rule for a segment to the largest tilt whose integrand is singular at τ² = −`square`.
    pub(super) fn to_highest(nodes: f64, square: f64) -> Choice {
        let plain = Choice::plain(nodes);
        if square >= UNMAPPED {
            return plain;
        }
        // The smallest k with ε² = 4^(1 − k) ≤ `square`, from the exponent of `square`.
        let exponent = ((square.to_bits() >> 52) & 0x7FF) as i64 - 1023;
        let halvings = (1 - exponent.min(0)) as usize / 2;
        Choice {
            map: (1 + halvings).min(MAPS - 1),
            ..plain
        }
    }

    /// The next rule with more nodes and the same change of variable.
    pub(super) fn larger(self) -> Option<Choice> {
        let rung = self.rung + CLIMB;
        (rung < LADDER.len()).then_some(Choice { rung, ..self })
    }

    /// Its index among the [`RULES`].
    pub(super) fn index(self) -> usize {
        self.map * LADDER.len() + self.rung
    }

    /// The rule with the given index.
    pub(super) fn from_index(index: usize) -> Choice {
        Choice {
            map: index / LADDER.len(),
            rung: index % LADDER.len(),
        }
    }

    /// Number of nodes.
    pub(super) fn nodes(self) -> usize {
        LADDER[self.rung]
    }

    /// The nodes and weights, computed at the first use.
    pub(super) fn rule(self) -> &'static Rule {
        CACHE[self.index()].get_or_init(|| Rule::new(self))
    }
}

/// Squared distance of the singularity from which no change of variable is needed.
const UNMAPPED: f64 = 2.0;

/// Number of nodes for a segment from the smallest tilt, times the logarithmic decrement ln ρ of the error, which
/// decreases like ρ^−4n.
const LOW_DIGITS: f64 = 8.2;

/// As [`LOW_DIGITS`], for a segment to the largest tilt.
const HIGH_DIGITS: f64 = 9.5;

/// As [`LOW_DIGITS`], for [`conservative_integral`](super::segments::Segment::conservative_integral).
const CONSERVATIVE_DIGITS: f64 = 11.0;

/// Additional nodes in a passage, for the variation of the integrand that its singularities do not cause.
const ELSEWHERE: f64 = 2.0;

/// Estimated number of nodes for a segment from the smallest tilt of the given length in η. The integrand is singular
/// at a distance `rest` in η beyond the segment, which is at √(1 + rest/length) in the plane of τ.
#[inline(always)]
pub(super) fn nodes_from_lowest<T: Real>(length: T, rest: T) -> T {
    T::from(LOW_DIGITS) / approx_asinh((rest / length).sqrt())
}

/// Estimated number of nodes for a segment from the smallest tilt towards the balance point. The integrand is singular
/// at the distances `rest` along η and ± `width` along the imaginary axis from the end of the segment.
#[inline(always)]
pub(super) fn nodes_towards<T: Real>(length: T, rest: T, width: T) -> T {
    let distance = (rest * rest + width * width).sqrt();
    let decrement = approx_asinh(((distance + rest) / (length + length)).sqrt());
    T::from(CONSERVATIVE_DIGITS) / decrement
}

/// Estimated number of nodes for a passage over the balance point of length 2 `half` in u. The integrand is singular
/// at u = ± i π/2.
#[inline(always)]
pub(super) fn nodes_across<T: Real>(half: T) -> T {
    let decrement = approx_asinh(T::from(core::f64::consts::FRAC_PI_2) / half);
    T::from(ELSEWHERE) + T::from(CONSERVATIVE_DIGITS) / decrement
}

/// Estimated number of nodes for a segment to the largest tilt. The integrand is singular at τ² = −`square`, beyond
/// the balance point, and at τ² = `far`, the smallest tilt.
#[inline(always)]
pub(super) fn nodes_to_highest<T: Real>(square: T, far: T) -> T {
    let one = T::from(1.0);
    let (near, far) = (square.sqrt(), far.sqrt());
    let plain = approx_asinh(near).min(approx_acosh(far));
    // The ε of the rules lies between the distance of the singularity and half of it; this is a typical value.
    let epsilon = (T::from(0.7) * near).min(one);
    let length = approx_asinh(one / epsilon);
    let width = approx_asinh(T::from(core::f64::consts::FRAC_PI_2) / length);
    let mapped = width.min(approx_acosh(approx_asinh(far / epsilon) / length));
    let is_mapped = square - T::from(UNMAPPED);
    T::from(HIGH_DIGITS) / is_mapped.where_negative(mapped, plain)
}

/// The offset in η of the node τ from the largest tilt, at which a segment of the given length ends.
#[inline(always)]
pub(super) fn below<T: Real>(length: T, at: T) -> T {
    -(length * (at * at))
}

/// Nodes and weights on (0, 1).
pub(super) struct Rule {
    pub(super) nodes: Vec<Node>,
}

/// One node of a rule.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// τ.
    pub(super) at: f64,
    /// exp(−Λτ²) − 1 for a Λ of [`MAX_OUTER`].
    pub(super) less: f64,
    pub(super) weight: f64,
    /// Weight times P_{2n−2}(node) times its normalisation. The sum with an integrand is the coefficient of the
    /// last Legendre polynomial that the rule resolves.
    pub(super) last: f64,
    /// The corresponding weight for P_{2n−6}.
    pub(super) before: f64,
    /// The corresponding weights for P_{2n−4} and P_{2n−8}, the even neighbours of these two.
    pub(super) neighbours: [f64; 2],
    /// The corresponding weights for P_{2n−1} and P_{2n−5}, for odd functions.
    pub(super) odd: [f64; 2],
}

impl Rule {
    fn new(choice: Choice) -> Rule {
        let n = choice.nodes();
        let plain = (0..n).map(|i| node(2 * n, i));
        let nodes = match choice.map {
            0 => plain.collect(),
            k => plain
                .map(|node| node.mapped(libm::ldexp(1.0, 1 - k as i32)))
                .collect(),
        };
        Rule { nodes }
    }
}

impl Node {
    fn mapped(self, epsilon: f64) -> Node {
        let length = libm::asinh(1.0 / epsilon);
        let factor = epsilon * length * libm::cosh(length * self.at);
        let at = epsilon * libm::sinh(length * self.at);
        Node {
            at,
            less: Real::exp_m1(below(MAX_OUTER, at)),
            weight: factor * self.weight,
            last: factor * self.last,
            before: factor * self.before,
            neighbours: self.neighbours.map(|weight| factor * weight),
            odd: self.odd.map(|weight| factor * weight),
        }
    }
}

/// Node i of the rule with `degree` nodes, counted from the middle, by Newton iteration on the Legendre
/// polynomial (initial guess of Numerical Recipes).
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
        less: Real::exp_m1(below(MAX_OUTER, x)),
        weight,
        last: of_degree(degree - 2),
        before: of_degree(degree - 6),
        neighbours: [of_degree(degree - 4), of_degree(degree - 8)],
        odd: [of_degree(degree - 1), of_degree(degree - 5)],
    }
}

/// P_n(x) and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    if n == 0 {
        return (1.0, 0.0);
    }
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
    use super::{Choice, LADDER, MAPS, RULES, nodes_to_highest};

    #[test]
    fn each_rule_integrates_even_polynomials() {
        for n in LADDER {
            for power in (0..=(4 * n - 2).min(300)).step_by(2) {
                let power = power as i32;
                let nodes = &Choice::plain(n as f64).rule().nodes;
                let sum: f64 = nodes
                    .iter()
                    .map(|k| k.weight * libm::pow(k.at, f64::from(power)))
                    .sum();
                assert!(
                    (sum * f64::from(power + 1) - 1.0).abs() < 1e-13,
                    "{n} {power} {sum}"
                );
            }
        }
    }

    #[test]
    fn mapped_rules_resolve_a_singularity_near_the_end() {
        // ∫₀¹ dτ/√(ε² + τ²) = asinh(1/ε), where ε may differ from that of the rule.
        for k in 0..2 * MAPS as i32 - 4 {
            let epsilon = libm::exp2(-0.5 * f64::from(k));
            let square = epsilon * epsilon;
            let choice = Choice::to_highest(nodes_to_highest(square, 100.0), square);
            let one_over = |t: f64| 1.0 / libm::hypot(epsilon, t);
            let sum: f64 = choice
                .rule()
                .nodes
                .iter()
                .map(|k| k.weight * one_over(k.at))
                .sum();
            let off = sum / libm::asinh(1.0 / epsilon) - 1.0;
            assert!(off.abs() < 1e-13, "{epsilon} {off} {choice:?}");
        }
    }

    #[test]
    fn every_index_identifies_one_rule() {
        for index in 0..RULES {
            assert_eq!(Choice::from_index(index).index(), index);
        }
    }
}
