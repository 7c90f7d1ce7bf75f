//! The union of what processes report against the oracle: every family of inputs, in 2D and 3D, f32 and f64. `./test` starts it by mpirun
//! with 1 to 7 processes; by itself it is one.

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
use unisize_mpi::{Animal, Body, Domains, Herd, Sent, World, sorted};
use unisize_scenes as arrangements; // By this name the oracle's inputs ask for them.
use unisize_scenes::{HardBoxes, Stampede};

fn main() -> Result<()> {
    World::run(|world| {
        let flat = unions_are_exact::<f32, 2>(world)? + unions_are_exact::<f64, 2>(world)?;
        let solid = unions_are_exact::<f32, 3>(world)? + unions_are_exact::<f64, 3>(world)?;
        loads_stay_alike(world)?;
        herds_move_as_one(world)?;
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
                first_fault_is_told_to_all(&mut domains, &boxes, boxes.len() + frame);
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
            // Nobody is here twice, and own bodies of the unisize class have all their partners here.
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
            // Then every body is where another was, so that most migrate.
            let shift = (frame + 1).min(boxes.len());
            boxes.rotate_left(shift);
            place(&mut domains, &boxes);
        }
    }
    Ok(lists.len())
}

/// Moves each own body to where its box is now.
fn place<R: Number, const D: usize>(domains: &mut Domains<R, D>, boxes: &[Aabb<R, D>]) {
    for own in &mut domains.bodies {
        own.aabb = boxes[own.number as usize];
    }
}

/// All bodies are on the last process, which deals them.
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
        let rest = ();
        Body { number, aabb, rest }
    });
    Domains::new(world, bodies.collect())
}

/// With three faults in a list, every process names the first as one process would. Then they are mended.
fn first_fault_is_told_to_all<R: Number, const D: usize>(
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

/// Every second square of a lattice drifts to the right: loads hardly differ by more than a fifth, and regions are seldom cut.
fn loads_stay_alike(world: &World) -> Result<()> {
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
        // Loads are compared before bodies migrate, so a frame passes until regions are cut.
        assert!(spread <= mean * 2 / 5, "differ by {spread}");
        place(&mut domains, &squares(frame));
    }
    let expected = if world.size() == 1 { 1..2 } else { 2..60 };
    assert!(expected.contains(&bisected), "cut {bisected} times");
    Ok(())
}

/// The herd of `Stampede` itself, whose pairs are found by the oracle and sorted, bit for bit.
fn herds_move_as_one(world: &World) -> Result<()> {
    for (count, steps) in [(0, 2), (1, 50), (5, 50), (2000, 100)] {
        let (mut alone, mut pairs) = (Stampede::new(count, 7), Vec::new());
        let mut herd = Herd::at_start(world, count);
        for step in 0..steps {
            let boxes: Vec<_> = Animal::all(&alone).map(|animal| animal.aabb).collect();
            BruteForce.find_pairs(&boxes, &mut pairs)?;
            pairs.sort_unstable();
            alone.advance(pairs.iter().copied());
            herd.advance()?;
            let mut all = world.gather(herd.domains.own().to_vec())?;
            all.sort_unstable_by_key(|animal| animal.number);
            assert!(Animal::all(&alone).eq(all), "{count}, step {step}");
        }
    }
    Ok(())
}
