//! Parry's own distance between all pairs that are not held, shape by shape: with `PairFilter::Shapes` it is never within
//! reach, whatever the shapes, their sizes and their poses.
//!
//! In other worlds, rotations, also of a compound's parts, and the normals of half-spaces need not be of unit length. There the boxes may not overlap either, and a pair
//! whose boxes do is held whenever Parry finds a contact. Rotations of nearly unit length make no difference.
//!
//! Many are put on the brink: as far from another collider as Parry says that they are within reach, to the last bit.

use unisize::PairFilter;

use super::rapier::prelude::*;
use super::shapes::{BOXES, HALF_SPACE, KINDS, Random, name};
use super::{Settings, UnisizeBroadPhase, cases, version};

/// Worlds in each flavour, unless `PROPTEST_CASES` says otherwise.
const WORLDS: u32 = 64;

const COLLIDERS: usize = 60;
const UPDATES: usize = 10;

/// Pairs in all worlds of a flavour.
struct Counts {
    /// Not held, and as far apart as they must be.
    checked: usize,
    /// By their kinds, the smaller one first: not held, although their boxes overlap.
    left_out: [[usize; KINDS]; KINDS],
}

struct Colliders {
    random: Random,
    params: IntegrationParameters,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    handles: Vec<ColliderHandle>,
    kinds: Vec<usize>,
    /// Whether rotations and normals may be of any length.
    are_stretched: bool,
}

