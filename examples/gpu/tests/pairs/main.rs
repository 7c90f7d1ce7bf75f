//! The pairs that a GPU finds against brute force, and against `GridSweep` where boxes are many.

#[path = "../../../../tests/oracle/boxes.rs"]
mod boxes;
#[path = "../../../../tests/oracle/inputs.rs"]
mod inputs;
#[path = "../../examples/frames/lbvh.rs"]
mod lbvh;
#[path = "../../../../tests/oracle/limits.rs"]
mod limits;
#[path = "../../../../tests/oracle/numbers.rs"]
mod numbers;
#[path = "../../../../tests/oracle/random.rs"]
mod random;

use std::cell::OnceCell;

use boxes::uniform;
use inputs::Input;
use lbvh::{Lbvh, sorted};
use numbers::{alphabet, stepped};
use random::Random;
use unisize::{Aabb, BruteForce, GridSweep, InvalidInputReason, PairFinder};
use unisize_gpu::{Capacity, Gpu, GpuError, GpuSweep, read, upload};
use unisize_scenes as arrangements; // By this name the oracle's inputs ask for them.
use unisize_scenes::HardBoxes;
use wgpu::ComputePipeline;

type Boxes<const D: usize> = Vec<Aabb<f32, D>>;

fn expected<const D: usize>(
    mut finder: impl PairFinder<f32, D>,
    boxes: &[Aabb<f32, D>],
) -> Vec<[u32; 2]> {
    let mut pairs = Vec::new();
    let outcome = finder.find_pairs(boxes, &mut pairs);
    outcome.expect("the boxes are valid");
    pairs.sort_unstable();
    pairs
}

/// A sweep with its device, and the tree that it is measured against.
struct Tested<const D: usize> {
    gpu: Gpu,
    sweep: GpuSweep<D>,
    lbvh: OnceCell<[ComputePipeline; 8]>,
}

impl<const D: usize> Tested<D> {
    fn new(boxes: u32, pairs: u32) -> Self {
        let gpu = Gpu::new(Some(wgpu::Limits::default()));
        let gpu = gpu.expect("an adapter (Debian: apt-get install mesa-vulkan-drivers)");
        let sweep = GpuSweep::new(&gpu.device, Capacity { boxes, pairs });
        let sweep = sweep.expect("there is memory for so little");
        let lbvh = OnceCell::new();
        Self { gpu, sweep, lbvh }
    }

    /// The sorted pairs.
    fn pairs(&mut self, boxes: &[Aabb<f32, D>]) -> Vec<[u32; 2]> {
        self.try_pairs(boxes).expect("the boxes are valid")
    }

    fn try_pairs(&mut self, boxes: &[Aabb<f32, D>]) -> Result<Vec<[u32; 2]>, GpuError> {
        let Gpu { device, queue, .. } = &self.gpu;
        let mut pairs = vec![[7, 7]];
        let found = self.sweep.find_pairs(device, queue, boxes, &mut pairs);
        assert!(found.is_ok() || pairs.is_empty(), "pairs after an error");
        pairs.sort_unstable();
        found.map(|()| pairs)
    }

    /// The seven words of a frame of boxes in a buffer, and the pairs, sorted.
    fn record(&mut self, boxes: &[Aabb<f32, D>]) -> (Vec<u32>, Vec<[u32; 2]>) {
        let Gpu { device, queue, .. } = &self.gpu;
        let sides = boxes.iter().flat_map(|b| [b.mins, b.maxs]).flatten();
        let buffer = upload(device, &sides.collect::<Vec<f32>>());
        let mut encoder = device.create_command_encoder(&Default::default());
        let recorded = self.sweep.record(&mut encoder, &buffer, boxes.len() as u32);
        recorded.expect("so many boxes fit");
        queue.submit([encoder.finish()]);
        let read = |from, words| read(device, queue, from, words).expect("the device works");
        let words = read(self.sweep.count(), 7);
        let pairs = sorted(&read(self.sweep.pairs(), 2 * u64::from(words[3])));
        (words, pairs)
    }

