//! Turns of many bodies. Starts are grouped by body, so that each body is prepared only once.

use super::{Exact, ExactTurn};
use crate::body::Body;
use crate::error::InvalidInput;
use crate::law::IdealLaw;
use crate::motion::{Options, Slope};
use crate::state::State;
#[cfg(feature = "threads")]
use rayon::prelude::*;
use std::collections::HashMap;

/// Rows of a body and a start each, under one of the two ideal laws.
pub struct ExactRows<'a> {
    law: IdealLaw,
    options: Options,
    rows: &'a [(&'a Body, State)],
}

impl<'a> ExactRows<'a> {
    /// Prepares the rows for gravity g (m/s²). `topple_tilt` (rad) is that of [`Options`].
    pub fn new(
        law: IdealLaw,
        gravity: f64,
        topple_tilt: Option<f64>,
        rows: &'a [(&'a Body, State)],
    ) -> Self {
        let options = Options {
            gravity,
            topple_tilt,
            ..Options::default()
        };
        ExactRows { law, options, rows }
    }

    /// The turns of all rows, equal to the last bit to those of [`Exact::turns_while`] for each body.
    ///
    /// # Errors
    /// Refuses the first row with a number outside its bounds.
    pub fn turns_while(
        &self,
        should_continue: impl Fn() -> bool + Sync,
    ) -> Result<Option<Vec<ExactTurn>>, InvalidInput> {
        self.by_body(|exact, starts| exact.turns_while(starts, &should_continue))
    }

    /// The derivatives of the turns of all rows, equal to those of [`Exact::turn_slopes_while`] for each body.
    ///
    /// # Errors
    /// As [`ExactRows::turns_while`].
    pub fn turn_slopes_while(
        &self,
        should_continue: impl Fn() -> bool + Sync,
    ) -> Result<Option<Vec<Slope>>, InvalidInput> {
        self.by_body(|exact, starts| exact.turn_slopes_while(starts, &should_continue))
    }

    /// Applies a function to the starts of each body and returns the results in the order of the rows, or
    /// `None` if the function returns `None` for any body.
    fn by_body<R: Send>(
        &self,
        of_body: impl Fn(&Exact, &[State]) -> Result<Option<Vec<R>>, InvalidInput> + Sync,
    ) -> Result<Option<Vec<R>>, InvalidInput> {
        let groups = self.groups();
        if groups.len() > 1 {
            self.options
                .check_all(self.rows.iter().copied(), |_| false)?;
        }
        let Options {
            gravity,
            topple_tilt,
            ..
        } = self.options;
        let of_group = |(body, rows): &(&Body, Vec<usize>)| {
            let starts: Vec<State> = rows.iter().map(|&row| self.rows[row].1).collect();
            of_body(&Exact::new(body, self.law, gravity, topple_tilt)?, &starts)
        };
        #[cfg(feature = "threads")]
        let each = groups.par_iter();
        #[cfg(not(feature = "threads"))]
        let each = groups.iter();
        let done: Result<Vec<Option<Vec<R>>>, InvalidInput> = each.map(of_group).collect();
        let done: Option<Vec<Vec<R>>> = done?.into_iter().collect();
        Ok(done.map(|done| in_order(&groups, done)))
    }

    /// Each body with the indices of its rows, ordered by its first row.
    fn groups(&self) -> Vec<(&'a Body, Vec<usize>)> {
        let mut place_of = HashMap::new();
        let mut groups: Vec<(&Body, Vec<usize>)> = Vec::new();
        for (row, &(body, _)) in self.rows.iter().enumerate() {
            if let Some((last, rows)) = groups.last_mut()
                && *last == body
            {
                rows.push(row);
                continue;
            }
            let place = *place_of.entry(bits(body)).or_insert(groups.len());
            if place == groups.len() {
                groups.push((body, Vec::new()));
            }
            groups[place].1.push(row);
        }
        groups
    }
}

/// The bits of all numbers of a body, as a key.
fn bits(body: &Body) -> [u64; 5] {
    [
        body.mass(),
        body.radius(),
        body.height(),
        body.transverse_inertia(),
        body.axial_inertia(),
    ]
    .map(f64::to_bits)
}

/// The results of the groups, reordered by row.
fn in_order<R>(groups: &[(&Body, Vec<usize>)], done: Vec<Vec<R>>) -> Vec<R> {
    let rows = groups.iter().flat_map(|(_, rows)| rows);
    let mut all: Vec<(usize, R)> = rows.copied().zip(done.into_iter().flatten()).collect();
    all.sort_unstable_by_key(|&(row, _)| row);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::{Exact, ExactRows};
    use crate::body::Body;
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::state::State;

    fn start(i: usize) -> State {
        State {
            tilt: 0.1 + 0.003 * i as f64,
            tilt_rate: -0.01 * (i % 50) as f64,
            yaw_rate: 0.02,
            spin_rate: 0.3 - 0.05 * (i % 11) as f64,
            ..State::default()
        }
    }

    /// The results of `Exact` for each row alone, printed with enough digits to identify every bit.
    fn one_by_one(law: IdealLaw, rows: &[(&Body, State)]) -> Vec<[String; 2]> {
        let of_row = |(body, start): &(&Body, State)| {
            let exact = Exact::new(body, law, 9.8, None).expect("a valid body");
            let slopes = exact.turn_slopes(&[*start]).expect("a valid start");
            let turns = exact.turns(&[*start]).expect("a valid start");
            [format!("{turns:?}"), format!("{slopes:?}")]
        };
        rows.iter().map(of_row).collect()
    }

    #[test]
    fn rows_of_many_bodies_equal_those_of_each_body_to_the_last_bit() {
        let bodies = [
            presets::can_2007().expect("a can"),
            presets::coin().expect("a coin"),
            presets::cylinder(0.03, 0.1).expect("a cylinder"),
        ];
        // The rows are not sorted by body, and one body occurs only once.
        let rows: Vec<_> = (0..100)
            .map(|i| (&bodies[if i == 41 { 2 } else { i / 3 % 2 }], start(i)))
            .collect();
        for law in IdealLaw::ALL {
            let exact = ExactRows::new(law, 9.8, None, &rows);
            let turns = exact.turns_while(|| true).expect("valid rows");
            let slopes = exact.turn_slopes_while(|| true).expect("valid rows");
            let rocking: Vec<_> = turns
                .expect("nothing has ended the work")
                .into_iter()
                .zip(slopes.expect("nothing has ended the work"))
                .map(|(turn, slope)| [format!("{:?}", [turn]), format!("{:?}", [slope])])
                .collect();
            assert_eq!(rocking, one_by_one(law, &rows));
            assert!(exact.turns_while(|| false).expect("valid rows").is_none());
        }
    }

    #[test]
    fn the_first_row_that_is_out_of_bounds_is_refused() {
        let [can, coin] = [presets::can_2007(), presets::coin()].map(|body| body.expect("a body"));
        let bad = |tilt| State { tilt, ..start(0) };
        let rows = [(&can, start(0)), (&coin, bad(-2.0)), (&can, bad(-1.0))];
        let exact = ExactRows::new(IdealLaw::NoSlip, 9.8, None, &rows);
        let refusal = exact.turns_while(|| true).expect_err("a bad tilt");
        assert!(refusal.to_string().contains("-2"), "{refusal}");
    }
}
