//! Dry friction with a tabulated dependence on the slip speed: T = −μ(|u|) N u/|u|.
//!
//! This is Coulomb's law with a variable coefficient. The rim rolls while |T| ≤ μ_s N suffices, and nothing
//! is regularised (see [`Coulomb`](super::Coulomb)). Between the points of the table the curve is a monotone
//! piecewise cubic with a continuous slope, which interpolates the points without overshoot and so is
//! never negative. Below the first speed and above the last it is constant. Source of the slopes:
//! F. N. Fritsch & J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984), with the three-point formula at the
//! ends of C. Moler, *Numerical Computing with MATLAB* (2004), section 3.6.

use super::coulomb::MAX_FRICTION;
use super::{
    DryFriction, DryFrictionModel, Friction, FrictionForce, FrictionModel, NamedParameters,
};
use crate::error::{InvalidInput, bounded, entry};
use crate::real::Scalar;
use std::sync::Arc;

/// Friction whose coefficient is a function of the slip speed, interpolated between points.
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    curve: Arc<Curve>,
    /// Multiplies the curve.
    factor: f64,
    static_friction: f64,
}

impl Tabulated {
    /// Friction through points with the given `speeds` (m/s) and `frictions`. The default of
    /// `static_friction` is the friction at the lowest speed.
    ///
    /// # Errors
    /// Names the first entry that is out of bounds. There must be at least two points; speeds must be from 0
    /// to 1e9 m/s, each at least 1e-12 m/s above the one before; frictions must be from 0 to 1e6, and
    /// the static one from that of the lowest speed to 1e6.
    pub fn new(
        speeds: &[f64],
        frictions: &[f64],
        static_friction: Option<f64>,
    ) -> Result<Tabulated, InvalidInput> {
        check_points(speeds, frictions)?;
        let slowest = frictions[0];
        let static_friction = static_friction.unwrap_or(slowest);
        bounded(
            "static",
            static_friction,
            |f| (slowest..=MAX_FRICTION).contains(&f),
            &format!("between frictions[0] = {slowest} and 1e6"),
            "",
        )
        .map_err(|error| error.beside("frictions"))?;
        Ok(Tabulated {
            curve: Arc::new(Curve::through(speeds, frictions)),
            factor: 1.0,
            static_friction,
        })
    }

    /// The points of the curve: speeds (m/s) and coefficients of friction.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        let curve = &self.curve;
        let points = curve.pieces.iter().map(|piece| (piece.begin, piece.value));
        let points = points.chain([(curve.end, curve.value_at_end)]);
        points.map(|(speed, value)| (speed, self.factor * value))
    }
}

impl<T: Scalar> Friction<T> for Tabulated {
    #[inline]
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        self.dry_friction_force(slip)
    }
}

impl<T: Scalar> DryFriction<T> for Tabulated {
    #[inline]
    fn coefficient(&self, speed: T) -> T {
        T::from(self.factor) * self.curve.at(speed)
    }
}

impl FrictionModel for Tabulated {
    const NAME: &'static str = "tabulated";

    type Friction<T: Scalar> = Tabulated;

    /// The lists `speeds` and `frictions`, and `static` if it differs from the friction at the lowest speed.
    fn from_named(given: &NamedParameters<'_>) -> Result<Self, InvalidInput> {
        let (speeds, frictions) = (given.table("speeds"), given.table("frictions"));
        Tabulated::new(speeds, frictions, given.optional("static"))
    }

    /// Checks the coefficients, since [`scaled`](FrictionModel::scaled) can put them out of bounds.
    fn check(&self) -> Result<(), InvalidInput> {
        let sensible = |f: f64| (0.0..=MAX_FRICTION).contains(&f);
        let largest = self.factor * self.curve.largest;
        bounded("frictions", largest, sensible, "between 0 and 1e6", "")?;
        bounded(
            "static",
            self.static_friction,
            sensible,
            "between 0 and 1e6",
            "",
        )?;
        Ok(())
    }

    fn scaled(&self, factor: f64) -> Self {
        Tabulated {
            curve: Arc::clone(&self.curve),
            factor: self.factor * factor,
            static_friction: self.static_friction * factor,
        }
    }

    fn impact_coefficient<T: Scalar>(&self, slip_speed: T) -> T {
        self.coefficient(slip_speed)
    }

    fn friction<T: Scalar>(&self) -> Tabulated {
        self.clone()
    }
}

impl DryFrictionModel for Tabulated {
    fn static_friction(&self) -> f64 {
        self.static_friction
    }
}

