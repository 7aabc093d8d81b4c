//! The coefficients of the explicit Runge-Kutta pair of order 8(5,3) by Dormand and Prince, with
//! the three extra stages of its dense output of order 7.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*,
//! 2nd ed., Springer 1993, section II.10 (the code DOP853). `tests` checks the order conditions.
//! Rows are sparse: pairs of (stage, weight); the nodes are absent because every system here is
//! autonomous.

/// One row of the tableau: (stage, weight) for every weight that is not zero.
pub type Row = &'static [(usize, f64)];

/// The weights of the stages 1..12 with respect to the earlier ones.
pub const STAGES: [Row; 11] = [
    &[(0, 0.05260015195876773)],
    &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
    &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
    &[
        (0, 0.2413651341592667),
        (2, -0.8845494793282861),
        (3, 0.924834003261792),
    ],
    &[
        (0, 0.037037037037037035),
        (3, 0.17082860872947386),
        (4, 0.12546768756682242),
    ],
    &[
        (0, 0.037109375),
        (3, 0.17025221101954405),
        (4, 0.06021653898045596),
        (5, -0.017578125),
    ],
    &[
        (0, 0.03709200011850479),
        (3, 0.17038392571223998),
        (4, 0.10726203044637328),
        (5, -0.015319437748624402),
        (6, 0.008273789163814023),
    ],
    &[
        (0, 0.6241109587160757),
        (3, -3.3608926294469414),
        (4, -0.868219346841726),
        (5, 27.59209969944671),
        (6, 20.154067550477894),
        (7, -43.48988418106996),
    ],
    &[
        (0, 0.47766253643826434),
        (3, -2.4881146199716677),
        (4, -0.590290826836843),
        (5, 21.230051448181193),
        (6, 15.279233632882423),
        (7, -33.28821096898486),
        (8, -0.020331201708508627),
    ],
    &[
        (0, -0.9371424300859873),
        (3, 5.186372428844064),
        (4, 1.0914373489967295),
        (5, -8.149787010746927),
        (6, -18.52006565999696),
        (7, 22.739487099350505),
        (8, 2.4936055526796523),
        (9, -3.0467644718982196),
    ],
    &[
        (0, 2.273310147516538),
        (3, -10.53449546673725),
        (4, -2.0008720582248625),
        (5, -17.9589318631188),
        (6, 27.94888452941996),
        (7, -2.8589982771350235),
        (8, -8.87285693353063),
        (9, 12.360567175794303),
        (10, 0.6433927460157636),
    ],
];

/// Weights of the solution of order 8.
pub const SOLUTION: Row = &[
    (0, 0.054293734116568765),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, 0.3111643669578199),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.04471061572777259),
];

/// Weights of the embedded error estimate of order 5; stage 12 is the rate at the end.
pub const ERROR_5: Row = &[
    (0, 0.01312004499419488),
    (5, -1.2251564463762044),
    (6, -0.4957589496572502),
    (7, 1.6643771824549864),
    (8, -0.35032884874997366),
    (9, 0.3341791187130175),
    (10, 0.08192320648511571),
    (11, -0.022355307863886294),
];

/// Weights of the embedded error estimate of order 3; stage 12 is the rate at the end.
pub const ERROR_3: Row = &[
    (0, -0.18980075407240762),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, -0.4226823213237919),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.02265179219836082),
];

/// The weights of the stages 13..16, which only dense output needs.
pub const EXTRA_STAGES: [Row; 3] = [
    &[
        (0, 0.056167502283047954),
        (6, 0.25350021021662483),
        (7, -0.2462390374708025),
        (8, -0.12419142326381637),
        (9, 0.15329179827876568),
        (10, 0.00820105229563469),
        (11, 0.007567897660545699),
        (12, -0.008298),
    ],
    &[
        (0, 0.03183464816350214),
        (5, 0.028300909672366776),
        (6, 0.053541988307438566),
        (7, -0.05492374857139099),
        (10, -0.00010834732869724932),
        (11, 0.0003825710908356584),
        (12, -0.00034046500868740456),
        (13, 0.1413124436746325),
    ],
    &[
        (0, -0.42889630158379194),
        (5, -4.697621415361164),
        (6, 7.683421196062599),
        (7, 4.06898981839711),
        (8, 0.3567271874552811),
        (12, -0.0013990241651590145),
        (13, 2.9475147891527724),
        (14, -9.15095847217987),
    ],
];

