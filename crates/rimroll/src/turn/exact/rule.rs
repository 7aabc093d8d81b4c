//! Gauss-Legendre rules for even functions: the n nodes in (0, 1) of the rule with 2n on (−1, 1).
//!
//! Of a function that is singular close to 0, at τ = ± i ε, they see little. τ = ε sinh(A u), sinh A = 1/ε,
//! brings both ends of (0, 1) to those of u and the singularity to u = ± i π/(2A), far from them.

use super::MAX_OUTER;
use crate::real::{Real, approx_acosh, approx_asinh};
use std::sync::OnceLock;

/// How many nodes each rule of the ladder has.
const LADDER: [usize; 16] = [4, 6, 8, 10, 12, 14, 16, 18, 20, 24, 28, 34, 42, 56, 80, 120];

/// The first rung with so many nodes.
const ENOUGH: [u8; MOST + 1] = {
    let (mut enough, mut nodes, mut rung) = ([0; MOST + 1], 0, 0);
    while nodes <= MOST {
        if nodes > LADDER[rung as usize] {
            rung += 1;
        }
        enough[nodes] = rung;
        nodes += 1;
    }
    enough
};
const MOST: usize = LADDER[LADDER.len() - 1];

/// How many rungs a rule is taken larger when it has not resolved its piece.
const CLIMB: usize = 1;

/// How often ε is halved, from 1 on; before that, rules that stretch nothing.
const STRETCHES: usize = 13;

/// How many rules there are.
pub(super) const RULES: usize = STRETCHES * LADDER.len();

static SHELF: [OnceLock<Rule>; RULES] = [const { OnceLock::new() }; RULES];

/// Which of the rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Choice {
    /// 0: none; k: ε = 2^(1 − k).
    stretch: usize,
    rung: usize,
}

impl Choice {
    /// About so many nodes, and nothing stretched.
    pub(super) fn plain(nodes: f64) -> Choice {
        // Rounded up, for which processors of old have no instruction.
        let whole = nodes.min(MOST as f64 + 1.0) as usize;
        let enough = ENOUGH.get(whole + usize::from((whole as f64) < nodes));
        Choice {
            stretch: 0,
            rung: enough.map_or(LADDER.len() - 1, |&rung| rung.into()),
        }
    }

    /// For a piece to the largest tilt, of so many nodes, where the integrand is singular at τ² = −`square`.
    pub(super) fn to_highest(nodes: f64, square: f64) -> Choice {
        let plain = Choice::plain(nodes);
        if square >= UNSTRETCHED {
            return plain;
        }
        // The least k for which ε² = 4^(1 − k) is not above the square, by the square's exponent.
        let exponent = ((square.to_bits() >> 52) & 0x7FF) as i64 - 1023;
        let halvings = (1 - exponent.min(0)) as usize / 2;
        Choice {
            stretch: (1 + halvings).min(STRETCHES - 1),
            ..plain
        }
    }

    /// One with more nodes.
    pub(super) fn larger(self) -> Option<Choice> {
        let rung = self.rung + CLIMB;
        (rung < LADDER.len()).then_some(Choice { rung, ..self })
    }

    /// Its place among the [`RULES`].
    pub(super) fn place(self) -> usize {
        self.stretch * LADDER.len() + self.rung
    }

    /// The one in that place.
    pub(super) fn at(place: usize) -> Choice {
        Choice {
            stretch: place / LADDER.len(),
            rung: place % LADDER.len(),
        }
    }

    /// How many nodes it has.
    pub(super) fn nodes(self) -> usize {
        LADDER[self.rung]
    }

    /// The rule itself, made when it is first used.
    pub(super) fn rule(self) -> &'static Rule {
        SHELF[self.place()].get_or_init(|| Rule::new(self))
    }
}

/// Where the integrand is singular at a greater distance, squared, nothing is stretched.
const UNSTRETCHED: f64 = 2.0;

/// Nodes that a piece from the smallest tilt needs, times the error's logarithmic decrement ln ρ: it falls off
/// like ρ^−4n.
const LOW_DIGITS: f64 = 8.2;

/// The same for a piece to the largest.
const HIGH_DIGITS: f64 = 9.5;

/// The same where it takes more to be sure.
const SURE_DIGITS: f64 = 11.0;

/// Nodes for what else the integrand does in a passage.
const ELSEWHERE: f64 = 2.0;

/// About how many nodes a piece from the smallest tilt needs, `length` long in η, where beyond that the integrand
/// is singular after another `rest`: in the plane of τ at √(1 + rest/length).
#[inline(always)]
pub(super) fn nodes_from_lowest<T: Real>(length: T, rest: T) -> T {
    T::from(LOW_DIGITS) / approx_asinh((rest / length).sqrt())
}

