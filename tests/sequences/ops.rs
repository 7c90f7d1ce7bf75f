//! What can happen to colliders between two updates, in terms that serve two and three dimensions.
//!
//! Lengths come from short tables, so that boxes often touch exactly, stay just inside their margin or leave
//! it by a little. Colliders and bodies are named by a number that is taken modulo how many there are, so that
//! every sequence, and every shrunk one, makes sense.

use std::fmt;

use unisize::PairFilter;

/// Moves that stay inside a margin or just leave it.
pub(crate) const SMALL: [f32; 8] = [0.0, 0.001, -0.001, 0.005, -0.009, 0.01, 0.011, -0.02];

/// Moves that leave it far behind.
pub(crate) const LARGE: [f32; 9] = [0.0, 0.25, -0.25, 0.5, -0.5, 1.0, -1.0, 2.5, -2.5];

/// Coordinates of places that are near each other.
pub(crate) const NEAR: [f32; 9] = [0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.0, 3.0];

/// Coordinates of places that are far apart.
pub(crate) const FAR: [f32; 4] = [0.0, 1.0e3, -1.0e6, 1.0e18];

/// Radii and half extents.
pub(crate) const LENGTHS: [f32; 6] = [0.25, 0.1, 0.5, 0.499, 1.0, 3.0];

/// Coordinates of the normal of a half-space.
pub(crate) const NORMALS: [f32; 3] = [0.0, 1.0, -1.0];

/// Angles.
pub(crate) const ANGLES: [f32; 5] = [0.0, 0.4, -1.1, std::f32::consts::FRAC_PI_4, 2.5];

pub(crate) const SKINS: [f32; 4] = [0.0, 0.005, 0.1, 1.0];

pub(crate) const LENGTH_UNITS: [f32; 3] = [1.0, 0.1, 10.0];

pub(crate) const FILTERS: [PairFilter; 4] = [
    PairFilter::Bodies,
    PairFilter::Groups,
    PairFilter::Off,
    PairFilter::Shapes,
];

pub(crate) const MARGINS: [f32; 4] = [0.01, 0.0, 0.1, -1.0];

/// Memberships and filters of collision groups.
pub(crate) const GROUP_BITS: [u32; 4] = [u32::MAX, 1, 2, 0];

/// Indices far beyond those of any collider.
pub(crate) const FAR_INDICES: [u32; 3] = [1 << 20, u32::MAX - 1, u32::MAX];

/// Coordinates; the last is unused in two dimensions.
pub(crate) type Triple = [f32; 3];

/// A collider or a body, counted modulo how many there are.
pub(crate) type Pick = usize;

#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Ball(f32),
    Cuboid(Triple),
    /// Half the height of its axis, and its radius.
    Capsule(f32, f32),
    /// Two balls of this radius, this far apart on each axis.
    Compound(f32, f32),
    HalfSpace(Triple),
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum BodyKind {
    Dynamic,
    Fixed,
    KinematicPosition,
    KinematicVelocity,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Parent {
    None,
    New(BodyKind),
    Existing(Pick),
}

/// Which collision groups a collider is in and meets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Groups {
    pub(crate) memberships: u32,
    pub(crate) filter: u32,
}

/// Which types of bodies a collider meets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Types {
    Usual,
    /// Only pairs of fixed bodies, and of a fixed and a kinematic one.
    Fixed,
    All,
    None,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct NewCollider {
    pub(crate) shape: Shape,
    pub(crate) at: Triple,
    pub(crate) sensor: bool,
    pub(crate) enabled: bool,
    pub(crate) groups: Groups,
    pub(crate) types: Types,
}

/// One of the two lists that an update is given.
#[derive(Clone, Copy, Debug)]
pub(crate) enum List {
    Modified,
    Removed,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Op {
    Insert(NewCollider, Parent),
    /// Moves a collider, with its body if it has one.
    Move(Pick, Triple),
    /// Moves a collider with respect to its body.
    Shift(Pick, Triple),
    /// Puts a collider, or its body, at rest somewhere.
    Teleport(Pick, Triple),
    /// Turns a collider, with its body if it has one; in the plane by the first angle.
    Turn(Pick, Triple),
    /// Has a collider ask hooks, or no longer.
    Hook(Pick, bool),
    /// Sets the pose of a collider, or of its body, to NaN.
    Spoil(Pick),
    Resize(Pick, Shape),
    Skin(Pick, f32),
    Sensor(Pick, bool),
    Enable(Pick, bool),
    EnableBody(Pick, bool),
    Regroup(Pick, Groups),
    Retype(Pick, Types),
    BodyType(Pick, BodyKind),
    Push(Pick, Triple),
    Reparent(Pick, Option<Pick>),
    Remove(Pick),
    /// Removes a collider and inserts another, which gets the same index.
    Replace(Pick, NewCollider),
    RemoveBody {
        body: Pick,
        with_colliders: bool,
    },
    /// Puts clones of the sets back, as they were so many updates ago, and lists all colliders. The broad phase stays.
    Rewind(usize),
    /// Changes the length unit, and with it margin and prediction distance.
    LengthUnit(f32),
    /// Lists a collider once more. This and the following are for lists made by hand.
    ListAgain(List, Pick),
    /// Lists a collider that was removed some time ago.
    ListStale(List, Pick),
    /// Lists a handle that never existed.
    ListBogus(List, u32, u32),
    /// Inserts a collider without a body that is not listed: its box is handed over, and another one once it has moved by this.
    Announce(NewCollider, Triple),
    /// Moves a collider, with its body if it has one, and hands the boxes over that it has then, where the engine does so.
    Carry(Pick, Triple),
    /// Moves all colliders, with their bodies, by this. Hands over their boxes. Does so a number of times, and has queries see
    /// the boxes after each time or not.
    CarryAll(usize, Triple, bool),
    /// Has queries see the boxes that were handed over so far.
    Ask,
    /// Puts a clone in the place of the broad phase, and then, or not, one that was written and read.
    Renew(bool),
    /// Hands over a box that is another one than the collider has: around this place, or all NaN.
    HandOver(Pick, Option<Triple>),
    /// Hands over a box of a collider that was removed some time ago.
    HandOverStale(Pick, Triple),
    /// Hands over a box of a collider that never existed.
    HandOverBogus(u32, u32, Triple),
}

/// What happens, starting from an empty world.
#[derive(Clone)]
pub(crate) struct Sequence {
    /// The length unit that it begins with.
    pub(crate) length_unit: f32,
    /// The margin in the settings.
    pub(crate) margin: f32,
    /// Which pairs are left out, in the settings.
    pub(crate) filter: PairFilter,
    pub(crate) updates: Vec<Vec<Op>>,
}

impl fmt::Debug for Sequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "length unit {}, margin {}, filter {:?}",
            self.length_unit, self.margin, self.filter
        )?;
        for (i, ops) in self.updates.iter().enumerate() {
            writeln!(f, "update {i}")?;
            for op in ops {
                writeln!(f, "    {op:?}")?;
            }
        }
        Ok(())
    }
}
