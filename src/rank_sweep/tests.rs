//! Tests of internals, which the suite over all kernels does not see.

use super::*;

/// Squares of one size at random places.
fn squares(count: usize, extent: f32, size: f32) -> Vec<Aabb<f32, 2>> {
    let mut random = oorandom::Rand32::new(1);
    let mut corner = || [(); 2].map(|()| (random.rand_float() - 0.5) * extent);
    let corners = (0..count).map(|_| corner());
    corners
        .map(|mins| Aabb::new(mins, mins.map(|x| x + size)))
        .collect()
}

/// The sum is monotone for any rounding: no box ends before one that begins earlier.
#[test]
fn boxes_of_one_size_are_not_tested() {
    let boxes = squares(5000, 1e5, 9.1);
    let mut kernel = RankSweep::<f32, 2>::default();
    let ([first, _], lows, ranks) = (&mut kernel.axes, &mut kernel.lows, &mut kernel.ranks);
    first.sort(&boxes, 0);
    assert!(ranks::rank_endpoints(
        &first.keys,
        &first.order,
        lows,
        ranks
    ));
}

#[cfg(feature = "parallel")]
#[test]
fn sorting_both_axes_at_once_changes_nothing() {
    let boxes = squares(SORT_BOTH_AXES_FROM, 300.0, 1.0);
    let run = || {
        let (mut kernel, mut pairs) = (RankSweep::default(), Vec::new());
        kernel.find_pairs(&boxes, &mut pairs).unwrap();
        (kernel.axes[1].order.is_empty(), pairs)
    };
    let [one, two] = [1, 2].map(|threads| parallel::with_threads(threads, run));
    assert!(one.0 && !two.0);
    assert!(one.1 == two.1, "other pairs, or another order");
}