    /// The sorted pairs by the tree.
    fn by_lbvh(&self, boxes: &[Aabb<f32, D>], most: u32) -> Vec<[u32; 2]> {
        let Gpu { device, queue, .. } = &self.gpu;
        let sides = boxes.iter().flat_map(|b| [b.mins, b.maxs]).flatten();
        let buffer = upload(device, &sides.collect::<Vec<f32>>());
        let pipelines = self.lbvh.get_or_init(|| Lbvh::pipelines::<D>(device));
        let lbvh = Lbvh::new::<D>(device, pipelines, &buffer, boxes.len() as u32, most);
        let mut encoder = device.create_command_encoder(&Default::default());
        lbvh.record(&mut encoder, None);
        queue.submit([encoder.finish()]);
        let read = |from, words| read(device, queue, from, words).expect("the device works");
        let found = read(&lbvh.state, 1)[0];
        sorted(&read(&lbvh.pairs, 2 * u64::from(found.min(most))))
    }
}

/// Two tests of each function: in two dimensions and in three.
macro_rules! in_2d_and_3d {
    ($($name:ident)*) => {
        mod in_2d {
            $(#[test] fn $name() { super::$name::<2>(); })*
        }
        mod in_3d {
            $(#[test] fn $name() { super::$name::<3>(); })*
        }
    };
}

in_2d_and_3d! {
    families
    many_boxes
    random_numbers
    invalid_boxes
    more_pairs_than_fit
    kept_grids
    no_boxes_and_too_many
}

fn families<const D: usize>() {
    let mut tested = Tested::<D>::new(1, 1);
    for Input { name, mut boxes } in inputs::all() {
        // By a sweep that knows earlier inputs; then in another order, on the grids that it keeps.
        for keeps_grids in [false, true] {
            tested.sweep.keep_grids(keeps_grids);
            let pairs = expected(BruteForce, &boxes);
            assert!(tested.pairs(&boxes) == pairs, "{name}, {keeps_grids}");
            if !boxes.is_empty() {
                let most = pairs.len() as u32 + 1;
                assert!(tested.by_lbvh(&boxes, most) == pairs, "{name}, LBVH");
            }
            boxes.reverse();
        }
    }
}

fn many_boxes<const D: usize>() {
    let mut tested = Tested::<D>::new(1, 1);
    let mut inputs: Vec<(&str, Boxes<D>)> = Vec::new();
    let many = [
        HardBoxes::Uniform,
        HardBoxes::OneToFour,
        HardBoxes::FewLarge,
    ];
    for kind in HardBoxes::ALL {
        let count = if many.contains(&kind) {
            200_000
        } else {
            10_000
        };
        let count = if kind.are_too_many(count) {
            2_000
        } else {
            count
        };
        let boxes = kind.boxes(count, 7).into_iter();
        let boxes = boxes.map(|[mins, maxs]| Aabb::new(mins, maxs));
        inputs.push((kind.name(), boxes.collect()));
    }
    let mut boxes = uniform::<f32, D>(5, 200_000, 0.2);
    let half = 0.5 * 1e6_f64.powf(1.0 / D as f64) as f32;
    boxes.extend((0..20).map(|i| {
        let mins = [half * (i as f32 / 20.0 - 1.0); D];
        Aabb::new(mins, mins.map(|x| x + half))
    }));
    inputs.push(("huge boxes among small ones", boxes));
    for (name, boxes) in inputs {
        let pairs = expected(GridSweep::default(), &boxes);
        assert!(tested.pairs(&boxes) == pairs, "{name}, {}", boxes.len());
        let most = pairs.len() as u32 + 1;
        let by = tested.by_lbvh(&boxes, most);
        if by != pairs {
            eprintln!("LBVH {name}, {} {} {}", boxes.len(), by.len(), pairs.len());
        }
    }
}

/// Boundary numbers, with zeros of both signs, subnormals, infinities and close neighbours; then numbers of every magnitude.
fn random_numbers<const D: usize>() {
    let mut tested = Tested::<D>::new(500, 200_000);
    let numbers = alphabet::<f32>();
    let mut random = Random::new(31);
    let mut number = |round: usize, before: f32| match (round % 2, random.below(4)) {
        (0, _) => random.pick(&numbers),
        (_, 0) => stepped(before, 1),
        (_, 1) => before,
        // Of a NaN and another number, `max` returns the number.
        _ => f32::from_bits(random.below(1 << 32) as u32).max(f32::NEG_INFINITY),
    };
    for round in 0..80 {
        let sides = |_| {
            std::array::from_fn(|_| {
                let a = number(round, 0.0);
                let b = number(round, a);
                if a <= b { (a, b) } else { (b, a) }
            })
        };
        let boxes: Boxes<D> = (0..10 + 5 * round).map(sides).map(boxes::between).collect();
        let pairs = expected(BruteForce, &boxes);
        assert!(tested.pairs(&boxes) == pairs, "round {round}");
    }
}

fn invalid_boxes<const D: usize>() {
    let valid = uniform::<f32, D>(3, 1000, 0.8);
    let mut tested = Tested::<D>::new(1000, 10_000);
    let above_zero = 0.0_f32.next_up();
    let infinity = f32::INFINITY;
    for (index, axis) in (0..3 * D).map(|i| (499 * (i / D), i % D)) {
        let low = valid[index].mins[axis];
        let is_inverted = InvalidInputReason::Inverted { axis };
        let is_no_number = InvalidInputReason::NotANumber { axis };
        let cases = [
            (low, low.next_down(), is_inverted),
            (infinity, -infinity, is_inverted),
            (above_zero, -0.0, is_inverted),
            (f32::NAN, low, is_no_number),
            (low, -f32::NAN, is_no_number),
            (-infinity, f32::from_bits(0x7f80_0001), is_no_number),
        ];
        for (mins, maxs, reason) in cases {
            let mut boxes = valid.clone();
            boxes[999].maxs[0] = f32::NAN; // Only the first one counts.
            (boxes[index].mins[axis], boxes[index].maxs[axis]) = (mins, maxs);
            match tested.try_pairs(&boxes) {
                Err(GpuError::Invalid(it)) => assert_eq!((it.index, it.reason), (index, reason)),
                other => panic!("{mins} to {maxs} on axis {axis}: {other:?}"),
            }
        }
    }
    assert!(tested.pairs(&valid) == expected(BruteForce, &valid));
}

fn more_pairs_than_fit<const D: usize>() {
    let mut tested = Tested::<D>::new(3000, 1000);
    // All in two places: rows so long that groups share them, and more pairs than a group keeps.
    let stacks = boxes::coincident(1500, 2);
    for boxes in [uniform(9, 3000, 3.0), stacks.clone()] {
        let all = expected(BruteForce, &boxes);
        let (words, mut pairs) = tested.record(&boxes);
        assert_eq!(words[..4], [16, 1, 1, 1000]);
        assert_eq!(words[4..], [all.len() as u32, 0, u32::MAX]);
        pairs.dedup();
        assert_eq!(pairs.len(), 1000, "a pair is there twice");
        assert!(pairs.iter().all(|pair| all.binary_search(pair).is_ok()));
    }
    assert_eq!(tested.by_lbvh(&stacks, 1000).len(), 1000);
    // `find_pairs` takes more memory instead.
    assert_eq!(tested.sweep.capacity().pairs, 1000);
    assert!(tested.pairs(&stacks) == expected(BruteForce, &stacks));
    assert_eq!(tested.sweep.capacity().pairs, 1500 * 1499);
}

/// Boxes that leave the grids of the first frame, and grow out of them.
fn kept_grids<const D: usize>() {
    let mut tested = Tested::<D>::new(2000, 100_000);
    let boxes = uniform::<f32, D>(4, 2000, 0.5);
    tested.sweep.keep_grids(true);
    for (scale, grown) in [(1.0, 0.0), (3.0, 0.5), (0.1, 0.0), (1e30, 1e28), (1.0, 2.0)] {
        let moved = boxes.iter().enumerate().map(|(i, b)| {
            let more = if i % 3 == 0 { grown } else { 0.0 };
            let maxs = b.maxs.map(|x| x * scale + more);
            Aabb::new(b.mins.map(|x| x * scale), maxs)
        });
        let moved: Boxes<D> = moved.collect();
        let pairs = expected(BruteForce, &moved);
        assert!(tested.pairs(&moved) == pairs, "{scale}, {grown}");
    }
}

fn no_boxes_and_too_many<const D: usize>() {
    let mut tested = Tested::<D>::new(0, 0);
    assert!(tested.pairs(&[]).is_empty());
    let one = uniform(1, 1, 0.5);
    assert_eq!(tested.record(&one).0, [0, 0, 1, 0, 0, 0, u32::MAX]);
    assert!(tested.pairs(&one).is_empty());
    let device = &tested.gpu.device;
    let mut encoder = device.create_command_encoder(&Default::default());
    let buffer = tested.sweep.pairs().clone();
    let refused = tested.sweep.record(&mut encoder, &buffer, 2);
    assert!(
        refused.is_err_and(|it| it.to_string() == "2 boxes are more than 1, which is the limit")
    );
    for (boxes, pairs) in [((1 << 23) + 1, 1), (u32::MAX, 1), (1, u32::MAX)] {
        let refused = GpuSweep::<D>::new(device, Capacity { boxes, pairs });
        assert!(matches!(refused, Err(GpuError::TooMany { .. })));
    }
}
