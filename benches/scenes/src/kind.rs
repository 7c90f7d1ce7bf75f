//! The names of the scenes, and their default numbers of bodies.

named! {
    /// Which world to build.
    SceneKind {
        FallingBalls "falling-balls" "balls of about the same size falling into a walled box"
        Pyramid "pyramid" "a pyramid of cuboids that comes to rest and sleeps"
        Gas "gas" "elastic balls in a closed box without gravity"
        Ropes "ropes" "chains of capsules that hang, fall over obstacles and tangle"
        Net "net" "balls joined in rows and columns, held at the edge, over obstacles"
        Hopper "hopper" "grains poured into a funnel over time"
        Crowd "crowd" "walkers on the ground, each steering to its goal"
        Swarm "swarm" "kinematic bodies and sensors that all move, without a solver"
        Sleeping "sleeping" "sleeping boxes, and one moving ball to a hundred of them"
        MixedOneAndAHalf "mixed-1.5" "sizes 1 to 1.5 falling onto a half-space"
        MixedFour "mixed-4" "sizes 1 to 4 falling onto a half-space"
        MixedEight "mixed-8" "sizes 1 to 8 falling onto a half-space"
        MixedThousand "mixed-1000" "sizes 1 to 1,000, few large, in a pit of half-spaces"
        Bullets "bullets" "fast bullets with CCD and soft CCD at a thin wall and a stack"
        Churn "churn" "falling balls of which 2 % are replaced at every step"
        Shapes "shapes" "every kind of collider falling onto a height field"
        Soft "soft" "soft bodies in a heap with nine times as many balls"
        TileMap "tile-map" "balls falling onto a solid map of sixty fixed tiles to a ball"
        Ships "ships" "three drifting bodies, each of a third of the colliders"
        OneBody "one-body" "a turning body of hundreds of copies of a few overlapping hulls, in Rapier's examples as well"
        Ghosts "ghosts" "overlapping balls that pass through each other, slowly"
        Player "player" "a character and a vehicle that query the world, among falling balls"
        Columns "columns" "columns of fourteen boxes, a twentieth of a box apart"
        Stacks "stacks" "stacks of ten boxes, a box apart"
        Wall "wall" "a brick wall that is left to stand"
        Pyramids "pyramids" "pyramids of 55 cuboids that come to rest and sleep"
        Chains "chains" "slanting chains of capsules, held at both ends, side by side; in 3D they swing into each other"
        Touched "touched" "sleeping balls, all borrowed to be changed at every step, and not changed"
        Restated "restated" "fixed boxes whose positions are set to what they are at every step"
        Breathing "breathing" "balls whose radius changes at every step"
        SettledPile "settled-pile" "balls in a walled box that have come to rest before the first step"
        SettledHeap "settled-heap" "a heap of boxes that have come to rest before the first step"
    }
}

impl SceneKind {
    /// The scene of this [name](Self::name), if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// A number of bodies with which the default broad phase takes a few seconds for 300 steps.
    ///
    /// Of [`Ships`](Self::Ships) and [`OneBody`](Self::OneBody) it is the number of colliders that move.
    pub const fn default_bodies(self) -> usize {
        match self {
            Self::Gas | Self::Crowd | Self::Swarm | Self::Sleeping | Self::Restated => 10_000,
            Self::Pyramids | Self::Touched => 8_000,
            Self::Columns => 6_776,
            Self::Stacks => 6_250,
            Self::Wall => 6_000,
            Self::Ships => 5_184,
            Self::OneBody => 2_210,
            Self::Chains | Self::Breathing => 5_000,
            Self::Ghosts => 3_000,
            Self::TileMap => 500,
            Self::Pyramid | Self::Ropes | Self::Bullets | Self::Shapes | Self::Soft => 1_000,
            _ => 2_000,
        }
    }
}
