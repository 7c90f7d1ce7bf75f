//! The names of the scenes, and what is known of each without building it.

/// Which world to build.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SceneKind {
    /// Balls falling into a box with a floor and walls.
    FallingBalls,
    /// A pyramid of cuboids that comes to rest and sleeps.
    Pyramid,
    /// Balls flying through a closed box without gravity.
    Gas,
    /// Chains of capsules that hang, fall over obstacles and tangle.
    Ropes,
    /// Balls joined in rows and columns, held at the edge, sagging over obstacles.
    Net,
    /// Grains poured through a funnel over time.
    Hopper,
    /// Walkers on a plane, each steering to a goal.
    Crowd,
    /// Kinematic bodies that all move at every step, without a solver.
    Swarm,
    /// Resting boxes, all asleep, among which a few balls move.
    Sleeping,
    /// Bodies whose sizes differ by up to a factor of 1.5, falling into a heap.
    MixedOneAndAHalf,
    /// Bodies whose sizes differ by up to a factor of 4, falling into a heap.
    MixedFour,
    /// Bodies whose sizes differ by up to a factor of 8, falling into a heap.
    MixedEight,
    /// Bodies whose sizes differ by up to a factor of 1,000: grains falling among hills.
    MixedThousand,
    /// Fast bullets with both kinds of continuous collision detection, shot at a thin wall and at a stack.
    Bullets,
    /// Balls that are inserted, removed, disabled and regrouped at every step.
    Churn,
    /// Every kind of collider, falling onto a height field.
    Shapes,
    /// Soft bodies among balls; balls on springs in versions of Rapier without soft bodies.
    Soft,
    /// A solid map of fixed unit squares or cubes, on which a few balls fall.
    TileMap,
    /// Rigid bodies of very many colliders, so that nearly all pairs are of one body.
    Ships,
    /// Overlapping balls whose collision groups keep them from touching each other.
    Ghosts,
    /// A character and, in space, a vehicle among falling balls, both of which ask the broad phase at every step.
    Player,
    /// Columns of boxes that stand close to each other without touching.
    Stacks,
    /// A brick wall.
    Wall,
    /// Many small pyramids that come to rest and sleep.
    Pyramids,
    /// Slanting chains of capsules whose boxes overlap where the capsules do not.
    Chains,
}

impl SceneKind {
    /// Every scene, in the order of the tables.
    pub const ALL: [Self; 25] = [
        Self::FallingBalls,
        Self::Pyramid,
        Self::Gas,
        Self::Ropes,
        Self::Net,
        Self::Hopper,
        Self::Crowd,
        Self::Swarm,
        Self::Sleeping,
        Self::MixedOneAndAHalf,
        Self::MixedFour,
        Self::MixedEight,
        Self::MixedThousand,
        Self::Bullets,
        Self::Churn,
        Self::Shapes,
        Self::Soft,
        Self::TileMap,
        Self::Ships,
        Self::Ghosts,
        Self::Player,
        Self::Stacks,
        Self::Wall,
        Self::Pyramids,
        Self::Chains,
    ];