/// Weights of the four highest coefficients of the dense output.
pub const DENSE: [Row; 4] = [
    &[
        (0, -8.428938276109013),
        (5, 0.5667149535193777),
        (6, -3.0689499459498917),
        (7, 2.38466765651207),
        (8, 2.117034582445028),
        (9, -0.871391583777973),
        (10, 2.2404374302607883),
        (11, 0.6315787787694688),
        (12, -0.08899033645133331),
        (13, 18.148505520854727),
        (14, -9.194632392478356),
        (15, -4.436036387594894),
    ],
    &[
        (0, 10.427508642579134),
        (5, 242.28349177525817),
        (6, 165.20045171727028),
        (7, -374.5467547226902),
        (8, -22.113666853125306),
        (9, 7.733432668472264),
        (10, -30.674084731089398),
        (11, -9.332130526430229),
        (12, 15.697238121770845),
        (13, -31.139403219565178),
        (14, -9.35292435884448),
        (15, 35.81684148639408),
    ],
    &[
        (0, 19.985053242002433),
        (5, -387.0373087493518),
        (6, -189.17813819516758),
        (7, 527.8081592054236),
        (8, -11.57390253995963),
        (9, 6.8812326946963),
        (10, -1.0006050966910838),
        (11, 0.7777137798053443),
        (12, -2.778205752353508),
        (13, -60.19669523126412),
        (14, 84.32040550667716),
        (15, 11.99229113618279),
    ],
    &[
        (0, -25.69393346270375),
        (5, -154.18974869023643),
        (6, -231.5293791760455),
        (7, 357.6391179106141),
        (8, 93.40532418362432),
        (9, -37.45832313645163),
        (10, 104.0996495089623),
        (11, 29.8402934266605),
        (12, -43.53345659001114),
        (13, 96.32455395918828),
        (14, -39.17726167561544),
        (15, -149.72683625798564),
    ],
];

#[cfg(test)]
mod tests {
    //! The order conditions of Hairer, Nørsett & Wanner, sections II.1, II.5 and II.10, and the orders
    //! measured on a Kepler orbit.

    use super::super::{Step, System};
    use super::{ERROR_3, ERROR_5, EXTRA_STAGES, Row, SOLUTION, STAGES};
    use core::f64::consts::PI;

    /// Allows for rounding in sums over coefficients as large as 40 with 16 digits.
    const ROUNDING: f64 = 3e-13;

    /// The rows of all sixteen stages. The first stage is at the start, the thirteenth at the end.
    fn rows() -> Vec<Row> {
        let start: Row = &[];
        [start]
            .into_iter()
            .chain(STAGES)
            .chain([SOLUTION])
            .chain(EXTRA_STAGES)
            .collect()
    }

    fn sum(row: Row, term: impl Fn(usize) -> f64) -> f64 {
        row.iter()
            .map(|&(stage, weight)| weight * term(stage))
            .sum()
    }

    fn power(x: f64, k: u32) -> f64 {
        (0..k).fold(1.0, |product, _| product * x)
    }

    /// The nodes c: the fraction of the step at each stage.
    fn nodes() -> Vec<f64> {
        rows().into_iter().map(|row| sum(row, |_| 1.0)).collect()
    }

    fn near(value: f64, expected: f64) -> bool {
        (value - expected).abs() < ROUNDING
    }

    #[test]
    fn the_nodes_are_those_of_the_method() {
        let expected = [
            (0, 0.0),
            (5, 1.0 / 3.0),
            (6, 0.25),
            (7, 4.0 / 13.0),
            (8, 127.0 / 195.0),
            (9, 0.6),
            (10, 6.0 / 7.0),
            (11, 1.0),
            (12, 1.0),
            (13, 0.1),
            (14, 0.2),
            (15, 7.0 / 9.0),
        ];
        let c = nodes();
        for (stage, node) in expected {
            assert!(near(c[stage], node), "stage {stage}");
        }
    }

    /// Σ bᵢ cᵢᵏ = 1/(k + 1).
    #[test]
    fn the_solution_integrates_polynomials_up_to_the_seventh_degree() {
        let c = nodes();
        let integral = |k| sum(SOLUTION, |stage| power(c[stage], k));
        for k in 0..8 {
            assert!(near(integral(k), 1.0 / f64::from(k + 1)), "degree {k}");
        }
        assert!(!near(integral(8), 1.0 / 9.0));
    }

