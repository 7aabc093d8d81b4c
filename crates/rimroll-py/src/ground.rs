//! The motion of the table.

use crate::arguments::{RimrollError, refusal};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use rimroll::InvalidInput;
use rimroll::ground::{Ground, Pulse, Shape, Synthetic};
use rimroll::motion::{FlatLanding, Side};
use std::sync::Arc;

/// (kind, amplitude, period, duration, center); numbers that the kind does not have are 0.
type PulseNumbers<Name> = (Name, [f64; 3], f64, f64, f64);

/// A motion of the table, kept in the core.
#[pyclass(frozen)]
pub struct CoreGround {
    pub(crate) ground: Arc<Ground>,
}

impl From<Ground> for CoreGround {
    fn from(ground: Ground) -> CoreGround {
        let ground = Arc::new(ground);
        CoreGround { ground }
    }
}

#[pymethods]
impl CoreGround {
    /// The sum of pulses.
    #[staticmethod]
    fn from_pulses(pulses: Vec<PulseNumbers<String>>) -> PyResult<CoreGround> {
        let pulses: Result<_, _> = pulses.into_iter().map(pulse).collect();
        let ground = pulses.and_then(Ground::pulses);
        Ok(ground.map_err(refusal)?.into())
    }

    /// Samples (n, 3) of the acceleration.
    #[staticmethod]
    fn from_samples(step: f64, acceleration: PyReadonlyArray2<'_, f64>) -> PyResult<CoreGround> {
        let rows = acceleration.as_array();
        let samples = rows.rows().into_iter().map(|row| [row[0], row[1], row[2]]);
        let ground = Ground::sampled(step, samples.collect());
        Ok(ground.map_err(refusal)?.into())
    }

    /// A synthetic record of `count` samples.
    #[staticmethod]
    fn synthetic(
        seed: u64,
        peak: [f64; 3],
        step: f64,
        count: usize,
        soil_period: f64,
        soil_damping: f64,
    ) -> PyResult<CoreGround> {
        let ground = Ground::synthetic(&Synthetic {
            seed,
            peak,
            step,
            count,
            soil_period,
            soil_damping,
        });
        Ok(ground.map_err(refusal)?.into())
    }

    /// The pulses, as `from_pulses` takes them.
    fn pulses(&self) -> Vec<PulseNumbers<&'static str>> {
        self.ground.parts().0.iter().map(numbers).collect()
    }

    /// The step and the samples of the record, if there is one.
    fn samples<'py>(&self, py: Python<'py>) -> PyResult<Option<(f64, Rows<'py>)>> {
        let Some(record) = self.ground.parts().1 else {
            return Ok(None);
        };
        Ok(Some((record.step(), in_rows(py, record.samples())?)))
    }

    /// The acceleration at times, (n, 3).
    fn acceleration<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Rows<'py>> {
        let t = t.as_array();
        let values: Vec<_> = t.iter().map(|&t| self.ground.acceleration(t)).collect();
        in_rows(py, &values)
    }

    /// The velocity and the displacement since t = 0 at times, (n, 3) each.
    fn kinematics<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Rows<'py>, Rows<'py>)> {
        let (kinematics, t) = (self.ground.kinematics(), t.as_array());
        let velocities: Vec<_> = t.iter().map(|&t| kinematics.velocity(t)).collect();
        let displacements: Vec<_> = t.iter().map(|&t| kinematics.displacement(t)).collect();
        Ok((in_rows(py, &velocities)?, in_rows(py, &displacements)?))
    }

    #[getter]
    fn duration(&self) -> f64 {
        self.ground.duration()
    }

    fn scaled(&self, factor: f64) -> CoreGround {
        self.ground.scaled(factor).into()
    }

    fn rotated(&self, angle: f64) -> CoreGround {
        self.ground.rotated(angle).into()
    }

    fn plus(&self, other: &CoreGround) -> PyResult<CoreGround> {
        let sum = self.ground.plus(&other.ground);
        Ok(sum.map_err(refusal)?.into())
    }
}

type Rows<'py> = Bound<'py, PyArray2<f64>>;

fn in_rows<'py>(py: Python<'py>, rows: &[[f64; 3]]) -> PyResult<Rows<'py>> {
    rows.as_flattened()
        .to_vec()
        .into_pyarray(py)
        .reshape([rows.len(), 3])
}

fn pulse(numbers: PulseNumbers<String>) -> Result<Pulse, InvalidInput> {
    let (kind, amplitude, period, duration, center) = numbers;
    let shape = match kind.as_str() {
        "constant" => Shape::Constant,
        "sine" => Shape::Sine { period },
        "cosine" => Shape::Cosine { period },
        "ricker" => Shape::Ricker { period, center },
        _ => {
            return Err(InvalidInput::UnknownName {
                what: "kind of pulse",
                name: kind,
                choices: "constant, sine, cosine, ricker".to_owned(),
            });
        }
    };
    Ok(Pulse {
        amplitude,
        shape,
        duration,
    })
}

fn numbers(pulse: &Pulse) -> PulseNumbers<&'static str> {
    let (kind, period, center) = match pulse.shape {
        Shape::Constant => ("constant", 0.0, 0.0),
        Shape::Sine { period } => ("sine", period, 0.0),
        Shape::Cosine { period } => ("cosine", period, 0.0),
        Shape::Ricker { period, center } => ("ricker", period, center),
    };
    (kind, pulse.amplitude, period, pulse.duration, center)
}

/// What follows where the base comes down flat: (kind, restitution, seed, gap in m).
pub(crate) type FlatArgument = (String, f64, u64, f64);

/// What follows where the base comes down flat, and the gap.
pub(crate) fn flat_landing(
    (kind, restitution, seed, gap): &FlatArgument,
) -> PyResult<(FlatLanding, f64)> {
    let flat = match kind.as_str() {
        "stop" => FlatLanding::Stop,
        "housner" => FlatLanding::Housner,
        "restitution" => FlatLanding::Restitution(*restitution),
        "smooth_left" => FlatLanding::Smooth(Side::Left),
        "smooth_right" => FlatLanding::Smooth(Side::Right),
        "smooth" => FlatLanding::Smooth(Side::Drawn(*seed)),
        other => {
            let message = format!("unknown kind of flat landing: {other}");
            return Err(RimrollError::new_err(message));
        }
    };
    Ok((flat, *gap))
}
