//! The named inputs, in families. Each family is a test of its own in every instantiation of the suite.
//!
//! Lists are a few hundred boxes long, since the oracle looks at every pair.

use crate::numbers::Number;
use unisize::Aabb;

use crate::limits::{self, Side};
use crate::numbers;
use crate::order;
use crate::placement::{self, Meet};
use crate::shapes;

/// A list of boxes with its name in a report.
pub(crate) struct Input<R, const D: usize> {
    /// What kind of boxes these are.
    pub(crate) name: String,
    /// The boxes.
    pub(crate) boxes: Vec<Aabb<R, D>>,
}

/// All the inputs of one kind.
type Family<R, const D: usize> = Vec<Input<R, D>>;

/// Hands the name of every family, after the tokens given, to another macro.
macro_rules! for_every_family {
    ($then:ident $tokens:tt) => {
        $then! { $tokens
            uniform clustered coincident touching lines columns planes diagonals points_and_flat scales
            far_from_origin strays infinite mixed_sizes needles plates signed_zeros denormals extremes
            neighbours counts sorted ties everything_together
        }
    };
}
pub(crate) use for_every_family;

/// Every input of every family.
pub(crate) fn all<R: Number, const D: usize>() -> Family<R, D> {
    macro_rules! concatenated {
        ([] $($family:ident)*) => { [$($family()),*].into_iter().flatten().collect() };
    }
    for_every_family!(concatenated [])
}

fn input<R, const D: usize>(name: impl Into<String>, boxes: Vec<Aabb<R, D>>) -> Input<R, D> {
    Input {
        name: name.into(),
        boxes,
    }
}

/// Unit boxes anywhere, from lonely to crowded.
pub(crate) fn uniform<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = Vec::new();
    for density in [0.01, 0.1, 0.3, 0.8, 1.5, 3.0] {
        for n in [100, 1000] {
            family.push(input(
                format!("uniform, n = {n}, density {density}"),
                placement::uniform(n as u64, n, density),
            ));
        }
    }
    family.push(input("uniform, n = 3000", placement::uniform(1, 3000, 0.5)));
    family
}

/// Dense heaps with nothing between them.
pub(crate) fn clustered<R: Number, const D: usize>() -> Family<R, D> {
    [10.0, 1e3, 1e6]
        .map(|distance| {
            input(
                format!("100 clusters {distance:e} apart"),
                placement::clustered(2, 100, 8, distance),
            )
        })
        .into()
}

/// The same box many times.
pub(crate) fn coincident<R: Number, const D: usize>() -> Family<R, D> {
    [(300, 1), (150, 2), (3, 100)]
        .map(|(n, stacks)| {
            input(
                format!("{n} boxes in each of {stacks} stacks"),
                placement::coincident(n, stacks),
            )
        })
        .into()
}

/// Boxes side by side that share faces, edges and corners, or miss by one unit in the last place.
pub(crate) fn touching<R: Number, const D: usize>() -> Family<R, D> {
    let per_axis = if D == 2 { 24 } else { 8 };
    let mut family = Vec::new();
    for pitch in [1.0, 0.1, 3.7] {
        for meet in [Meet::Exactly, Meet::Short, Meet::Over, Meet::Jittered] {
            family.push(input(
                format!("lattice, pitch {pitch}, meeting {meet:?}"),
                placement::lattice(3, per_axis, pitch, meet),
            ));
        }
    }
    family
}

/// One input for each axis.
fn per_axis<R, const D: usize>(
    name: &str,
    boxes: impl Fn(usize) -> Vec<Aabb<R, D>>,
) -> impl Iterator<Item = Input<R, D>> {
    (0..D).map(move |axis| input(format!("{name}, axis {axis}"), boxes(axis)))
}

/// Boxes on a line along each axis.
pub(crate) fn lines<R: Number, const D: usize>() -> Family<R, D> {
    per_axis("line", |axis| placement::on_line(4, 600, axis)).collect()
}

/// Boxes in a pile along each axis.
pub(crate) fn columns<R: Number, const D: usize>() -> Family<R, D> {
    per_axis("column", |axis| placement::in_column(5, 600, axis)).collect()
}

/// Boxes on a plane across each axis (in 2D, another line).
pub(crate) fn planes<R: Number, const D: usize>() -> Family<R, D> {
    per_axis("plane", |axis| placement::on_plane(6, 600, axis)).collect()
}

/// Boxes along each diagonal.
pub(crate) fn diagonals<R: Number, const D: usize>() -> Family<R, D> {
    (0..1 << (D - 1))
        .map(|mirrored| {
            input(
                format!("diagonal, axes mirrored {mirrored:#b}"),
                placement::on_diagonal(7, 600, mirrored),
            )
        })
        .collect()
}

