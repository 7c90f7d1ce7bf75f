//! The names of the scenes.

/// Which world to build.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SceneKind {
    /// Balls falling into a box with a floor and walls.
    FallingBalls,
}

impl SceneKind {
    /// Every scene, in the order of the tables.
    pub const ALL: [Self; 1] = [Self::FallingBalls];

    /// The name used on the command line and in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::FallingBalls => "falling-balls",
        }
    }
}