    /// The name used on the command line and in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::FallingBalls => "falling-balls",
            Self::Pyramid => "pyramid",
            Self::Gas => "gas",
            Self::Ropes => "ropes",
            Self::Net => "net",
            Self::Hopper => "hopper",
            Self::Crowd => "crowd",
            Self::Swarm => "swarm",
            Self::Sleeping => "sleeping",
            Self::MixedOneAndAHalf => "mixed-1.5",
            Self::MixedFour => "mixed-4",
            Self::MixedEight => "mixed-8",
            Self::MixedThousand => "mixed-1000",
            Self::Bullets => "bullets",
            Self::Churn => "churn",
            Self::Shapes => "shapes",
            Self::Soft => "soft",
            Self::TileMap => "tile-map",
            Self::Ships => "ships",
            Self::Ghosts => "ghosts",
            Self::Player => "player",
            Self::Stacks => "stacks",
            Self::Wall => "wall",
            Self::Pyramids => "pyramids",
            Self::Chains => "chains",
        }
    }

    /// The scene of this [name](Self::name), if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// What happens in the scene, in one line.
    pub const fn description(self) -> &'static str {
        match self {
            Self::FallingBalls => "balls of about the same size falling into a walled box",
            Self::Pyramid => "a pyramid of cuboids that comes to rest and sleeps",
            Self::Gas => "elastic balls in a closed box without gravity",
            Self::Ropes => "chains of capsules that hang, fall over obstacles and tangle",
            Self::Net => "balls joined in rows and columns, held at the edge, over obstacles",
            Self::Hopper => "grains poured through a funnel over time",
            Self::Crowd => "walkers on a plane, each steering to its goal",
            Self::Swarm => "kinematic bodies and sensors that all move, without a solver",
            Self::Sleeping => "sleeping boxes, and one moving ball to a hundred of them",
            Self::MixedOneAndAHalf => "sizes 1 to 1.5 falling onto a half-space",
            Self::MixedFour => "sizes 1 to 4 falling onto a half-space",
            Self::MixedEight => "sizes 1 to 8 falling onto a half-space",
            Self::MixedThousand => "sizes 1 to 1,000, few large, in a pit of half-spaces",
            Self::Bullets => "fast bullets with CCD and soft CCD at a thin wall and a stack",
            Self::Churn => "falling balls of which 2 % are replaced at every step",
            Self::Shapes => "every kind of collider falling onto a height field",
            Self::Soft => "soft bodies in a heap with nine times as many balls",
            Self::TileMap => "balls falling onto a solid map of sixty fixed tiles to a ball",
            Self::Ships => "three drifting bodies, each of a third of the colliders",
            Self::Ghosts => "overlapping balls that pass through each other, slowly",
            Self::Player => "a character and a vehicle that query the world, among falling balls",
            Self::Stacks => "columns of fourteen boxes, a twentieth of a box apart",
            Self::Wall => "a brick wall that is left to stand",
            Self::Pyramids => "pyramids of 55 cuboids that come to rest and sleep",
            Self::Chains => "slanting chains of capsules, held at both ends, side by side",
        }
    }

    /// A number of bodies with which the default broad phase takes a few seconds for 300 steps.
    ///
    /// Of [`Ships`](Self::Ships) it is the number of colliders that move.
    pub const fn default_bodies(self) -> usize {
        match self {
            Self::Gas | Self::Crowd | Self::Swarm | Self::Sleeping => 10_000,
            Self::Pyramids => 8_000,
            Self::Stacks => 6_776,
            Self::Wall => 6_000,
            Self::Ships => 5_184,
            Self::Chains => 5_000,
            Self::Ghosts => 3_000,
            Self::TileMap => 500,
            Self::Pyramid | Self::Ropes | Self::Bullets | Self::Shapes | Self::Soft => 1_000,
            Self::FallingBalls
            | Self::Net
            | Self::Hopper
            | Self::MixedOneAndAHalf
            | Self::MixedFour
            | Self::MixedEight
            | Self::MixedThousand
            | Self::Churn
            | Self::Player => 2_000,
        }
    }

    /// Whether every body moves at every step, so that caching the boxes of resting bodies is useless.
    pub const fn all_move(self) -> bool {
        matches!(
            self,
            Self::Gas | Self::Crowd | Self::Swarm | Self::Ships | Self::Ghosts
        )
    }
}

#[cfg(test)]
mod tests {
    use super::SceneKind;

    #[test]
    fn names_lead_back_to_their_scenes() {
        for kind in SceneKind::ALL {
            assert_eq!(SceneKind::from_name(kind.name()), Some(kind));
            assert!(!kind.description().is_empty());
        }
        assert_eq!(SceneKind::from_name("no such scene"), None);
    }
}