/// Boxes without extent on all axes, or on one.
pub(crate) fn points_and_flat<R: Number, const D: usize>() -> Family<R, D> {
    let mut family: Vec<_> = per_axis("flat", |axis| shapes::flat(8, 400, axis)).collect();
    for extent in [1, 4, 20, 1000] {
        family.push(input(
            format!("points, {extent} per axis"),
            shapes::points(9, 300, extent),
        ));
    }
    family
}

/// Scenes of every magnitude, as they are and with a margin that is wide, narrow or nothing beside it.
pub(crate) fn scales<R: Number, const D: usize>() -> Family<R, D> {
    let max = R::LARGEST.to_f64();
    let mut family = Vec::new();
    for scale in [4.0 / max, 1e-38, 1e-6, 1e-3, 1e3, 1e7, 1e30, 1e-8 * max] {
        for margin in [0.0, 0.01] {
            family.push(input(
                format!("side {scale:e}, margin {margin}"),
                limits::scaled(10, 400, scale, 0.0, margin),
            ));
        }
    }
    family
}

/// Unit boxes so far out that coordinates have few digits left for them, or none.
pub(crate) fn far_from_origin<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = Vec::new();
    for offset in [1e5, -1e6, 1e7, -1e8, 1e15, 1e16, -1e30] {
        for margin in [0.0, 0.01, 0.5] {
            family.push(input(
                format!("unit boxes at {offset:e}, margin {margin}"),
                limits::scaled(11, 300, 1.0, offset, margin),
            ));
        }
    }
    family
}

/// One stray box far from the others, or much larger.
pub(crate) fn strays<R: Number, const D: usize>() -> Family<R, D> {
    let stray = |name: &str, at, side| input(name, limits::with_stray(12, 500, at, side));
    let mut family = vec![
        stray("stray unit box at 1e30", [1e30; D], 1.0),
        stray("stray unit box at -1e30", [-1e30; D], 1.0),
        stray("stray box of side 1e30 at 1e30", [1e30; D], 1e30),
        stray("one box of side 2e30 around all", [-1e30; D], 2e30),
        stray("one box of side 1e30 over one orthant", [0.0; D], 1e30),
    ];
    family.extend(per_axis("stray unit box at 1e30", |axis| {
        let mut at = [0.0; D];
        at[axis] = 1e30;
        limits::with_stray(13, 500, at, 1.0)
    }));
    family
}

/// Boxes with sides at infinity, among unit boxes and alone.
pub(crate) fn infinite<R: Number, const D: usize>() -> Family<R, D> {
    use Side::{Above, AtNegative, AtPositive, Below, Everywhere, Finite};
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
            let boxes = limits::with_infinite(14, n, count, sides);
            family.push(input(format!("{count} {name} among {n} unit boxes"), boxes));
        }
        let boxes = limits::with_slabs(15, n, count);
        family.push(input(format!("{count} slabs among {n} unit boxes"), boxes));
    }
    family
}

/// Boxes of different sizes.
pub(crate) fn mixed_sizes<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = Vec::new();
    for ratio in [1.5, 4.0, 100.0, 1000.0] {
        let boxes = shapes::mixed_sizes(16, 800, ratio);
        family.push(input(format!("sides from 1 to {ratio}"), boxes));
    }
    for decades in [2.0, 6.0, 30.0] {
        let boxes = shapes::log_uniform_sizes(17, 800, decades);
        family.push(input(format!("sides over {decades} decades"), boxes));
    }
    for (share, ratio) in [(0.01, 100.0), (0.01, 1e4), (0.5, 100.0)] {
        let name = format!("a share of {share} that is {ratio} times as large");
        family.push(input(name, shapes::few_large(18, 1000, share, ratio)));
    }
    for period in [2, 3, 4] {
        family.push(input(
            format!("one box in {period} 50 times as large, by turns"),
            shapes::large_by_turns(32, 1200, period, 50.0),
        ));
    }
    let mut boxes = placement::clustered(33, 60, 8, 1e6);
    boxes.extend(shapes::mixed_sizes::<R, D>(34, 40, 1e6));
    family.push(input(
        "clusters 1e6 apart and boxes as large as that",
        boxes,
    ));
    family
}

/// Long thin boxes along each axis, and along all.
pub(crate) fn needles<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = Vec::new();
    for density in [0.02, 0.3] {
        let name = format!("needles, density {density}");
        let along = |axis| shapes::needles(19, 500, axis, density);
        family.extend(per_axis(&name, |axis| along(Some(axis))));
        family.push(input(format!("{name}, mixed"), along(None)));
    }
    family
}