fn check_points(speeds: &[f64], frictions: &[f64]) -> Result<(), InvalidInput> {
    const MIN_STEP: f64 = 1e-12;
    const MAX_SPEED: f64 = 1e9;
    if speeds.len() < 2 {
        return Err(InvalidInput::WrongLength {
            field: "speeds",
            bound: "at least 2 entries".to_owned(),
            count: speeds.len(),
        });
    }
    if frictions.len() != speeds.len() {
        return Err(InvalidInput::WrongLength {
            field: "frictions",
            bound: format!("as many entries as speeds, {}", speeds.len()),
            count: frictions.len(),
        });
    }
    let unit = "m/s";
    for (i, &speed) in speeds.iter().enumerate() {
        let sensible = |v: f64| (0.0..=MAX_SPEED).contains(&v);
        entry("speeds", i, speed, sensible, "between 0 and 1e9 m/s", unit)?;
        if i > 0 {
            let before = speeds[i - 1];
            let bound = format!("at least 1e-12 m/s above speeds[{}] = {before}", i - 1);
            let above = |v: f64| v - before >= MIN_STEP;
            entry("speeds", i, speed, above, &bound, unit)?;
        }
    }
    for (i, &friction) in frictions.iter().enumerate() {
        let sensible = |f: f64| (0.0..=MAX_FRICTION).contains(&f);
        entry("frictions", i, friction, sensible, "between 0 and 1e6", "")?;
    }
    Ok(())
}

/// A monotone piecewise cubic.
#[derive(Debug, PartialEq)]
struct Curve {
    /// In increasing order of `begin`.
    pieces: Box<[Piece]>,
    end: f64,
    value_at_end: f64,
    /// The largest value, which is at one of the points.
    largest: f64,
}

/// value + x (slope + x (square + x cube)) at `begin` + x.
#[derive(Debug, PartialEq)]
struct Piece {
    begin: f64,
    value: f64,
    slope: f64,
    square: f64,
    cube: f64,
}

impl Curve {
    /// The curve through at least two points in increasing order of x.
    fn through(x: &[f64], y: &[f64]) -> Curve {
        let widths: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
        let secants: Vec<f64> = (y.windows(2).zip(&widths))
            .map(|(y, width)| (y[1] - y[0]) / width)
            .collect();
        let slopes = slopes(&widths, &secants);
        let piece = |i: usize| Piece {
            begin: x[i],
            value: y[i],
            slope: slopes[i],
            square: (3.0 * secants[i] - 2.0 * slopes[i] - slopes[i + 1]) / widths[i],
            cube: (slopes[i] + slopes[i + 1] - 2.0 * secants[i]) / (widths[i] * widths[i]),
        };
        let last = widths.len();
        Curve {
            pieces: (0..last).map(piece).collect(),
            end: x[last],
            value_at_end: y[last],
            largest: y.iter().fold(y[0], |max, &value| max.max(value)),
        }
    }

    #[inline]
    fn at<T: Scalar>(&self, x: T) -> T {
        let plain = x.value();
        if plain >= self.end {
            return self.value_at_end.into();
        }
        let after = self.pieces.partition_point(|piece| piece.begin <= plain);
        let Some(piece) = after.checked_sub(1).map(|i| &self.pieces[i]) else {
            return self.pieces[0].value.into();
        };
        let x = x - piece.begin.into();
        let higher = T::from(piece.square) + x * piece.cube.into();
        T::from(piece.value) + x * (T::from(piece.slope) + x * higher)
    }
}

/// The slopes at the points, from the widths of the intervals and the slopes of their secants.
fn slopes(widths: &[f64], secants: &[f64]) -> Vec<f64> {
    let last = widths.len() - 1;
    if last == 0 {
        return vec![secants[0]; 2];
    }
    let mut slopes = vec![end_slope([widths[0], widths[1]], [secants[0], secants[1]])];
    for (h, d) in widths.windows(2).zip(secants.windows(2)) {
        // Zero at an extremum, else the weighted harmonic mean.
        slopes.push(if d[0] * d[1] > 0.0 {
            let (before, after) = (2.0 * h[1] + h[0], h[1] + 2.0 * h[0]);
            (before + after) / (before / d[0] + after / d[1])
        } else {
            0.0
        });
    }
    let from_the_end = [last, last - 1];
    slopes.push(end_slope(
        from_the_end.map(|i| widths[i]),
        from_the_end.map(|i| secants[i]),
    ));
    slopes
}

/// The slope at an end point: that of the parabola through three points, limited to keep the curve monotone.
fn end_slope(h: [f64; 2], d: [f64; 2]) -> f64 {
    let slope = ((2.0 * h[0] + h[1]) * d[0] - h[0] * d[1]) / (h[0] + h[1]);
    if slope * d[0] <= 0.0 {
        0.0
    } else if d[0] * d[1] <= 0.0 && slope.abs() > 3.0 * d[0].abs() {
        3.0 * d[0]
    } else {
        slope
    }
}

