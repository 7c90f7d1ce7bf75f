//! The union of what processes report against the oracle: every family of inputs, in 2D and 3D, f32 and f64. `./test` starts it by mpirun
//! with 1 to 7 processes; by itself it is one.

#[path = "../../../../tests/oracle/boxes.rs"]
mod boxes;
#[path = "../../../../tests/oracle/inputs.rs"]
#[expect(unused_imports)]
mod inputs;
#[path = "../../../../tests/oracle/limits.rs"]
mod limits;
#[path = "../../../../tests/oracle/numbers.rs"]
#[expect(dead_code)]
mod numbers;
#[path = "../../../../tests/oracle/random.rs"]
mod random;

use mpi::topology::SimpleCommunicator;
use mpi::traits::Communicator;
use numbers::Number;
use serde::{Serialize, de::DeserializeOwned};
use std::collections::HashSet;
use unisize::{Aabb, BruteForce, InvalidInput, PairFinder};
use unisize_mpi::{Animal, Body, Domains, Herd, gather, greatest, sorted, start, sum};
use unisize_scenes::{DriftingBoxes, Stampede};

/// What boxes of the oracle are made of, and can be sent.
trait Sent: Number + Serialize + DeserializeOwned {}
impl<R: Number + Serialize + DeserializeOwned> Sent for R {}

fn main() {
    let universe = start().expect("MPI starts");
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
    let lists = inputs::all::<R, D>();
    for (at, list) in lists.iter().enumerate() {
        union_is_exact(world, &list.name, list.boxes.clone(), at % 2 == 0);
        if at % 8 == 0 && list.boxes.len() > 2 {
            first_fault_is_told_to_all(world, &list.boxes);
        }
    }
    lists.len()
}

fn body<R: Copy, const D: usize>(boxes: &[Aabb<R, D>], number: u64) -> Body<R, D> {
    let (aabb, rest) = (boxes[number as usize], ());
    Body { number, aabb, rest }
}

/// Moves each own body to where its box is now.
fn place<R: Sent, const D: usize>(domains: &mut Domains<R, D>, boxes: &[Aabb<R, D>]) {
    for own in &mut domains.bodies {
        *own = body(boxes, own.number);
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
    Domains::new(world, mine.map(|number| body(boxes, number)).collect())
}

fn union_is_exact<R: Sent, const D: usize>(
    world: &SimpleCommunicator,
    name: &str,
    mut boxes: Vec<Aabb<R, D>>,
    by_turns: bool,
) {
    let mut domains = domains(world, &boxes, by_turns);
    for frame in 0..3 {
        domains.find_pairs().expect(name);
        let mut expected = Vec::new();
        BruteForce.find_pairs(&boxes, &mut expected).expect(name);
        let expected: Vec<_> = expected.iter().map(|pair| pair.map(u64::from)).collect();
        let mut union = gather(world, domains.reported().collect()).expect(name);
        union.sort_unstable();
        assert!(union == expected, "{name}, frame {frame}: not the oracle's");
        // Own bodies of the unisize class have all their partners here, and nobody is here twice.
        let number = |i: u32| domains.bodies[i as usize].number;
        let pairs = domains.pairs.iter().map(|pair| sorted(pair.map(number)));
        let found: HashSet<_> = pairs.collect();
        assert_eq!(
            found.len(),
            domains.pairs.len(),
            "{name}: a pair is here twice"
        );
        let own = domains.own().iter();
        let unisize = own.filter(|body| domains.is_unisize(&body.aabb));
        let unisize: HashSet<_> = unisize.map(|body| body.number).collect();
        let is_due = |pair: &&[u64; 2]| pair.iter().any(|number| unisize.contains(number));
        let mut due = expected.iter().filter(is_due);
        let lacks = due.find(|&pair| !found.contains(pair));
        assert_eq!(lacks, None, "{name}, frame {frame}: a partner lacks");
        // Then every body is where another was, so that most migrate.
        let shift = (frame + 1).min(boxes.len());
        boxes.rotate_left(shift);
        place(&mut domains, &boxes);
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
        let expected = BruteForce.find_pairs(&boxes, &mut Vec::new());
        let expected = expected.expect_err("a box is invalid");
        let mut domains = domains(world, &boxes, true);
        let error = domains.find_pairs().expect_err("a box is invalid");
        assert_eq!(error.downcast_ref::<InvalidInput>(), Some(&expected));
        assert_eq!((expected.index, domains.reported().count()), (first, 0));
        place(&mut domains, sound);
        domains.find_pairs().expect("the boxes are valid");
    }
}

/// Squares drift, every second one to the right: loads hardly differ by more than a fifth, and regions are seldom cut.
fn loads_stay_alike(world: &SimpleCommunicator) {
    let mut scene = DriftingBoxes::<2>::new(20_000, 0.2, 7);
    let squares = |scene: &DriftingBoxes<2>, frame: usize| {
        let drift = |number: usize| ((number + 1) % 2 * frame) as f32;
        let mins = scene.mins().iter().enumerate();
        let mins = mins.map(|(number, &[x, y])| [x + drift(number), y]);
        Vec::from_iter(mins.map(|mins| Aabb::new(mins, mins.map(|x| x + 1.0))))
    };
    let mut domains = domains(world, &squares(&scene, 0), false);
    let mut bisected = 0;
    for frame in 1..=300 {
        domains.find_pairs().expect("the boxes are valid");
        bisected += u32::from(domains.stats.bisected);
        let own = domains.own as u64;
        let (most, least) = (greatest(world, own), !greatest(world, !own));
        assert_eq!(sum(world, own), 20_000);
        // Loads are compared before bodies migrate, so a frame passes until regions are cut.
        let tolerated = 20_000 / world.size() as u64 * 2 / 5;
        assert!(most - least <= tolerated, "from {least} to {most}");
        scene.advance();
        place(&mut domains, &squares(&scene, frame));
    }
    let expected = if world.size() == 1 { 1..2 } else { 2..60 };
    assert!(expected.contains(&bisected), "cut {bisected} times");
}

/// The herd of `Stampede` itself, whose pairs are found by the oracle and sorted, bit for bit.
fn herds_move_as_one(world: &SimpleCommunicator) {
    for (count, steps) in [(0, 2), (1, 50), (5, 50), (2000, 100)] {
        let (mut alone, mut pairs) = (Stampede::new(count, 7), Vec::new());
        let mut herd = Herd::at_start(world, count);
        for step in 0..steps {
            let boxes: Vec<_> = Animal::all(&alone).map(|animal| animal.aabb).collect();
            let found = BruteForce.find_pairs(&boxes, &mut pairs);
            found.expect("animals are somewhere");
            pairs.sort_unstable();
            alone.advance(pairs.iter().copied());
            herd.advance().expect("animals are somewhere");
            let all: Vec<_> = Animal::all(&alone).collect();
            let mut own = herd.domains.own().iter();
            let is_same = own.all(|animal| *animal == all[animal.number as usize]);
            assert!(is_same, "{count} animals, step {step}");
            assert_eq!(sum(world, herd.domains.own as u64), count as u64);
        }
    }
}