/// The same for a piece on to the balance point, that far, to whose sides the integrand is singular.
#[inline(always)]
pub(super) fn nodes_towards<T: Real>(length: T, rest: T, aside: T) -> T {
    let distance = (rest * rest + aside * aside).sqrt();
    let decrement = approx_asinh(((distance + rest) / (length + length)).sqrt());
    T::from(SURE_DIGITS) / decrement
}

/// For a passage over the balance point, `half` long to both sides by its clock, in whose plane the integrand is
/// singular at ± i π/2.
#[inline(always)]
pub(super) fn nodes_across<T: Real>(half: T) -> T {
    let decrement = approx_asinh(T::from(core::f64::consts::FRAC_PI_2) / half);
    T::from(ELSEWHERE) + T::from(SURE_DIGITS) / decrement
}

/// For a piece to the largest tilt, where beyond the balance point the integrand is singular at τ² = −`square`, and
/// at the smallest tilt at τ² = `far`.
#[inline(always)]
pub(super) fn nodes_to_highest<T: Real>(square: T, far: T) -> T {
    let one = T::from(1.0);
    let (near, far) = (square.sqrt(), far.sqrt());
    let plain = approx_asinh(near).min(approx_acosh(far));
    // Of a stretch between the distance and half of it.
    let epsilon = (T::from(0.7) * near).min(one);
    let length = approx_asinh(one / epsilon);
    let aside = approx_asinh(T::from(core::f64::consts::FRAC_PI_2) / length);
    let stretched = aside.min(approx_acosh(approx_asinh(far / epsilon) / length));
    let is_stretched = square - T::from(UNSTRETCHED);
    T::from(HIGH_DIGITS) / is_stretched.where_negative(stretched, plain)
}

/// How far a node at τ is from the end of a piece, to the largest tilt, of some length, in η.
#[inline(always)]
pub(super) fn below<T: Real>(length: T, at: T) -> T {
    -(length * (at * at))
}

/// Nodes and weights on (0, 1).
pub(super) struct Rule {
    pub(super) nodes: Vec<Node>,
}

/// One of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// τ.
    pub(super) at: f64,
    /// exp(−Λτ²) − 1 for a Λ of [`MAX_OUTER`].
    pub(super) less: f64,
    pub(super) weight: f64,
    /// Weight, times P_{2n−2} at the node and its norm: what sums to the coefficient of the last
    /// Legendre polynomial that the rule can see.
    pub(super) last: f64,
    /// The same of P_{2n−6}.
    pub(super) before: f64,
    /// The same of P_{2n−4} and P_{2n−8}, to look beside the two.
    pub(super) beside: [f64; 2],
    /// The same of P_{2n−1} and P_{2n−5}, of functions that are odd.
    pub(super) odd: [f64; 2],
}

impl Rule {
    fn new(choice: Choice) -> Rule {
        let n = choice.nodes();
        let plain = (0..n).map(|i| node(2 * n, i));
        let nodes = match choice.stretch {
            0 => plain.collect(),
            k => plain
                .map(|node| node.stretched(libm::ldexp(1.0, 1 - k as i32)))
                .collect(),
        };
        Rule { nodes }
    }
}

impl Node {
    fn stretched(self, epsilon: f64) -> Node {
        let length = libm::asinh(1.0 / epsilon);
        let factor = epsilon * length * libm::cosh(length * self.at);
        let at = epsilon * libm::sinh(length * self.at);
        Node {
            at,
            less: Real::exp_m1(below(MAX_OUTER, at)),
            weight: factor * self.weight,
            last: factor * self.last,
            before: factor * self.before,
            beside: self.beside.map(|weight| factor * weight),
            odd: self.odd.map(|weight| factor * weight),
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
        less: Real::exp_m1(below(MAX_OUTER, x)),
        weight,
        last: of_degree(degree - 2),
        before: of_degree(degree - 6),
        beside: [of_degree(degree - 4), of_degree(degree - 8)],
        odd: [of_degree(degree - 1), of_degree(degree - 5)],
    }
}

/// P_n(x) and its slope.
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
    use super::{Choice, LADDER, RULES, STRETCHES, nodes_to_highest};

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
    fn stretched_rules_see_what_is_singular_near_the_end() {
        // ∫₀¹ dτ/√(ε² + τ²) = asinh(1/ε), with ε not quite the rule's own.
        for k in 0..2 * STRETCHES as i32 - 4 {
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
    fn every_choice_has_its_place() {
        for place in 0..RULES {
            assert_eq!(Choice::at(place).place(), place);
        }
    }
}
