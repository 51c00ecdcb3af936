//! iOverlay's integer and float interfaces behind one trait: an engine holds one prepared pair's
//! operands in iOverlay's own types and gives the result as flat arrays.

use crate::workload::{Operand, Point};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::Overlay;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::core::solver::{MultithreadOptions, Precision, Solver, Strategy};
use i_overlay::float::overlay::FloatOverlay;
use i_overlay::i_float::int::point::IntPoint;

#[derive(Clone, Copy)]
pub struct Task {
    pub rule: OverlayRule,
    pub fill: FillRule,
    pub solver: Solver,
    /// Integer grid units in one coordinate unit.
    pub scale: f64,
}

impl Task {
    pub fn new(operation: u32, fill: u32, scale: f64, multithreading: bool) -> Self {
        Task {
            rule: match operation {
                0 => OverlayRule::Intersect,
                1 => OverlayRule::Union,
                2 => OverlayRule::Difference,
                _ => OverlayRule::Xor,
            },
            fill: if fill == 2 { FillRule::EvenOdd } else { FillRule::NonZero },
            solver: Solver {
                strategy: Strategy::Auto,
                precision: Precision::HIGH,
                multithreading: multithreading.then(MultithreadOptions::default),
            },
            scale,
        }
    }
}

/// Appends shapes as flat arrays of one pair.
fn extract<P: Copy>(shapes: &[Vec<Vec<P>>], to_point: impl Fn(P) -> Point, result: &mut Operand) {
    let (first_point, first_contour) = (result.points.len(), result.contour_ends.len());
    for shape in shapes {
        for contour in shape {
            result.points.extend(contour.iter().map(|&p| to_point(p)));
            result.contour_ends.push((result.points.len() - first_point) as u32);
        }
        result.polygon_ends.push((result.contour_ends.len() - first_contour) as u32);
    }
    result.close_pair();
}

pub trait Engine: Sync {
    fn prepare(a: Vec<Vec<Point>>, b: Vec<Vec<Point>>, task: &Task) -> Self;
    fn run(&self, task: &Task, result: &mut Operand);
}

/// A grid of 32-bit integers. Conversion to the grid is outside the clock.
pub struct Int {
    a: Vec<Vec<IntPoint<i32>>>,
    b: Vec<Vec<IntPoint<i32>>>,
}

impl Engine for Int {
    fn prepare(a: Vec<Vec<Point>>, b: Vec<Vec<Point>>, task: &Task) -> Self {
        let convert = |contours: Vec<Vec<Point>>| {
            let on_grid = |v: f64| (v * task.scale).round() as i32;
            contours
                .iter()
                .map(|contour| contour.iter().map(|p| IntPoint::new(on_grid(p[0]), on_grid(p[1]))).collect())
                .collect()
        };
        Int { a: convert(a), b: convert(b) }
    }

    fn run(&self, task: &Task, result: &mut Operand) {
        let mut overlay = Overlay::<i32>::from_subj_and_clip_custom(&self.a, &self.b, Default::default(), task.solver);
        let shapes = overlay.overlay(task.rule, task.fill);
        extract(&shapes, |p| [f64::from(p.x) / task.scale, f64::from(p.y) / task.scale], result);
    }
}

/// Doubles, on an inner grid of 32-bit integers (iOverlay's default).
pub struct Float {
    a: Vec<Vec<Point>>,
    b: Vec<Vec<Point>>,
}

/// Doubles, on an inner grid of 64-bit integers.
pub struct Float64(Float);

impl Engine for Float {
    fn prepare(a: Vec<Vec<Point>>, b: Vec<Vec<Point>>, _: &Task) -> Self {
        Float { a, b }
    }

    fn run(&self, task: &Task, result: &mut Operand) {
        let mut overlay =
            FloatOverlay::<Point, i32>::from_subj_and_clip_custom(&self.a, &self.b, Default::default(), task.solver);
        extract(&overlay.overlay(task.rule, task.fill), |p| p, result);
    }
}

impl Engine for Float64 {
    fn prepare(a: Vec<Vec<Point>>, b: Vec<Vec<Point>>, task: &Task) -> Self {
        Float64(Float::prepare(a, b, task))
    }

    fn run(&self, task: &Task, result: &mut Operand) {
        let mut overlay = FloatOverlay::<Point, i64>::from_subj_and_clip_custom(
            &self.0.a,
            &self.0.b,
            Default::default(),
            task.solver,
        );
        extract(&overlay.overlay(task.rule, task.fill), |p| p, result);
    }
}