    /// Σ aᵢⱼ cⱼᵏ = cᵢᵏ⁺¹/(k + 1): up to k = 2 for the first stages, which have zero weight in the solution,
    /// up to 4 for those with weight, and up to 5 for those of the dense output.
    #[test]
    fn the_stages_are_themselves_solutions_of_lower_order() {
        let c = nodes();
        for (stage, row) in rows().into_iter().enumerate().skip(2) {
            let degree = match stage {
                2..=4 => 2,
                5..=11 => 4,
                _ => 5,
            };
            for k in 1..=degree {
                let integral = sum(row, |j| power(c[j], k));
                let expected = power(c[stage], k + 1) / f64::from(k + 1);
                assert!(near(integral, expected), "stage {stage}, degree {k}");
            }
        }
        assert!(SOLUTION.iter().all(|&(stage, _)| !(1..=4).contains(&stage)));
    }

    /// Σᵢ bᵢ aᵢⱼ = bⱼ (1 − cⱼ): the simplifying assumption D(1), which covers the trees whose root has one
    /// branch.
    #[test]
    fn the_columns_simplify() {
        let weight = |row: Row, stage: usize| {
            row.iter()
                .find(|(other, _)| *other == stage)
                .map_or(0.0, |(_, weight)| *weight)
        };
        let (rows, c) = (rows(), nodes());
        for (j, node) in c.into_iter().enumerate().take(12) {
            let column = sum(SOLUTION, |i| weight(rows[i], j));
            let expected = weight(SOLUTION, j) * (1.0 - node);
            assert!(near(column, expected), "column {j}");
        }
    }

    /// Solution and embedded solution agree for polynomials below the order of the latter.
    #[test]
    fn the_error_estimates_have_orders_5_and_3() {
        let c = nodes();
        for (estimate, order) in [(ERROR_5, 5), (ERROR_3, 3)] {
            let moment = |k| sum(estimate, |stage| power(c[stage], k));
            assert!((0..order).all(|k| near(moment(k), 0.0)));
            assert!(moment(order).abs() > 1e-4);
        }
    }

    /// A planet at unit distance scale: x, y and their rates under the attraction 1/r².
    struct Planet;

    impl System<f64, 4> for Planet {
        fn rates(&self, u: &[f64; 4]) -> [f64; 4] {
            let [x, y, vx, vy] = *u;
            let square = x * x + y * y;
            let pull = -1.0 / (square * square.sqrt());
            [vx, vy, pull * x, pull * y]
        }

        fn scale(&self, _: &[f64; 4]) -> [f64; 4] {
            [1.0; 4]
        }
    }

    const ECCENTRICITY: f64 = 0.3;

    /// The position of the planet at the time t after perihelion, by Kepler's equation t = E − e sin E.
    fn planet(t: f64) -> [f64; 4] {
        let e = ECCENTRICITY;
        let mut anomaly = t;
        for _ in 0..20 {
            let (sin, cos) = libm::sincos(anomaly);
            anomaly -= (anomaly - e * sin - t) / (1.0 - e * cos);
        }
        let (sin, cos) = libm::sincos(anomaly);
        let (breadth, rate) = ((1.0 - e * e).sqrt(), 1.0 / (1.0 - e * cos));
        [cos - e, breadth * sin, -sin * rate, breadth * cos * rate]
    }

    fn distance(a: &[f64; 4], b: &[f64; 4]) -> f64 {
        a.iter()
            .zip(b)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max)
    }

    /// The order of convergence, from the errors before and after halving the step size.
    fn order(error: impl Fn(u32) -> f64, steps: u32) -> f64 {
        libm::log2(error(steps) / error(2 * steps))
    }

    #[test]
    fn the_solution_converges_with_order_8() {
        let after_half_a_year = |steps: u32| {
            let h = PI / f64::from(steps);
            let end = (0..steps).fold(planet(0.0), |u, _| Step::take(&Planet, &u, h).end);
            distance(&end, &planet(PI))
        };
        let order = order(after_half_a_year, 10);
        assert!((order - 8.0).abs() < 0.5, "{order}");
    }

    /// Within one step the error is proportional to the 8th power of the step size, so the order is 7.
    #[test]
    fn the_dense_output_converges_with_order_7() {
        let within_one_step = |steps: u32| {
            let (start, h) = (0.5, PI / f64::from(steps));
            let u = planet(start);
            let dense = Step::take(&Planet, &u, h).dense(&Planet);
            (0..=16)
                .map(|i| f64::from(i) / 16.0)
                .map(|x| distance(&dense.at(x), &planet(start + x * h)))
                .fold(0.0, f64::max)
        };
        let order = order(within_one_step, 10);
        assert!((order - 8.0).abs() < 0.5, "{order}");
    }
}