/// Wide plates piled along each axis: apart, touching, and in one another.
pub(crate) fn plates<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = Vec::new();
    for pitch in [1.25, 1.0, 0.25] {
        family.extend(per_axis(&format!("plates, pitch {pitch}"), |axis| {
            shapes::plates(20, 300, axis, pitch)
        }));
    }
    family
}

/// Numbers that are equal but not identical: the two zeros.
pub(crate) fn signed_zeros<R: Number, const D: usize>() -> Family<R, D> {
    [2, 10, 200]
        .map(|n| {
            let boxes = limits::from_alphabet(21, n, &numbers::signed_zeros());
            input(format!("{n} boxes from -1, -0, 0 and 1"), boxes)
        })
        .into()
}

/// Numbers too small to have their full precision.
pub(crate) fn denormals<R: Number, const D: usize>() -> Family<R, D> {
    let boxes = limits::from_alphabet(22, 200, &numbers::denormals());
    vec![input("boxes of a few least positive numbers", boxes)]
}

/// Boxes whose sides overflow.
pub(crate) fn extremes<R: Number, const D: usize>() -> Family<R, D> {
    let boxes = limits::from_alphabet(23, 200, &numbers::extremes());
    let mut among_others = placement::uniform(24, 200, 0.8);
    among_others.extend_from_slice(&boxes[..20]);
    vec![
        input(
            "boxes anywhere between the extremes",
            limits::of_all_magnitudes(31, 400),
        ),
        input("boxes up to the greatest number", boxes),
        input(
            "unit boxes, then boxes up to the greatest number",
            among_others,
        ),
    ]
}

/// Boxes that differ by a few units in the last place.
pub(crate) fn neighbours<R: Number, const D: usize>() -> Family<R, D> {
    [1.0, -1.0, 0.1, 3e-39, 65536.0, 1e7, 16_777_216.0, -1e30]
        .map(|x| {
            let boxes = limits::from_alphabet(25, 150, &numbers::neighbours(x));
            input(
                format!("boxes a few units in the last place around {x:e}"),
                boxes,
            )
        })
        .into()
}

/// List lengths around every power of two, where blocks, lanes and words end.
pub(crate) fn counts<R: Number, const D: usize>() -> Family<R, D> {
    let around = |bits: u32| (1 << bits) - 1..=(1 << bits) + 1;
    let mut family = Vec::new();
    for n in (0..7).chain((3..=12).flat_map(around)) {
        family.push(input(format!("n = {n}"), placement::uniform(26, n, 0.8)));
        if n < 300 {
            let boxes = placement::coincident(n, 1);
            family.push(input(format!("n = {n}, coincident"), boxes));
            let boxes = placement::on_line(27, n, n % D);
            family.push(input(format!("n = {n}, line"), boxes));
        }
    }
    family
}

/// Lists that are already sorted, or in the worst order.
pub(crate) fn sorted<R: Number, const D: usize>() -> Family<R, D> {
    let boxes = placement::uniform(28, 500, 0.8);
    let mut family: Vec<_> =
        per_axis("sorted", |axis| order::sorted(boxes.clone(), axis)).collect();
    family.extend(per_axis("reversed", |axis| {
        order::reversed(order::sorted(boxes.clone(), axis))
    }));
    family.extend(per_axis("almost sorted", |axis| {
        order::almost_sorted(boxes.clone(), axis)
    }));
    family
}

/// Boxes with whole corners.
pub(crate) fn ties<R: Number, const D: usize>() -> Family<R, D> {
    [(200, 3), (600, 10), (600, 30), (600, 200)]
        .map(|(n, extent)| {
            let boxes = shapes::whole_corners(29, n, extent);
            input(
                format!("{n} boxes with corners of {extent} numbers per axis"),
                boxes,
            )
        })
        .into()
}

/// A few of nearly everything in one list.
pub(crate) fn everything_together<R: Number, const D: usize>() -> Family<R, D> {
    let mut boxes = placement::uniform(30, 300, 0.8);
    for family in [
        clustered(),
        coincident(),
        touching(),
        points_and_flat(),
        scales(),
        far_from_origin(),
        strays(),
        infinite(),
        mixed_sizes(),
        needles(),
        plates(),
        signed_zeros(),
        denormals(),
        extremes(),
        neighbours(),
    ] {
        for input in family {
            boxes.extend(input.boxes.iter().rev().take(5));
        }
    }
    vec![input("a few boxes of each input", boxes)]
}
