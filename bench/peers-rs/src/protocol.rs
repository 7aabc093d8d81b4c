//! What a contestant is asked on a line of standard input, and what it answers on a line of standard
//! output; see `bench/contest/worker.py`.

use std::fs;
use std::io::{self, BufRead, Write};

/// How the can is let go; yaw and spin are zero (rad, rad/s).
#[derive(Clone, Copy)]
pub struct Start {
    pub tilt: f64,
    pub tilt_rate: f64,
    pub yaw_rate: f64,
    pub spin_rate: f64,
}

/// The law under which the rim moves on the table.
#[derive(Clone, Copy, PartialEq)]
pub enum Law {
    NoSlip,
    Frictionless,
}

/// One question.
pub struct Question {
    pub task: String,
    pub method: String,
    pub coordinates: String,
    pub law: Law,
    pub tolerance: f64,
    /// How often all starts are gone through.
    pub repeats: usize,
    pub starts: Vec<Start>,
    /// The table of the starts.
    #[allow(dead_code, reason = "not each program needs it")]
    pub path: String,
}

/// How repeated starts reach a solver.
#[derive(Clone, Copy, PartialEq)]
#[allow(dead_code, reason = "each program wants one of them")]
pub enum Repeated {
    /// Once and again.
    InTurn,
    /// As one long list, by a solver made for many.
    AtOnce,
}

/// Answers every line with the processor's seconds a start and what `answer` makes of the starts: a
/// turn each, or of a motion its yaw and tilt at the end.
pub fn serve(repeated: Repeated, answer: impl Fn(&Question) -> Result<Vec<f64>, String>) {
    for line in io::stdin().lock().lines() {
        let said = match read(&line.expect("standard input")) {
            Ok(question) => timed(question, repeated, &answer),
            Err(complaint) => Err(complaint),
        };
        match said {
            Ok((seconds, turns)) => {
                let turns: Vec<_> = turns.iter().map(|turn| format!("{turn:e}")).collect();
                println!("{seconds:e} {}", turns.join(" "));
            }
            Err(complaint) => println!("error {complaint}"),
        }
        io::stdout().flush().expect("standard output");
    }
}

fn timed(
    mut question: Question,
    repeated: Repeated,
    answer: &impl Fn(&Question) -> Result<Vec<f64>, String>,
) -> Result<(f64, Vec<f64>), String> {
    let (count, mut again) = (question.starts.len(), question.repeats);
    if repeated == Repeated::AtOnce && question.task == "turn" {
        question.starts = question.starts.repeat(again);
        again = 1;
    }
    let begun = processor_seconds();
    let mut found = answer(&question)?;
    for _ in 1..again {
        found = answer(&question)?;
    }
    let taken = processor_seconds() - begun;
    if question.task == "turn" {
        found.truncate(count);
    }
    Ok((taken / (question.repeats * count) as f64, found))
}

fn read(line: &str) -> Result<Question, String> {
    let words: Vec<_> = line.split_whitespace().collect();
    let [task, method, coordinates, law, tolerance, repeats, starts] = words[..] else {
        return Err(format!("cannot read '{line}'"));
    };
    Ok(Question {
        task: task.into(),
        method: method.into(),
        coordinates: coordinates.into(),
        law: match law {
            "no_slip" => Law::NoSlip,
            "frictionless" => Law::Frictionless,
            _ => return Err(format!("knows no law {law}")),
        },
        tolerance: tolerance.parse().map_err(|_| "bad tolerance")?,
        repeats: repeats.parse().map_err(|_| "bad repeats")?,
        starts: read_starts(starts)?,
        path: starts.into(),
    })
}

/// The first four columns of a table of starts.
fn read_starts(path: &str) -> Result<Vec<Start>, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|row| {
        let mut numbers = row.split(',').map_while(|cell| cell.parse().ok());
        let mut next = || numbers.next().ok_or(format!("{path}: cannot read '{row}'"));
        Ok(Start {
            tilt: next()?,
            tilt_rate: next()?,
            yaw_rate: next()?,
            spin_rate: next()?,
        })
    })
    .collect()
}

/// Seconds that this process has had of the processor.
pub fn processor_seconds() -> f64 {
    let mut time = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: the call writes the struct that it is given.
    unsafe { libc::clock_gettime(libc::CLOCK_PROCESS_CPUTIME_ID, &mut time) };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}
