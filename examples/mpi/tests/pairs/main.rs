//! The pairs of all processes together are those of the oracle: on every family of inputs, in 2D and 3D, in f32 and f64. `./test` starts this
//! program with 1 to 7 processes.

#[path = "../../../../tests/common/boxes/mod.rs"]
#[allow(dead_code, unused_imports, unreachable_pub, missing_docs)]
mod arrangements; // By this name the oracle's inputs ask for them.
#[path = "../../../../tests/oracle/boxes.rs"]
mod boxes;
#[path = "../../../../tests/oracle/inputs.rs"]
mod inputs;
#[path = "../../../../tests/oracle/limits.rs"]
mod limits;
#[path = "../../../../tests/oracle/numbers.rs"]
#[expect(dead_code)]
mod numbers;
#[path = "../../../../tests/oracle/random.rs"]
mod random;

use anyhow::Result;
use inputs::input;
use numbers::Number;
use std::collections::HashSet;
use unisize::{Aabb, BruteForce, InvalidInput, PairFinder};
use unisize_mpi::{Body, Domains, Sent, World, sorted};

use arrangements::HardBoxes;

fn main() -> Result<()> {
    World::run(|world| {
        let flat = unions_are_exact::<f32, 2>(world)? + unions_are_exact::<f64, 2>(world)?;
        let solid = unions_are_exact::<f32, 3>(world)? + unions_are_exact::<f64, 3>(world)?;
        loads_stay_even(world)?;
        if world.rank() == 0 {
            println!(
                "{} processes: {} lists of boxes",
                world.size(),
                flat + solid
            );
        }
        Ok(())
    })
}

/// Checks everything in one dimension and scalar, and returns the number of lists.
fn unions_are_exact<R: Number, const D: usize>(world: &World) -> Result<usize>
where
    [R; D]: Sent,
{
    let mut lists = inputs::all::<R, D>();
    lists.extend(HardBoxes::ALL.map(|kind| {
        let corner = |corner: [f32; D]| corner.map(|x| R::from_f64(x.into()));
        let boxes = kind.boxes(700, 7).into_iter();
        let boxes = boxes.map(|[mins, maxs]| Aabb::new(corner(mins), corner(maxs)));
        input(kind.name(), boxes.collect())
    }));
    for list in &lists {
        let (name, mut boxes) = (&list.name, list.boxes.clone());
        let mut domains = domains(world, &boxes);
        for frame in 0..3 {
            if boxes.len() > 3 {
                all_processes_return_the_first_error(&mut domains, &boxes, boxes.len() + frame);
            }
            domains.find_pairs()?;
            let all = if world.rank() == 0 { &boxes[..] } else { &[] };
            let mut pairs = Vec::new();
            BruteForce.find_pairs(all, &mut pairs)?;
            let pairs = pairs.iter().map(|pair| pair.map(u64::from));
            let expected = world.gather(pairs.collect())?;
            let mut union = world.gather(domains.reported().collect())?;
            union.sort_unstable();
            assert!(union == expected, "{name}, frame {frame}: not the oracle's");
            // No pair is found twice, and own bodies of the unisize class have all of their partners here.
            let number = |i: u32| domains.bodies[i as usize].number;
            let pairs = domains.pairs.iter().map(|pair| sorted(pair.map(number)));
            let found: HashSet<_> = pairs.collect();
            let unisize = |body: &&Body<R, D>| domains.is_unisize(&body.aabb);
            let unisize = domains.own().iter().filter(unisize);
            let unisize: HashSet<_> = unisize.map(|body| body.number).collect();
            let mut not_found = expected.iter().filter(|&pair| !found.contains(pair));
            let is_lacking = not_found.any(|pair| pair.iter().any(|i| unisize.contains(i)));
            let twice = domains.pairs.len() - found.len();
            assert!(twice == 0 && !is_lacking, "{name}, frame {frame}");
            // Each body moves to the place of another one, so that most change owners.
            let shift = (frame + 1).min(boxes.len());
            boxes.rotate_left(shift);
            place(&mut domains, &boxes);
        }
    }
    Ok(lists.len())
}

/// Moves each own body to its box.
fn place<R: Number, const D: usize>(domains: &mut Domains<R, D>, boxes: &[Aabb<R, D>]) {
    for own in &mut domains.bodies {
        own.aabb = boxes[own.number as usize];
    }
}

/// All bodies start on the last process.
fn domains<'a, R: Number, const D: usize>(
    world: &'a World,
    boxes: &[Aabb<R, D>],
) -> Domains<'a, R, D>
where
    [R; D]: Sent,
{
    let is_last = world.rank() + 1 == world.size();
    let mine = if is_last { boxes } else { &[] };
    let bodies = (0..).zip(mine).map(|(number, &aabb)| {
        let payload = ();
        Body {
            number,
            aabb,
            payload,
        }
    });
    Domains::new(world, bodies.collect())
}

/// With three invalid boxes, every process returns the error that one process would. Restores the boxes.
fn all_processes_return_the_first_error<R: Number, const D: usize>(
    domains: &mut Domains<R, D>,
    sound: &[Aabb<R, D>],
    at: usize,
) where
    [R; D]: Sent,
{
    let (mut boxes, last, first) = (sound.to_vec(), sound.len() - 1, sound.len() / 4);
    boxes[last].mins = [R::from_f64(f64::NAN); D];
    boxes[last - 1].maxs = [R::from_f64(f64::NAN); D];
    boxes[first].mins[at % D] = R::from_f64([f64::NAN, f64::INFINITY][at / D % 2]);
    boxes[first].maxs[at % D] = R::from_f64(0.0);
    place(domains, &boxes);
    let expected = BruteForce.find_pairs(&boxes, &mut Vec::new());
    let expected = expected.expect_err("a box is invalid");
    let error = domains.find_pairs().expect_err("a box is invalid");
    assert_eq!(error.downcast_ref::<InvalidInput>(), Some(&expected));
    assert_eq!((expected.index, domains.reported().count()), (first, 0));
    place(domains, sound);
}

/// While every second square of a lattice drifts to the right, loads stay even with few cuts.
fn loads_stay_even(world: &World) -> Result<()> {
    let squares = |frame: usize| {
        let drift = |i: usize| i % 201 + i % 2 * frame;
        let mins = (0..20_000).map(|i| [drift(i), i / 201].map(|x| x as f32));
        Vec::from_iter(mins.map(|mins| Aabb::new(mins, mins.map(|x| x + 0.9))))
    };
    let mut domains = domains(world, &squares(0));
    let mut bisected = 0;
    for frame in 1..=300 {
        domains.find_pairs()?;
        bisected += u32::from(domains.stats.bisected);
        let (mean, spread) = domains.loads();
        assert_eq!(mean, 20_000 / world.size());
        // Loads are compared before bodies change owners, so regions are cut a frame later.
        assert!(spread <= mean * 2 / 5, "differ by {spread}");
        place(&mut domains, &squares(frame));
    }
    let expected = if world.size() == 1 { 1..2 } else { 2..60 };
    assert!(expected.contains(&bisected), "cut {bisected} times");
    Ok(())
}
