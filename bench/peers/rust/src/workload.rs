//! Reads workload files and writes results; the format is in bench/workloads/workload_file.h.

use std::fs;
use std::io;

pub type Point = [f64; 2];

/// The arrays of all pairs of one operand; ends count from the beginning of their pair.
#[derive(Default)]
pub struct Operand {
    pub points: Vec<Point>,
    pub contour_ends: Vec<u32>,
    pub polygon_ends: Vec<u32>,
    pub pair_ends: Vec<[u64; 3]>,
}

pub struct Workload {
    pub operation: u32,
    pub fill: u32,
    pub a: Operand,
    pub b: Operand,
}

impl Operand {
    /// The contours of one pair.
    pub fn contours(&self, pair: usize) -> Vec<Vec<Point>> {
        let begin = if pair == 0 { [0; 3] } else { self.pair_ends[pair - 1] };
        let end = self.pair_ends[pair];
        let points = &self.points[begin[0] as usize..end[0] as usize];
        let mut from = 0;
        self.contour_ends[begin[1] as usize..end[1] as usize]
            .iter()
            .map(|&to| {
                let contour = points[from..to as usize].to_vec();
                from = to as usize;
                contour
            })
            .collect()
    }

    pub fn close_pair(&mut self) {
        self.pair_ends.push([
            self.points.len() as u64,
            self.contour_ends.len() as u64,
            self.polygon_ends.len() as u64,
        ]);
    }

    pub fn append(&mut self, part: Operand) {
        let base = self.pair_ends.last().copied().unwrap_or_default();
        self.points.extend(part.points);
        self.contour_ends.extend(part.contour_ends);
        self.polygon_ends.extend(part.polygon_ends);
        self.pair_ends
            .extend(part.pair_ends.iter().map(|e| [base[0] + e[0], base[1] + e[1], base[2] + e[2]]));
    }

    /// Outer contours run one way and holes the other, so signed areas add up.
    pub fn area(&self) -> f64 {
        let mut total = 0.0;
        for pair in 0..self.pair_ends.len() {
            let mut sum = 0.0;
            for contour in self.contours(pair) {
                let o = contour[0];
                for w in contour.windows(2) {
                    sum += (w[0][0] - o[0]) * (w[1][1] - o[1]) - (w[1][0] - o[0]) * (w[0][1] - o[1]);
                }
            }
            total += f64::abs(sum) / 2.0;
        }
        total
    }
}

struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let (head, rest) = self.0.split_at(N);
        self.0 = rest;
        head.try_into().unwrap()
    }
    fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.take())
    }
    fn u64(&mut self) -> u64 {
        u64::from_le_bytes(self.take())
    }
    fn f64(&mut self) -> f64 {
        f64::from_le_bytes(self.take())
    }

    fn operand(&mut self, pairs: usize) -> Operand {
        let (points, contours, polygons) = (self.u64(), self.u64(), self.u64());
        let operand = Operand {
            points: (0..points).map(|_| [self.f64(), self.f64()]).collect(),
            contour_ends: (0..contours).map(|_| self.u32()).collect(),
            polygon_ends: (0..polygons).map(|_| self.u32()).collect(),
            pair_ends: Vec::new(),
        };
        if (contours + polygons) % 2 == 1 {
            self.u32();
        }
        let pair_ends = (0..pairs).map(|_| [self.u64(), self.u64(), self.u64()]).collect();
        Operand { pair_ends, ..operand }
    }
}

pub fn read(path: &str) -> io::Result<Workload> {
    let bytes = fs::read(path)?;
    let mut reader = Reader(&bytes);
    if &reader.take::<8>() != b"OBLWORK1" {
        return Err(io::Error::new(io::ErrorKind::InvalidData, format!("{path}: not a workload file")));
    }
    let operation = reader.u32();
    let fill = reader.u32();
    let _kinds_and_flags = [reader.u32(), reader.u32(), reader.u32()];
    let pairs = reader.u32() as usize;
    let a = reader.operand(pairs);
    let b = reader.operand(pairs);
    Ok(Workload { operation, fill, a, b })
}

pub fn write_result(path: &str, result: &Operand) -> io::Result<()> {
    let mut bytes = b"OBLWORK1".to_vec();
    for value in [0, 0, 0, 0, 0, result.pair_ends.len() as u32] {
        bytes.extend(value.to_le_bytes());
    }
    let empty = Operand { pair_ends: vec![[0; 3]; result.pair_ends.len()], ..Operand::default() };
    for operand in [result, &empty] {
        for count in [operand.points.len(), operand.contour_ends.len(), operand.polygon_ends.len()] {
            bytes.extend((count as u64).to_le_bytes());
        }
        bytes.extend(operand.points.iter().flatten().flat_map(|v| v.to_le_bytes()));
        bytes.extend(operand.contour_ends.iter().flat_map(|v| v.to_le_bytes()));
        bytes.extend(operand.polygon_ends.iter().flat_map(|v| v.to_le_bytes()));
        if (operand.contour_ends.len() + operand.polygon_ends.len()) % 2 == 1 {
            bytes.extend([0; 4]);
        }
        bytes.extend(operand.pair_ends.iter().flatten().flat_map(|v| v.to_le_bytes()));
    }
    fs::write(path, bytes)
}
