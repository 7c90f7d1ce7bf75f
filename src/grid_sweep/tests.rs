//! What the suite over all kernels cannot see: that settings are heeded, and that guesses may be wrong.

use super::*;
use crate::BruteForce;
use std::num::NonZero;

/// Unit squares in rows of this length.
fn rows(count: usize, length: usize) -> Vec<Aabb<f32, 2>> {
    let corner = |i: usize| [(i % length) as f32 * 0.9, (i / length) as f32 * 0.9];
    let unit = |mins: [f32; 2]| Aabb::new(mins, mins.map(|x| x + 1.0));
    (0..count).map(|i| unit(corner(i))).collect()
}

fn slabs<R, const D: usize>(kernel: &GridSweep<R, D>) -> usize {
    kernel.classes[0].slab_count
}

#[test]
fn work_is_cut_into_as_many_slabs_as_asked_for() {
    let boxes = rows(4000, 10);
    let mut expected = Vec::new();
    for count in 1..5 {
        let mut kernel = GridSweep::with_slabs(NonZero::new(count).unwrap());
        let mut pairs = Vec::new();
        kernel.find_pairs(&boxes, &mut pairs).unwrap();
        assert_eq!(slabs(&kernel), count);
        if count == 1 {
            expected = pairs;
        } else {
            assert!(pairs == expected, "another answer, or another order");
        }
    }
    assert!(expected.len() > 10_000);
}

#[cfg(feature = "parallel")]
#[test]
fn each_thread_has_a_slab_if_there_is_enough_to_do() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build();
    let slabs_of = |count| {
        let mut kernel = GridSweep::default();
        kernel
            .find_pairs(&rows(count, 10), &mut Vec::new())
            .unwrap();
        slabs(&kernel)
    };
    let counts = [THREADS_FROM - 1, THREADS_FROM];
    let slabs = pool.unwrap().install(|| counts.map(slabs_of));
    assert_eq!(slabs, [1, 3]);
}

#[test]
fn times_are_taken_on_demand() {
    let boxes = rows(4000, 10);
    let mut pairs = Vec::new();
    let mut kernel = GridSweep::default();
    kernel.find_pairs(&boxes, &mut pairs).unwrap();
    assert_eq!(kernel.phase_times(), PhaseTimes::default());
    let mut kernel = kernel.timed();
    for _ in 0..2 {
        kernel.find_pairs(&boxes, &mut pairs).unwrap();
        let times = kernel.phase_times();
        let phases = [times.read, times.sort, times.sweep];
        assert!(phases.iter().all(|time| !time.is_zero()));
    }
}

/// Every box that is looked at to choose the grid is flat, and most are too large for any grid so chosen.
#[test]
fn a_sample_that_misleads_costs_time_and_nothing_else() {
    for spread in [0.0, 1e-3, 50.0] {
        let mut boxes: Vec<_> = (0..2000)
            .map(|i| Aabb::new([i as f32, -1e9], [i as f32 + 1.5, 1e9]))
            .collect();
        for i in grid::scattered(boxes.len()) {
            let corner = [i as f32, spread * (i % 50) as f32];
            boxes[i] = Aabb::new(corner, corner);
        }
        let [mut found, mut expected] = [Vec::new(), Vec::new()];
        GridSweep::default().find_pairs(&boxes, &mut found).unwrap();
        BruteForce.find_pairs(&boxes, &mut expected).unwrap();
        found.sort_unstable();
        assert!(found == expected);
    }
}

#[test]
fn one_axis_is_cut_where_boxes_lie_along_a_curve() {
    let cube = |mins: [f32; 3]| Aabb::new(mins, mins.map(|x| x + 1.0));
    let along = |direction: [f32; 3]| -> Vec<_> {
        let mins = |i: usize| direction.map(|step| step * 0.9 * i as f32);
        (0..3000).map(|i| cube(mins(i))).collect()
    };
    // In groups, of which many share a strip of either axis, and all overlap along the first one.
    let grouped: Vec<_> = (0..3000_u64)
        .map(|i| {
            let hash = i.wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let place =
                |group: u64, bit: u32| (group % 7 * 600) as f32 + (hash >> bit) as u8 as f32 / 12.0;
            cube([0.0, place(i, 20), place(i / 7, 40)])
        })
        .collect();
    // The first of the two axes goes over the same places again and again, and the second does not.
    let mut zigzag = along([0.0, 0.0, 1.0]);
    for (i, aabb) in zigzag.iter_mut().enumerate() {
        let y = (i % 100) as f32 * 30.0;
        *aabb = cube([0.0, y, aabb.mins[2]]);
    }
    for (boxes, are_cut) in [
        (along([1.0, 1.0, 1.0]), [true, false]),
        (along([0.0, 1.0, -1.0]), [true, false]),
        (zigzag, [false, true]),
        (grouped, [true, true]),
    ] {
        let mut kernel = GridSweep::default();
        let [mut found, mut expected] = [Vec::new(), Vec::new()];
        kernel.find_pairs(&boxes, &mut found).unwrap();
        let strips = kernel.classes[0].grid.axes.map(|axis| axis.last > 0);
        assert_eq!(strips, are_cut);
        BruteForce.find_pairs(&boxes, &mut expected).unwrap();
        found.sort_unstable();
        assert!(found == expected && found.len() < 5000);
        #[cfg(feature = "_adapter")]
        check_look_ups(&boxes, &expected);
    }
}

/// Looks every box up among all: each pair is found from both ends, and each box meets itself.
#[cfg(feature = "_adapter")]
fn check_look_ups(boxes: &[Aabb<f32, 3>], pairs: &[[u32; 2]]) {
    let everyone: Vec<u32> = (0..).take(boxes.len()).collect();
    let mut kernel = GridSweep::default();
    let mut found = Vec::new();
    let run = kernel.find_among(boxes, &everyone, &mut found, &mut Stopwatch::default());
    run.unwrap();
    found.clear();
    kernel.prepare_lookup();
    kernel.look_up(boxes, everyone.iter().copied(), &mut found);
    found.sort_unstable();
    let with_itself = everyone.iter().map(|&i| [i, i]);
    let mut expected: Vec<_> = pairs
        .iter()
        .flat_map(|&pair| [pair; 2])
        .chain(with_itself)
        .collect();
    expected.sort_unstable();
    assert!(found == expected);
}

/// Threads may be more than the boxes, or than those of a class: here three hundred specks and forty slabs across them.
#[test]
fn there_may_be_more_slabs_than_boxes() {
    let specks = rows(300, 20);
    let across = (0..40).map(|i| Aabb::new([-1.0, i as f32 * 0.5], [30.0, i as f32 * 0.5 + 20.0]));
    let mixed: Vec<_> = specks.iter().copied().chain(across).collect();
    for boxes in [&specks[..], &specks[..30], &specks[..2], &[], &mixed] {
        let [mut found, mut expected] = [Vec::new(), Vec::new()];
        let mut kernel = GridSweep::with_slabs(NonZero::new(1).unwrap());
        kernel.find_pairs(boxes, &mut expected).unwrap();
        for count in [7, 64, 1000] {
            let mut kernel = GridSweep::with_slabs(NonZero::new(count).unwrap());
            kernel.find_pairs(boxes, &mut found).unwrap();
            assert!(found == expected, "{count} slabs, {} boxes", boxes.len());
        }
        BruteForce.find_pairs(boxes, &mut expected).unwrap();
        found.sort_unstable();
        assert!(found == expected);
    }
}
