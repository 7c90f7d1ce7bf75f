//! Worlds and queries on them, in terms that serve two and three dimensions.
//!
//! Some lengths and places come from short tables, so that several colliders are often exactly as near as each other.
//! Colliders are named by a number that is taken modulo how many there are, so that every case, and every shrunk
//! one, makes sense.

use std::fmt;

/// Radii and half extents, tiny and huge ones among them.
pub(crate) const LENGTHS: [f32; 8] = [0.5, 0.25, 1.0, 0.5, 3.0, 0.01, 0.001, 200.0];

/// Coordinates of places and velocities.
pub(crate) const NUMBERS: [f32; 9] = [0.0, 0.5, -0.5, 1.0, -1.0, 2.5, -2.5, 4.0, -4.0];

/// How far a ray or a shape may go.
pub(crate) const REACHES: [f32; 4] = [f32::MAX, 50.0, 3.0, 0.25];

/// The margin of Rapier's own broad phase.
pub(crate) const DEFAULT_MARGIN: f32 = 0.01;

pub(crate) const OTHER_MARGINS: [f32; 4] = [0.0, 0.1, 2.0, -1.0];

/// Bits of collision groups.
pub(crate) const GROUP_BITS: [u32; 4] = [u32::MAX, 1, 2, 3];

/// Coordinates; the last is unused in two dimensions.
pub(crate) type Triple = [f32; 3];

/// A collider, counted modulo how many there are.
pub(crate) type Pick = usize;

#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Ball(f32),
    Cuboid(Triple),
    /// Half the height of its axis, and its radius.
    Capsule(f32, f32),
    /// Two balls of this radius, this far apart on each axis.
    Compound(f32, f32),
    /// A flat mesh of this half width.
    Mesh(f32),
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Body {
    Dynamic,
    Fixed,
    Kinematic,
}

/// Where something is, and by how many radians it is turned.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) at: Triple,
    pub(crate) turn: f32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct NewCollider {
    pub(crate) shape: Shape,
    pub(crate) pose: Pose,
    pub(crate) velocity: Triple,
    /// The body that it is on, if it is on any.
    pub(crate) body: Option<Body>,
    pub(crate) sensor: bool,
    pub(crate) enabled: bool,
    pub(crate) groups: u32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Change {
    Insert(NewCollider),
    /// Removes a collider; the next that is inserted gets its index.
    Remove(Pick),
    Enable(Pick, bool),
    Place(Pick, Pose),
    Resize(Pick, Shape),
    Sensor(Pick, bool),
}

/// What a [`Question`] leaves out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Filter {
    pub(crate) flags: u32,
    pub(crate) groups: Option<u32>,
    pub(crate) collider: Option<Pick>,
    /// The body of this collider.
    pub(crate) body_of: Option<Pick>,
    /// Colliders whose index is a multiple of this.
    pub(crate) multiples: Option<u32>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) origin: Triple,
    pub(crate) direction: Triple,
    pub(crate) reach: f32,
    pub(crate) solid: bool,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Cast {
    pub(crate) shape: Shape,
    pub(crate) pose: Pose,
    pub(crate) velocity: Triple,
    pub(crate) reach: f32,
    pub(crate) stop_at_penetration: bool,
    /// A hit is at most this far from it.
    pub(crate) target_distance: f32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Question {
    /// What the ray hits first, with normal and without, and all that it hits.
    Ray(Line),
    /// What is nearest to a point, and all that contain it.
    Point(Triple, bool),
    /// All that this shape intersects.
    Shape(Shape, Pose),
    /// All whose box meets this one, given by its centre and half extents.
    Region(Triple, Triple),
    /// What the shape hits first on a straight way.
    Cast(Cast),
}

/// Some changes and some steps, and then questions.
#[derive(Clone, Debug)]
pub(crate) struct Round {
    pub(crate) changes: Vec<Change>,
    pub(crate) steps: usize,
    pub(crate) questions: Vec<(Question, Filter)>,
}

/// What happens and is asked, starting from an empty world.
#[derive(Clone)]
pub(crate) struct Inquiry {
    /// The margin in the settings.
    pub(crate) margin: f32,
    pub(crate) rounds: Vec<Round>,
}

impl fmt::Debug for Inquiry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "margin {}", self.margin)?;
        for (i, round) in self.rounds.iter().enumerate() {
            writeln!(f, "round {i}")?;
            for change in &round.changes {
                writeln!(f, "    {change:?}")?;
            }
            writeln!(f, "    {} steps", round.steps)?;
            for (question, filter) in &round.questions {
                writeln!(f, "    {question:?}, {filter:?}")?;
            }
        }
        Ok(())
    }
}
