//! The test that the fuzzer runs: bytes encode boxes, and every kernel must find the pairs of the oracle.
//!
//! Bytes encode two lists. Each kernel gets the first, the second and the first again, because the state that it keeps must not affect later
//! calls. A few bytes encode many boxes, most of them on a lattice, where about half of the neighbours touch. After the end of the bytes,
//! zeros are read, so every input is valid.

use std::array::from_fn;
use std::num::NonZero;

use crate::numbers::Number;
use arbitrary::{Result, Unstructured};
use unisize::{Aabb, BruteForce, GridSweep, PairFinder, RankSweep};

use crate::numbers::{alphabet, stepped};

/// The largest number of boxes in a list.
const MOST: usize = 300;

/// The side of boxes on the lattice, in quarters of the pitch.
const SIDES: [i32; 8] = [4, 4, 4, 4, 0, 1, 8, 40];

/// The pitch of the lattice.
const PITCHES: [f64; 8] = [1.0, 1.0, 0.1, 1e-45, 1e-38, 1e7, 1e30, 1e37];

/// The origin of the lattice.
const ORIGINS: [f64; 4] = [0.0, -2.0, 1e7, -1e30];

/// Checks all kernels on the boxes that the bytes encode.
pub(crate) fn check(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    // Reading never fails, although it returns a `Result`.
    let _ = match bytes.int_in_range(0..=7).unwrap_or(0) {
        0 => check_in::<f32, 1>(&mut bytes),
        1 => check_in::<f32, 2>(&mut bytes),
        2 => check_in::<f32, 3>(&mut bytes),
        3 => check_in::<f32, 4>(&mut bytes),
        4 => check_in::<f64, 1>(&mut bytes),
        5 => check_in::<f64, 2>(&mut bytes),
        6 => check_in::<f64, 3>(&mut bytes),
        _ => check_in::<f64, 4>(&mut bytes),
    };
}

fn check_in<R: Number, const D: usize>(bytes: &mut Unstructured) -> Result<()> {
    let slabs = NonZero::new(bytes.int_in_range(2..=9)?).unwrap_or(NonZero::<usize>::MIN);
    let lists = [read_list::<R, D>(bytes)?, read_list(bytes)?];
    let mut grid_sweep = GridSweep::<R, D>::default();
    let mut in_slabs = GridSweep::<R, D>::with_slabs(slabs);
    let mut others = others::<R, D>();
    let mut pairs = [const { Vec::new() }; 4];
    for boxes in [&lists[0], &lists[1], &lists[0]] {
        let [expected, swept, in_order, found] = &mut pairs;
        let outcome = BruteForce.find_pairs(boxes, expected);
        expected.sort_unstable();
        assert_eq!(grid_sweep.find_pairs(boxes, swept), outcome, "{boxes:?}");
        assert_eq!(in_slabs.find_pairs(boxes, in_order), outcome, "{boxes:?}");
        assert!(in_order == swept, "the order in {slabs} slabs: {boxes:?}");
        swept.sort_unstable();
        assert!(swept == expected, "GridSweep: {boxes:?}");
        for (name, kernel) in &mut others {
            let answer = kernel.find_pairs(boxes, found);
            assert_eq!(answer, outcome, "{name}: {boxes:?}");
            found.sort_unstable();
            assert!(found == expected, "{name}: {boxes:?}");
        }
    }
    Ok(())
}

