//! The driver of iOverlay, with the interface of bench/driver/driver.h (bench/README.md):
//! `ioverlay_driver ENGINE WORKLOAD OPERATION [--repeat N] [--threads T] [--dump FILE]`,
//! ENGINE one of int, float, float64.

mod engines;
mod workload;

use engines::{Engine, Float, Float64, Int, Task};
use serde_json::json;
use std::time::Instant;
use workload::{Operand, Workload};

struct Arguments {
    peer: String,
    operation: String,
    repeat: usize,
    threads: usize,
    dump: Option<String>,
}

fn status_kib(field: &str) -> u64 {
    std::fs::read_to_string("/proc/self/status")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|line| line.starts_with(field))?.to_string();
            line.split_whitespace().nth(1)?.parse().ok()
        })
        .unwrap_or(0)
}

/// The largest power of two that keeps every coordinate within 30 bits; 1 where all are small integers.
fn grid_scale(workload: &Workload) -> f64 {
    let coordinates = || workload.a.points.iter().chain(&workload.b.points).flatten();
    let largest = coordinates().fold(0.0_f64, |m, v| m.max(v.abs()));
    if coordinates().all(|v| v.fract() == 0.0) && largest < (1 << 29) as f64 {
        return 1.0;
    }
    f64::exp2(29.0 - largest.log2().ceil())
}

fn run_pairs<E: Engine>(pairs: &[E], task: &Task, threads: usize) -> Operand {
    if pairs.len() == 1 {
        let mut result = Operand::default();
        pairs[0].run(task, &mut result);
        return result;
    }
    let mut parts: Vec<Operand> = (0..threads).map(|_| Operand::default()).collect();
    let share = pairs.len().div_ceil(threads);
    std::thread::scope(|scope| {
        for (part, pairs) in parts.iter_mut().zip(pairs.chunks(share)) {
            scope.spawn(move || pairs.iter().for_each(|pair| pair.run(task, part)));
        }
    });
    let mut parts = parts.into_iter();
    let mut result = parts.next().unwrap();
    parts.for_each(|part| result.append(part));
    result
}

fn drive<E: Engine>(workload: Workload, arguments: &Arguments, version: &str) {
    let count = workload.a.pair_ends.len();
    let operation = match arguments.operation.as_str() {
        "intersection" => 0,
        "union" => 1,
        "difference" => 2,
        "symdifference" => 3,
        _ => workload.operation,
    };
    let multithreading = arguments.threads > 1 && count == 1;
    let task = Task::new(operation, workload.fill, grid_scale(&workload), multithreading);
    let pairs: Vec<E> =
        (0..count).map(|i| E::prepare(workload.a.contours(i), workload.b.contours(i), &task)).collect();
    drop(workload);
    let mut result = Operand::default();
    for _ in 0..arguments.repeat {
        drop(std::mem::take(&mut result));
        unsafe { libc::malloc_trim(0) };
        let _ = std::fs::write("/proc/self/clear_refs", "5");
        let input_kib = status_kib("VmRSS:");
        let start = Instant::now();
        result = run_pairs(&pairs, &task, arguments.threads);
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{}",
            json!({"peer": arguments.peer, "version": version, "operation": arguments.operation,
                   "threads": arguments.threads, "seconds": seconds, "peak_kib": status_kib("VmHWM:"),
                   "input_kib": input_kib, "polygons": result.polygon_ends.len(),
                   "contours": result.contour_ends.len(), "vertices": result.points.len(),
                   "area": result.area()})
        );
    }
    if let Some(path) = &arguments.dump {
        workload::write_result(path, &result).expect("cannot write the result");
    }
}

fn usage() -> ! {
    eprintln!("usage: ioverlay_driver int|float|float64 WORKLOAD OPERATION [--repeat N] [--threads T] [--dump FILE]");
    std::process::exit(2);
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if words.len() < 3 || words.len() % 2 == 0 {
        usage();
    }
    let option = |name: &str| {
        words[3..].chunks(2).find(|pair| pair[0] == name).map(|pair| pair[1].clone())
    };
    let number = |name: &str| option(name).and_then(|text| text.parse().ok()).unwrap_or(1).max(1);
    let arguments = Arguments {
        peer: format!("ioverlay-{}", words[0]),
        operation: words[2].clone(),
        repeat: number("--repeat"),
        threads: number("--threads"),
        dump: option("--dump"),
    };
    let workload = workload::read(&words[1]).unwrap_or_else(|error| {
        eprintln!("{error}");
        std::process::exit(1)
    });
    let version = env!("IOVERLAY_VERSION");
    match words[0].as_str() {
        "int" => drive::<Int>(workload, &arguments, version),
        "float" => drive::<Float>(workload, &arguments, version),
        "float64" => drive::<Float64>(workload, &arguments, version),
        _ => usage(),
    }
}
