//! The union of what processes report against the oracle: every family of inputs, in 2D and 3D, f32 and f64. `./test` starts it by mpirun
//! with 1 to 7 processes; by itself it is one.

#[path = "../../../../tests/oracle/inputs.rs"]
#[expect(unused_imports)]
mod inputs;
#[path = "../../../../tests/oracle/limits.rs"]
mod limits;
#[path = "../../../../tests/oracle/numbers.rs"]
#[expect(dead_code)]
mod numbers;
#[path = "../../../../tests/oracle/order.rs"]
mod order;
#[path = "../../../../tests/oracle/placement.rs"]
mod placement;
#[path = "../../../../tests/oracle/random.rs"]
mod random;
#[path = "../../../../tests/oracle/shapes.rs"]
mod shapes;

use mpi::topology::SimpleCommunicator;
use mpi::traits::Communicator;
use numbers::Number;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::HashSet;
use unisize::{Aabb, BruteForce, InvalidInput, PairFinder};
use unisize_mpi::{Animal, Body, Domains, Herd, exchange, greatest, sum};
use unisize_scenes::{DriftingBoxes, HardBoxes, Stampede};

/// What boxes of the oracle are made of, and can be sent.
trait Sent: Number + Serialize + DeserializeOwned {}
impl Sent for f32 {}
impl Sent for f64 {}

fn main() {
    let universe = mpi::initialize().expect("MPI starts");
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        report(panic);
        std::process::exit(101);
    }));
    let world = universe.world();
    let flat = all::<f32, 2>(&world) + all::<f64, 2>(&world);
    let lists = flat + all::<f32, 3>(&world) + all::<f64, 3>(&world);
    loads_stay_alike(&world);
    herds_move_as_one(&world);
    if world.rank() == 0 {
        println!("{} processes: {lists} lists of boxes", world.size());
    }
}

/// Checks everything in one dimension and scalar, and returns the number of lists.
fn all<R: Sent, const D: usize>(world: &SimpleCommunicator) -> usize {
    let inputs = inputs::all::<R, D>().into_iter();
    let mut lists: Vec<_> = inputs.map(|input| (input.name, input.boxes)).collect();
    for kind in HardBoxes::ALL {
        let corner = |corner: [f32; D]| corner.map(|x| R::from_f64(x.into()));
        let boxes = kind.boxes::<D>(700, 7).into_iter();
        let boxes = boxes.map(|[mins, maxs]| Aabb::new(corner(mins), corner(maxs)));
        lists.push((kind.name().into(), boxes.collect()));
    }
    for (at, (name, boxes)) in lists.iter().enumerate() {
        union_is_exact(world, name, boxes, at % 2 == 0);
        if boxes.len() % 16 == 1 {
            first_fault_is_told_to_all(world, boxes);
        }
    }
    lists.len()
}

fn cube<R: Sent, const D: usize>(boxes: &[Aabb<R, D>], number: u64) -> Body<R, D> {
    Body {
        number,
        aabb: boxes[number as usize],
        rest: (),
    }
}

/// A share of the bodies for every process, or all of them for the last.
fn domains<'a, R: Sent, const D: usize>(
    world: &'a SimpleCommunicator,
    boxes: &[Aabb<R, D>],
    by_turns: bool,
) -> Domains<'a, R, D> {
    let (rank, size) = (world.rank() as u64, world.size() as u64);
    let owner = |number| if by_turns { number % size } else { size - 1 };
    let mine = (0..boxes.len() as u64).filter(|&number| owner(number) == rank);
    Domains::new(world, mine.map(|number| cube(boxes, number)).collect())
}

fn union_is_exact<R: Sent, const D: usize>(
    world: &SimpleCommunicator,
    name: &str,
    boxes: &[Aabb<R, D>],
    by_turns: bool,
) {
    let mut domains = domains(world, boxes, by_turns);
    let mut boxes = boxes.to_vec();
    for frame in 0..3 {
        domains.find_pairs().expect(name);
        let mut expected = Vec::new();
        BruteForce.find_pairs(&boxes, &mut expected).expect(name);
        let mut lists = vec![Vec::new(); world.size() as usize];
        lists[0] = domains.reported().collect();
        let mut union = Vec::new();
        exchange(world, &lists, &mut union).expect(name);
        union.sort_unstable();
        let is_exact = union.iter().eq(&expected
            .iter()
            .map(|pair| pair.map(u64::from))
            .collect::<Vec<_>>());
        assert!(
            is_exact || world.rank() > 0,
            "{name}, frame {frame}: {} of {}",
            union.len(),
            expected.len()
        );
        // Own bodies of the unisize class have all their partners here, and nobody is here twice.
        let number = |i: u32| domains.bodies()[i as usize].number as u32;
        let pairs = domains.pairs().iter().map(|pair| pair.map(number));
        let found: HashSet<_> = pairs.clone().map(|[a, b]| [a.min(b), a.max(b)]).collect();
        assert_eq!(
            found.len(),
            pairs.count(),
            "{name}: a pair is found twice on a process"
        );
        let unisize = domains
            .own()
            .iter()
            .filter(|body| domains.is_unisize(&body.aabb));
        let unisize: HashSet<_> = unisize.map(|body| body.number as u32).collect();
        let mut due = expected
            .iter()
            .filter(|pair| pair.iter().any(|number| unisize.contains(number)));
        assert!(
            due.all(|pair| found.contains(pair)),
            "{name}, frame {frame}: a partner lacks"
        );
        // Then every body is where another was, so that most migrate.
        let shift = (frame + 1).min(boxes.len());
        boxes.rotate_left(shift);
        domains
            .own_mut()
            .iter_mut()
            .for_each(|body| *body = cube(&boxes, body.number));
    }
}

