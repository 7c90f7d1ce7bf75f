//! Inputs at the limits of floating point, where differences overflow or margins round to 0. `numbers::alphabet` has the limits of single
//! numbers.

use core::array::from_fn;

use crate::boxes::Side::{Above, AtNegative, AtPositive, Below, Everywhere, Finite};
use crate::boxes::{self, Side, uniform};
use crate::inputs::{Family, Input, each, input};
use crate::numbers::Number;

/// Scenes of all magnitudes, without a margin, and with a wide, a narrow and a negligible one.
pub(crate) fn scales<R: Number, const D: usize>() -> Family<R, D> {
    let max = R::LARGEST.to_f64();
    let scales = [4.0 / max, 1e-38, 1e-6, 1e-3, 1e3, 1e7, 1e30, 1e-8 * max].into_iter();
    each(
        scales.flat_map(|scale| [(scale, 0.0), (scale, 0.01)]),
        |(scale, margin)| format!("side {scale:e}, margin {margin}"),
        |(scale, margin)| boxes::scaled(10, 400, [scale, 0.0, margin]),
    )
}

/// Unit boxes so far from the origin that their sides have few digits or none.
pub(crate) fn far_from_origin<R: Number, const D: usize>() -> Family<R, D> {
    let offsets = [1e5, -1e6, 1e7, -1e8, 1e15, 1e16, -1e30].into_iter();
    each(
        offsets.flat_map(|offset| [0.0, 0.01, 0.5].map(|margin| (offset, margin))),
        |(offset, margin)| format!("unit boxes at {offset:e}, margin {margin}"),
        |(offset, margin)| boxes::scaled(11, 300, [1.0, offset, margin]),
    )
}

/// One box far from the others, or much larger, in the middle of the list.
pub(crate) fn strays<R: Number, const D: usize>() -> Family<R, D> {
    let stray = |(_, at, side): (&str, [f64; D], f64)| {
        let mut boxes = uniform(12, 500, 0.8);
        boxes.insert(250, boxes::sized(at, [side; D]));
        boxes
    };
    let mut strays = vec![
        ("unit box at 1e30", [1e30; D], 1.0),
        ("unit box at -1e30", [-1e30; D], 1.0),
        ("box of side 1e30 at 1e30", [1e30; D], 1e30),
        ("box of side 2e30 around all", [-1e30; D], 2e30),
        ("box of side 1e30 over one orthant", [0.0; D], 1e30),
    ];
    strays.extend((0..D).map(|axis| {
        let at = from_fn(|k| if k == axis { 1e30 } else { 0.0 });
        ("unit box at 1e30 on one axis", at, 1.0)
    }));
    each(strays, |(name, at, _)| format!("one {name}, {at:?}"), stray)
}

/// Boxes with infinite bounds, among unit boxes and alone.
pub(crate) fn infinite<R: Number, const D: usize>() -> Family<R, D> {
    let some_of: [(&str, &[Side]); 10] = [
        ("whole spaces", &[Everywhere]),
        ("orthants", &[Below, Above]),
        ("orthants, all above", &[Above]),
        ("orthants, all below", &[Below]),
        ("half spaces and whole", &[Everywhere, Above, Below]),
        ("half-infinite tubes", &[Finite, Above]),
        ("boxes at infinity", &[AtPositive]),
        ("boxes at negative infinity", &[AtNegative]),
        ("boxes at some infinity", &[Finite, AtPositive, AtNegative]),
        (
            "boxes of every infinite kind",
            &[Finite, Below, Above, Everywhere, AtPositive, AtNegative],
        ),
    ];
    let mut family = Vec::new();
    for (n, count) in [(300, 1), (300, 20), (0, 100)] {
        for (name, sides) in some_of {
            let boxes = boxes::with_infinite(n, count, |random| from_fn(|_| random.pick(sides)));
            family.push(input(format!("{count} {name} among {n} unit boxes"), boxes));
        }
        // Infinite on every axis but one.
        let boxes = boxes::with_infinite(n, count, |random| {
            let finite = random.below(D);
            from_fn(|k| if k == finite { Finite } else { Everywhere })
        });
        family.push(input(format!("{count} slabs among {n} unit boxes"), boxes));
    }
    family.push(far_reaching_plates());
    family
}

/// One box is so far away that infinite plates reach 2⁶¹ tubes of a `GridSweep` in 3D.
fn far_reaching_plates<R: Number, const D: usize>() -> Input<R, D> {
    let cell = |i: usize, k: usize| [0, i % 32, i / 32][k.min(2)] as f64 / 2.0;
    let near = (0..1000).map(|i| boxes::sized(from_fn(|k| cell(i, k)), [1.0; D]));
    let far = boxes::sized(from_fn(|k| if k == 0 { 0.0 } else { 3e9 }), [1.0; D]);
    let plates = (0..100).map(|i: u32| {
        let x = f64::from(i) / 100.0;
        boxes::between(from_fn(|k| {
            let [low, high] = match k {
                0 => [x, x + 0.005],
                _ => [f64::NEG_INFINITY, f64::INFINITY],
            };
            (R::from_f64(low), R::from_f64(high))
        }))
    });
    let boxes = near.chain([far]).chain(plates).collect();
    input("infinite plates, and one unit box at 3e9", boxes)
}