#[cfg(test)]
mod tests {
    use super::Tabulated;
    use crate::law::DryFriction;
    use proptest::prelude::*;

    fn any_table() -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
        prop::collection::vec((1e-6..1.0, 0.0..2.0), 2..12).prop_map(|points| {
            let mut speed = 0.0;
            points
                .into_iter()
                .map(|(step, friction)| {
                    speed += step;
                    (speed, friction)
                })
                .unzip()
        })
    }

    proptest! {
        #[test]
        fn the_curve_goes_through_its_points_and_overshoots_none((speeds, frictions) in any_table()) {
            let law = Tabulated::new(&speeds, &frictions, Some(2.0)).unwrap();
            for (&speed, &friction) in speeds.iter().zip(&frictions) {
                prop_assert!((law.coefficient(speed) - friction).abs() <= 1e-15);
            }
            for (x, y) in speeds.windows(2).zip(frictions.windows(2)) {
                let sign = (y[1] - y[0]).signum();
                let mut before = y[0];
                for i in 1..=20 {
                    let now = law.coefficient(x[0] + (x[1] - x[0]) * f64::from(i) / 20.0);
                    prop_assert!(sign * (now - before) >= -1e-14, "{now} after {before}");
                    before = now;
                }
            }
            prop_assert_eq!(law.coefficient(0.0), frictions[0]);
            prop_assert_eq!(law.coefficient(1e9), *frictions.last().unwrap());
        }

        #[test]
        fn the_slope_is_continuous_at_the_points((speeds, frictions) in any_table()) {
            let law = Tabulated::new(&speeds, &frictions, Some(2.0)).unwrap();
            for i in 1..speeds.len() - 1 {
                let h = 1e-4 * (speeds[i] - speeds[i - 1]).min(speeds[i + 1] - speeds[i]);
                let at = |x: f64| law.coefficient(speeds[i] + x);
                let (before, after) = ((at(0.0) - at(-h)) / h, (at(h) - at(0.0)) / h);
                // Over h the slope changes by about h times the second derivative, which the secants bound.
                let secant = |i: usize| {
                    ((frictions[i] - frictions[i - 1]) / (speeds[i] - speeds[i - 1])).abs()
                };
                let steepest = secant(i).max(secant(i + 1));
                prop_assert!((after - before).abs() <= 3e-3 * steepest + 1e-9 / h * 1e-6);
            }
        }
    }

    /// Two points give a straight line. Three points on a monotone part of a parabola give its slope at the
    /// end.
    #[test]
    fn few_points_give_a_line_and_the_end_slope_of_a_parabola() {
        let line = Tabulated::new(&[0.0, 2.0], &[0.4, 0.2], None).unwrap();
        assert!((line.coefficient(0.5) - 0.35).abs() < 1e-16);
        assert_eq!(line.static_friction, 0.4);
        let parabola = Tabulated::new(&[0.0, 1.0, 2.0], &[0.0, 0.1, 0.4], None).unwrap();
        assert!(parabola.coefficient(1e-9).abs() < 1e-17);
    }

    #[test]
    fn bad_tables_are_refused_by_field_value_and_bound() {
        let refused = |speeds: &[f64], frictions: &[f64], sticking: Option<f64>| {
            let refusal = Tabulated::new(speeds, frictions, sticking).unwrap_err();
            refusal.to_string()
        };
        assert_eq!(
            refused(&[0.0], &[0.1], None),
            "speeds must have at least 2 entries, got 1"
        );
        assert_eq!(
            refused(&[0.0, 1.0], &[0.1], None),
            "frictions must have as many entries as speeds, 2, got 1"
        );
        assert_eq!(
            refused(&[-1.0, 1.0], &[0.1, 0.1], None),
            "speeds[0] must be between 0 and 1e9 m/s, got -1 m/s"
        );
        assert_eq!(
            refused(&[0.0, 1.0, 0.5], &[0.1; 3], None),
            "speeds[2] must be at least 1e-12 m/s above speeds[1] = 1, got 0.5 m/s"
        );
        assert_eq!(
            refused(&[0.0, f64::NAN], &[0.1; 2], None),
            "speeds[1] must be between 0 and 1e9 m/s, got NaN m/s"
        );
        assert_eq!(
            refused(&[0.0, 1.0], &[0.1, -0.1], None),
            "frictions[1] must be between 0 and 1e6, got -0.1"
        );
        assert_eq!(
            refused(&[0.0, 1.0], &[0.3, 0.1], Some(0.2)),
            "static must be between frictions[0] = 0.3 and 1e6, got 0.2"
        );
    }
}