/// Kernels and their names.
type Kernels<R, const D: usize> = Vec<(&'static str, Box<dyn PairFinder<R, D>>)>;

/// The kernels whose pairs are compared, but not their order.
fn others<R: Number, const D: usize>() -> Kernels<R, D> {
    vec![("RankSweep", Box::new(RankSweep::default()))]
}

/// The boxes of one list, and the parameters of the next ones.
struct List<R, const D: usize> {
    boxes: Vec<Aabb<R, D>>,
    alphabet: Vec<R>,
    pitch: f64,
    origin: f64,
    /// Whether invalid boxes are kept.
    is_raw: bool,
}

fn read_list<R: Number, const D: usize>(bytes: &mut Unstructured) -> Result<Vec<Aabb<R, D>>> {
    let mut list = List {
        boxes: Vec::new(),
        alphabet: alphabet(),
        pitch: *bytes.choose(&PITCHES)?,
        origin: *bytes.choose(&ORIGINS)?,
        is_raw: bytes.ratio(1_u8, 16_u8)?,
    };
    list.alphabet.push(R::from_f64(f64::NAN));
    let entries = bytes.int_in_range(0..=u8::MAX)?;
    for _ in 0..entries {
        if bytes.is_empty() || list.boxes.len() >= MOST {
            break;
        }
        list.read_entry(bytes)?;
    }
    Ok(list.boxes)
}

impl<R: Number, const D: usize> List<R, D> {
    /// Reads one box, or a row of boxes.
    fn read_entry(&mut self, bytes: &mut Unstructured) -> Result<()> {
        match bytes.int_in_range(0..=7)? {
            0..=2 => {
                let corner = read_corner(bytes)?;
                self.push_on_lattice(corner);
            }
            3 => {
                let mut corner = read_corner::<D>(bytes)?;
                let mut steps = [0; D];
                for step in &mut steps {
                    *step = bytes.int_in_range(-5..=5)?;
                }
                for _ in 0..bytes.int_in_range(1..=100)? {
                    self.push_on_lattice(corner);
                    for k in 0..D {
                        corner[k].0 += steps[k];
                    }
                }
            }
            4 | 5 => {
                let mut ends = [(R::from_f64(0.0), R::from_f64(0.0)); D];
                for end in &mut ends {
                    *end = (
                        *bytes.choose(&self.alphabet)?,
                        *bytes.choose(&self.alphabet)?,
                    );
                }
                self.push(ends);
            }
            6 => {
                let mut ends = [(R::from_f64(0.0), R::from_f64(0.0)); D];
                for end in &mut ends {
                    *end = (read_bits(bytes)?, read_bits(bytes)?);
                }
                self.push(ends);
            }
            _ => {
                let index = bytes.choose_index(self.boxes.len().max(1))?;
                let axis = bytes.choose_index(D)?;
                let (low, high) = (bytes.int_in_range(-2..=2)?, bytes.int_in_range(-2..=2)?);
                if let Some(Aabb { mins, maxs }) = self.boxes.get(index).copied() {
                    let mut ends = from_fn(|k| (mins[k], maxs[k]));
                    ends[axis] = (stepped(mins[axis], low), stepped(maxs[axis], high));
                    self.push(ends);
                }
            }
        }
        Ok(())
    }

    /// Adds a box with this corner and these sides, in quarters of the pitch.
    fn push_on_lattice(&mut self, corner: [(i32, i32); D]) {
        let at = |quarters: i32| R::from_f64(self.origin + f64::from(quarters) * 0.25 * self.pitch);
        self.push(corner.map(|(low, side)| (at(low), at(low + side))));
    }

    fn push(&mut self, ends: [(R, R); D]) {
        let ends = ends.map(|(low, high)| match low <= high {
            is_valid if is_valid || self.is_raw => (low, high),
            _ if high <= low => (high, low),
            _ => (R::from_f64(0.0), R::from_f64(1.0)),
        });
        let aabb = Aabb::new(ends.map(|end| end.0), ends.map(|end| end.1));
        self.boxes.push(aabb);
    }
}

/// Reads the corner and the sides of a box on the lattice, in quarters of the pitch.
fn read_corner<const D: usize>(bytes: &mut Unstructured) -> Result<[(i32, i32); D]> {
    let mut corner = [(0, 0); D];
    for (low, side) in &mut corner {
        let byte = bytes.arbitrary::<u8>()?;
        *low = 2 * i32::from(byte / 8);
        *side = SIDES[usize::from(byte % 8)];
    }
    Ok(corner)
}

/// Reads any number, including NaN.
fn read_bits<R: Number>(bytes: &mut Unstructured) -> Result<R> {
    Ok(R::from_f64(if size_of::<R>() == 4 {
        f64::from(f32::from_bits(bytes.arbitrary()?))
    } else {
        f64::from_bits(bytes.arbitrary()?)
    }))
}
