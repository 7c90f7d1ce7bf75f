//! Every kind of collider in one heap: composed and convex ones, bodies with several colliders, with
//! sensors and with contact skins, falling onto a height field with ridges.

use super::*;

/// The distance between bodies at the start.
const SPACING: Real = 2.2;
/// The height of the hills of the height field.
const HILLS: Real = 0.8;
/// The thickness of the contact skins.
const SKIN: Real = 0.05;
/// The number of kinds of bodies.
const KINDS: usize = 9;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 0.4);
    let half_width = lattice.half_width() + 1.0;
    // The floor is below the height field, and catches what slips through that surface.
    let walls = Container {
        lo: wide_high(-half_width, -1.0),
        hi: wide_high(half_width, lattice.height() + 4.0),
    };
    let mut stage = Stage::walled(walls);
    let world = &mut stage.world;
    let cells = (half_width as usize).clamp(2, 64);
    world
        .colliders
        .insert(flavour::terrain(cells, 2.0 * half_width, || {
            random.range(0.0, HILLS)
        }));
    for ridge in 0..lattice.columns.div_ceil(4) {
        let at = (ridge as Real + 0.5) * 4.0 * SPACING - lattice.half_width();
        world
            .colliders
            .insert(flavour::ridge(1.0, 1.2).translation(along(0, at) + along(UP, 0.3)));
    }

    for index in 0..bodies {
        let center = lattice.center(index) + along(UP, 2.0) + jitter(random, 0.05);
        let body = RigidBodyBuilder::dynamic()
            .translation(center)
            .linvel(jitter(random, 1.0));
        let body = world.bodies.insert(body);
        for collider in colliders(index % KINDS, random) {
            world
                .colliders
                .insert_with_parent(collider, body, &mut world.bodies);
        }
    }
    stage
}

/// The colliders of a body of one of the kinds. All fit into a cell of the lattice however they are turned.
fn colliders(kind: usize, random: &mut Random) -> Vec<ColliderBuilder> {
    let slab = vector(|axis| if axis == UP { 0.2 } else { 0.5 });
    let beside = along(0, 0.5);
    match kind {
        0 => vec![ColliderBuilder::ball(0.5)],
        1 => vec![cube(0.5)],
        2 => vec![ColliderBuilder::capsule_y(0.4, 0.3)],
        3 => vec![cuboid(slab).contact_skin(SKIN)],
        4 => vec![convex(random)],
        5 => vec![compound()],
        // A body with several colliders, of which one has a skin.
        6 => vec![
            ColliderBuilder::ball(0.3).translation(beside),
            ColliderBuilder::ball(0.3)
                .translation(-beside)
                .contact_skin(SKIN),
            cuboid(vector(|axis| if axis == 0 { 0.5 } else { 0.1 })),
        ],
        // A body that feels what is near to it.
        7 => vec![
            ColliderBuilder::ball(0.4),
            ColliderBuilder::ball(0.9)
                .density(0.0)
                .sensor(true)
                .active_events(ActiveEvents::COLLISION_EVENTS),
        ],
        _ => vec![rounded()],
    }
}

/// The convex hull of a few points around a ball.
pub(super) fn convex(random: &mut Random) -> ColliderBuilder {
    let mut points: Vec<Point> = Vec::new();
    // The corners of a cross-polytope, so that the hull is never flat.
    for axis in 0..DIM {
        for side in [-0.6, 0.6] {
            points.push((along(axis, side) + jitter(random, 0.1)).into());
        }
    }
    for _ in 0..4 {
        points.push(jitter(random, 0.4).into());
    }
    ColliderBuilder::convex_hull(&points).expect("the points are not flat")
}

/// One collider of two bars that form a corner.
fn compound() -> ColliderBuilder {
    let bar = |long: usize| {
        let half = vector(|axis| if axis == long { 0.5 } else { 0.15 });
        cuboid(half).build().shared_shape().clone()
    };
    ColliderBuilder::compound(vec![
        (version::pose(along(0, 0.35)), bar(0)),
        (version::pose(along(UP, 0.35)), bar(UP)),
    ])
}

/// A cube with round edges.
fn rounded() -> ColliderBuilder {
    let coordinate = |corner: usize, axis: usize| [-0.35, 0.35][corner >> axis & 1];
    let corners = (0..1 << DIM).map(|corner| vector(|axis| coordinate(corner, axis)).into());
    let corners: Vec<Point> = corners.collect();
    ColliderBuilder::round_convex_hull(&corners, 0.1).expect("a cube is convex")
}
