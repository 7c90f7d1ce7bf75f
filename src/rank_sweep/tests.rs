//! What the suite over all kernels cannot see: what is not tested, what is done at once, and other numbers of axes.

use super::*;
use crate::brute_force::BruteForce;

/// The pairs that a kernel finds, which are also checked.
fn checked<R: Real, const D: usize>(
    kernel: &mut RankSweep<R, D>,
    boxes: &[Aabb<R, D>],
) -> Vec<[u32; 2]> {
    let [mut found, mut expected] = [Vec::new(), Vec::new()];
    kernel.find_pairs(boxes, &mut found).unwrap();
    BruteForce.find_pairs(boxes, &mut expected).unwrap();
    let mut sorted = found.clone();
    sorted.sort_unstable();
    assert!(sorted == expected);
    found
}

/// Boxes of one size at random places of a cube, rounded as `R` rounds.
fn one_size<R: Real, const D: usize>(count: usize, extent: f64, size: f64) -> Vec<Aabb<R, D>> {
    let mut random = oorandom::Rand64::new(1);
    let mut place = |_| R::from_f64((random.rand_float() - 0.5) * extent);
    let size = R::from_f64(size);
    let boxes = (0..count).map(|_| core::array::from_fn(&mut place));
    boxes
        .map(|mins: [R; D]| Aabb::new(mins, mins.map(|x| x + size)))
        .collect()
}

#[test]
fn one_axis_is_enough_and_four_are_not_too_many() {
    checked(
        &mut Default::default(),
        &one_size::<f32, 1>(300, 100.0, 1.0),
    );
    checked(&mut Default::default(), &one_size::<f64, 4>(300, 3.0, 1.0));
}

/// The sum is monotone, however it rounds: no box ends before one that begins earlier.
#[test]
fn boxes_of_one_size_are_not_tested() {
    let boxes = one_size::<f32, 2>(5000, 1e5, 9.1);
    let mut kernel = RankSweep::default();
    checked(&mut kernel, &boxes);
    let (sweep, [first, _]) = (&mut kernel.sweep, &mut kernel.narrow);
    let [order, _] = &mut sweep.orders;
    first.sort(&boxes, 0, order);
    let (lows, ranks) = (&mut sweep.lows, &mut sweep.ranks);
    assert!(ranks::rank_endpoints(&first.keys, order, lows, ranks));
}

#[cfg(feature = "parallel")]
#[test]
fn both_axes_at_once_are_as_one_after_the_other() {
    let boxes = one_size::<f32, 2>(SORT_BOTH_AXES_FROM, 300.0, 1.0);
    let [one, two] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let mut kernel = RankSweep::default();
        let mut pairs = Vec::new();
        let run = || kernel.find_pairs(&boxes, &mut pairs).unwrap();
        pool.build().unwrap().install(run);
        (kernel.sweep.orders[1].is_empty(), pairs)
    });
    assert!(one.0 && !two.0);
    assert!(one.1 == two.1, "another answer, or another order");
}
