//! A column on a table that moves by a record: the tilts at the end.

use crate::protocol::Question;
use core::ops::ControlFlow;
use rimroll::ground::Ground;
use rimroll::law::Coulomb;
use rimroll::motion::{Shaken, shaken};
use rimroll::{Body, ContactLaw, FrictionLaw, IdealLaw, Options, Shaking, State, shake_many};
use std::path::Path;
use std::sync::Arc;

/// The time between two samples, s.
const STEP: f64 = 0.005;

/// The tilts at the end of the record beside the table of starts. The name of a method may end with `:` and a coefficient
/// of friction.
pub fn end_tilts(question: &Question) -> Result<Vec<f64>, String> {
    let record = Path::new(&question.path).with_file_name("record.csv");
    let ground = Arc::new(ground(&record)?);
    let (mass, transverse, axial) = (1000.0, 0.0625 + 16.0 / 12.0, 0.125);
    let body = Body::new(mass, 0.5, 2.0, mass * transverse, mass * axial);
    let body = body.map_err(|error| error.to_string())?;
    let (method, friction) = match question.method.split_once(':') {
        None => (question.method.as_str(), None),
        Some((method, friction)) => {
            let friction: f64 = friction.parse().map_err(|_| "bad friction")?;
            (method, Some(friction))
        }
    };
    let law = match friction {
        None => ContactLaw::from(IdealLaw::NoSlip),
        Some(friction) => FrictionLaw::from(Coulomb::uniform(friction)).into(),
    };
    let options = Options {
        duration: ground.duration(),
        gravity: 9.81,
        rtol: question.tolerance,
        ..Options::default()
    };
    let starts = question.starts.iter().map(|start| State {
        tilt: start.tilt,
        ..State::default()
    });
    let found: Result<Vec<Shaken>, _> = match method {
        "core_shaken" => starts
            .map(|start| {
                let go_on = |_| ControlFlow::Continue(());
                shaken(
                    Some(Arc::clone(&ground)),
                    &body,
                    &start,
                    &law,
                    &options,
                    go_on,
                )
            })
            .collect(),
        "core_shake_many" => {
            let shaking = |start| Shaking {
                body: &body,
                start,
                contact_law: law.clone(),
                ground: Some(&ground),
                scale: 1.0,
                duration: options.duration,
            };
            let rows: Vec<_> = starts.map(shaking).collect();
            shake_many(&rows, &options, |_| ControlFlow::Continue(()))
        }
        other => return Err(format!("knows no method {other}")),
    };
    let found = found.map_err(|error| error.to_string())?;
    Ok(found.iter().map(|shaken| shaken.end_tilt).collect())
}

fn ground(path: &Path) -> Result<Ground, String> {
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string())?;
    let sample = |line: &str| -> Option<[f64; 3]> {
        let mut numbers = line.split(',').map_while(|cell| cell.parse().ok());
        Some([numbers.next()?, numbers.next()?, numbers.next()?])
    };
    let samples: Option<Vec<_>> = text.lines().map(sample).collect();
    let samples = samples.ok_or_else(|| format!("cannot read {}", path.display()))?;
    Ground::sampled(STEP, samples).map_err(|error| error.to_string())
}