impl Colliders {
    fn new(seed: u64, are_stretched: bool) -> Self {
        let random = Random::new(seed);
        let mut colliders = Self {
            random,
            params: IntegrationParameters::default(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            handles: Vec::new(),
            kinds: Vec::new(),
            are_stretched,
        };
        colliders.params.length_unit = colliders.random.unit.into();
        // Not 0: Parry takes distances that are small for its units for 0, and so it would tell nothing.
        let predictions = [0.002, 0.02, 0.2];
        colliders.params.normalized_prediction_distance = predictions[colliders.random.below(3)];
        for _ in 0..COLLIDERS {
            let (kind, shape) = colliders.shape();
            // Without bodies they count as fixed.
            let all = ActiveCollisionTypes::all();
            let collider = ColliderBuilder::new(shape).active_collision_types(all);
            colliders.handles.push(colliders.colliders.insert(collider));
            colliders.kinds.push(kind);
        }
        colliders
    }

    fn get(&self, i: usize) -> &Collider {
        &self.colliders[self.handles[i]]
    }

    fn get_mut(&mut self, i: usize) -> &mut Collider {
        &mut self.colliders[self.handles[i]]
    }

    /// The length of a rotation: that of one in three is 1, that of another one nearly 1.
    fn length_of_rotation(&mut self) -> Real {
        if !self.are_stretched {
            return 1.0;
        }
        let off = match self.random.below(3) {
            0 => 0.0,
            1 => 8.0 * Real::EPSILON,
            _ => 0.3,
        };
        1.0 + off * Real::from(self.random.triple(1.0)[0])
    }

    fn shape(&mut self) -> (usize, SharedShape) {
        let (kind, shape) = self.random.shape();
        if !self.are_stretched {
            return (kind, shape);
        }
        if let Some(compound) = shape.as_compound() {
            let parts = compound.shapes().iter();
            let parts = parts.map(|(pose, part)| {
                let length = self.length_of_rotation();
                (version::stretched(*pose, length), part.clone())
            });
            return (kind, SharedShape::compound(parts.collect()));
        }
        let length = (10.0 as Real).powf(self.random.triple(1.0)[0].into());
        (kind, version::stretched_half_space(shape, length))
    }

    /// Puts a collider somewhere, in some pose.
    fn put(&mut self, i: usize) {
        let extent = 3.0 * self.random.unit;
        let place = version::translation(self.random.triple(extent));
        self.get_mut(i).set_position(place);
        self.turn(i);
    }

    /// Turns a collider in its place, by a rotation of some length.
    fn turn(&mut self, i: usize) {
        let length = self.length_of_rotation();
        let mut turned = version::stretched(super::rotation(self.random.angles()), length);
        turned.translation = self.get(i).position().translation;
        self.get_mut(i).set_position(turned);
    }

    /// Moves a collider by little, often within its margin.
    fn nudge(&mut self, i: usize) {
        let by = 0.02 * self.random.unit;
        let pose = version::moved(*self.get(i).position(), self.random.triple(by));
        self.get_mut(i).set_position(pose);
    }

    /// Changes a collider in some way. Returns whether only its pose is another one.
    fn change(&mut self, i: usize) -> bool {
        match self.random.below(8) {
            0 => {
                let skin = self.random.length() * [0.0, 0.1][self.random.below(2)];
                self.get_mut(i).set_contact_skin(skin);
                return false;
            }
            1 => {
                let (kind, shape) = self.shape();
                self.get_mut(i).set_shape(shape);
                self.kinds[i] = kind;
                return false;
            }
            2 => self.turn(i),
            3 => self.nudge(i),
            4 => self.put(i),
            _ => {
                self.put(i);
                let other = (i + 1 + self.random.below(COLLIDERS - 1)) % COLLIDERS;
                self.bring_to_the_brink(i, other);
            }
        }
        true
    }

    /// Moves a collider on a ray from another one's origin, as far as Parry says that they are within reach, or one bit
    /// farther.
    fn bring_to_the_brink(&mut self, i: usize, other: usize) {
        let origin = version::coordinates(self.get(other));
        let far = 20.0 * self.random.unit;
        let direction = self.random.triple(far);
        let beyond = self.random.below(2);
        let mut moving = self.get(i).clone();
        let mut place_at = |part: Real| {
            let place = std::array::from_fn(|k| origin[k] + part * Real::from(direction[k]));
            moving.set_translation(place.into());
            self.are_near([&moving, self.get(other)]) == Some(true)
        };
        let (mut near, mut far) = (0.0, 1.0);
        if !place_at(near) || place_at(far) {
            return;
        }
        loop {
            let middle = near + (far - near) * 0.5;
            match (near < middle && middle < far, place_at(middle)) {
                (false, _) => break,
                (_, true) => near = middle,
                (_, false) => far = middle,
            }
        }
        place_at([near, far][beyond]);
        let pose = *moving.position();
        self.get_mut(i).set_position(pose);
    }

    fn reach(&self, [a, b]: [&Collider; 2]) -> Real {
        self.params.prediction_distance() + a.contact_skin() + b.contact_skin()
    }

    /// Whether two are within reach, by Parry; `None` if it cannot tell. In space and in `f32`, it finds two in ten million at a
    /// distance of 0 that are not, and finds what is right if it is asked the other way round.
    fn are_near(&self, [a, b]: [&Collider; 2]) -> Option<bool> {
        let reach = self.reach([a, b]);
        if [a, b].into_iter().any(is_stretched) {
            return version::are_in_contact(a, b, reach);
        }
        let distance = version::distance(a, b)?;
        let is_sure = distance > 0.0 || version::distance(b, a)? <= reach;
        Some(distance <= reach && is_sure)
    }

    fn boxes_overlap(&self, pair: [&Collider; 2]) -> bool {
        let [a, b] = pair.map(|collider| {
            let distance = self.params.prediction_distance() / 2.0;
            let aabb = collider.compute_aabb();
            aabb.loosened(collider.contact_skin() + distance)
        });
        a.intersects(&b)
    }
}

/// Whether the rotation of a collider, or of a part of it, or its normal, is not of unit length.
fn is_stretched(collider: &Collider) -> bool {
    let normal = collider.shape().as_halfspace().map(version::normal);
    let normal = normal.map_or(1.0, |it| {
        let coordinates = <[Real; DIM]>::from(it);
        coordinates.iter().map(|x| x * x).sum()
    });
    let parts = collider.shape().as_compound().into_iter();
    let parts = parts.flat_map(|compound| compound.shapes());
    let mut norms: Vec<_> = parts.map(|(pose, _)| version::norm_squared(pose)).collect();
    norms.extend([version::norm_squared(collider.position()), normal]);
    let is_off = |norm: &Real| (norm - 1.0).abs() > 8.0 * Real::EPSILON;
    norms.iter().any(is_off)
}

impl Counts {
    fn add(&mut self, world: &Colliders, held: &[[bool; COLLIDERS]; COLLIDERS]) {
        for i in 0..COLLIDERS {
            for j in i + 1..COLLIDERS {
                let pair = [world.get(i), world.get(j)];
                let Some(are_near) = world.are_near(pair) else {
                    continue;
                };
                if held[i][j] || world.are_stretched && !world.boxes_overlap(pair) {
                    continue;
                }
                let mut kinds = [world.kinds[i], world.kinds[j]];
                kinds.sort_unstable();
                let names = kinds.map(name);
                assert!(
                    !are_near,
                    "{names:?} are not held within {}",
                    world.reach(pair)
                );
                self.checked += 1;
                self.left_out[kinds[0]][kinds[1]] += usize::from(world.boxes_overlap(pair));
            }
        }
    }
}

/// Plays in a world, and looks at all pairs after each update.
fn play(seed: u64, are_stretched: bool, counts: &mut Counts) {
    let mut world = Colliders::new(seed, are_stretched);
    let settings = Settings::default().with_filter(PairFilter::Shapes);
    let mut broad_phase = UnisizeBroadPhase::with_settings(settings);
    (0..COLLIDERS).for_each(|i| world.put(i));
    let mut changed: Vec<_> = (0..COLLIDERS).collect();
    let mut modified = world.handles.clone();
    for update in 0..UPDATES {
        let Colliders {
            params,
            bodies,
            colliders,
            ..
        } = &world;
        let mut events = Vec::new();
        broad_phase.update(params, colliders, bodies, &modified, &[], &mut events);
        let mut held = [[false; COLLIDERS]; COLLIDERS];
        for pair in broad_phase.pairs() {
            let pair = [pair.collider1, pair.collider2];
            let [i, j] = pair.map(|handle| handle.into_raw_parts().0 as usize);
            held[i][j] = true;
        }
        counts.add(&world, &held);
        modified.clear();
        let mut boxes = Vec::new();
        // Of three updates, one has what was changed last, nudged, and two have boxes that are handed over.
        let [are_nudged, are_handed_over] = [update % 3 == 1, update % 3 > 0];
        if !are_nudged {
            let most = [4, COLLIDERS][world.random.below(2)];
            changed = (0..world.random.below(most))
                .map(|_| world.random.below(COLLIDERS))
                .collect();
        }
        for &i in &changed {
            let is_only_moved = if are_nudged {
                world.nudge(i);
                true
            } else {
                world.change(i)
            };
            let aabb = version::handed_over_box(world.get(i), &world.params, &world.bodies);
            match aabb {
                // By hand, a rotation of another length must be listed.
                Some(aabb)
                    if is_only_moved && are_handed_over && (are_nudged || !world.are_stretched) =>
                {
                    boxes.push((world.handles[i], aabb));
                }
                _ => modified.push(world.handles[i]),
            }
        }
        version::hand_over(&mut broad_phase, &world.params, &boxes);
    }
}

#[test]
fn what_is_not_held_is_out_of_reach() {
    let worlds = cases(WORLDS);
    let mut counts = Counts {
        checked: 0,
        left_out: [[0; KINDS]; KINDS],
    };
    (0..worlds.into()).for_each(|seed| play(seed, false, &mut counts));
    let Counts { checked, left_out } = counts;
    println!("{checked} pairs are not held");
    if worlds < WORLDS {
        return;
    }
    for (i, row) in left_out.iter().enumerate() {
        for (j, &count) in row.iter().enumerate().skip(i) {
            let kinds = [i, j];
            let has_volumes = kinds.iter().all(|kind| !BOXES.contains(kind));
            let are_told_apart = has_volumes && kinds != [HALF_SPACE; 2];
            assert_eq!(count > 0, are_told_apart, "{:?}: {count}", kinds.map(name));
        }
    }
}

#[test]
fn contacts_between_rotations_of_any_length_are_held() {
    let mut counts = Counts {
        checked: 0,
        left_out: [[0; KINDS]; KINDS],
    };
    (0..cases(WORLDS).into()).for_each(|seed| play(seed, true, &mut counts));
    let left_out = counts.left_out.as_flattened().iter().sum::<usize>();
    assert!(left_out > 100, "{left_out} of {}", counts.checked);
}