/// With three faults in a list, every process names the first as one process would, and goes on when they are mended.
fn first_fault_is_told_to_all<R: Sent, const D: usize>(
    world: &SimpleCommunicator,
    sound: &[Aabb<R, D>],
) {
    for (axis, bad) in (0..D).flat_map(|axis| [(axis, f64::NAN), (axis, f64::INFINITY)]) {
        let (first, last, mut boxes) = (sound.len() / 3, sound.len() - 1, sound.to_vec());
        boxes[last].mins = [R::from_f64(f64::NAN); D];
        boxes[(first + last) / 2].maxs = [R::from_f64(f64::NAN); D];
        boxes[first] = sound[first];
        boxes[first].mins[axis] = R::from_f64(bad);
        boxes[first].maxs[axis] = R::from_f64(0.0);
        let expected = BruteForce
            .find_pairs(&boxes, &mut Vec::new())
            .expect_err("a box is invalid");
        let mut domains = domains(world, &boxes, true);
        let error = domains.find_pairs().expect_err("a box is invalid");
        assert_eq!(error.downcast_ref::<InvalidInput>(), Some(&expected));
        assert_eq!((expected.index, domains.reported().count()), (first, 0));
        domains
            .own_mut()
            .iter_mut()
            .for_each(|body| *body = cube(sound, body.number));
        domains.find_pairs().expect("the boxes are valid");
    }
}

/// Squares drift, every second one to the right: loads hardly differ by more than a fifth, and regions are seldom cut.
fn loads_stay_alike(world: &SimpleCommunicator) {
    let mut scene = DriftingBoxes::<2>::new(20_000, 0.2, 7);
    let square = |scene: &DriftingBoxes<2>, number: u64, frame: u64| {
        let [x, y] = scene.mins()[number as usize];
        let x = x + ((number + 1) % 2 * frame) as f32;
        Body {
            number,
            aabb: Aabb::new([x, y], [x + 1.0, y + 1.0]),
            rest: (),
        }
    };
    let all = if world.rank() == 0 { 20_000 } else { 0 };
    let own = (0..all).map(|number| square(&scene, number, 0));
    let mut domains = Domains::new(world, own.collect());
    let mut bisected = 0;
    for frame in 1..=300 {
        domains.find_pairs().expect("the boxes are valid");
        bisected += u32::from(domains.stats().bisected);
        let own = domains.own().len() as u64;
        let (most, least) = (greatest(world, own), !greatest(world, !own));
        assert_eq!(sum(world, own), 20_000);
        // Loads are compared before bodies migrate, so a frame passes until regions are cut.
        let mean = 20_000 / world.size() as u64;
        assert!(
            most - least <= mean * 2 / 5,
            "frame {frame}: from {least} to {most}"
        );
        scene.advance();
        domains
            .own_mut()
            .iter_mut()
            .for_each(|body| *body = square(&scene, body.number, frame));
    }
    let expected = if world.size() == 1 { 1..2 } else { 2..60 };
    assert!(
        expected.contains(&bisected),
        "regions were cut {bisected} times"
    );
}

/// The herd of `Stampede` itself, whose pairs are found by the oracle and sorted, bit for bit.
fn herds_move_as_one(world: &SimpleCommunicator) {
    for (count, steps) in [(0, 2), (1, 50), (5, 50), (2000, 100)] {
        let (mut alone, mut pairs) = (Stampede::new(count, 7), Vec::new());
        let mut herd = Herd::at_start(world, count);
        for _ in 0..steps {
            let boxes: Vec<_> = Animal::all(&alone).map(|animal| animal.aabb).collect();
            BruteForce
                .find_pairs(&boxes, &mut pairs)
                .expect("animals are somewhere");
            pairs.sort_unstable();
            alone.advance(pairs.iter().copied());
            herd.advance().expect("animals are somewhere");
            let all: Vec<_> = Animal::all(&alone).collect();
            let is_same = |animal: &Animal| *animal == all[animal.number as usize];
            assert!(
                herd.domains.own().iter().all(is_same),
                "{count} animals, step {}",
                herd.step
            );
            assert_eq!(sum(world, herd.domains.own().len() as u64), count as u64);
        }
    }
}
