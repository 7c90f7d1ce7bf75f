//! The scenes: their names, their sizes, and what is known of their outcome.

/// What keeps a fast body from flying through a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Continuous {
    Discrete,
    Soft,
    Ccd,
}

/// What is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scene {
    Ropes,
    Pile,
    Hopper,
    Stack,
    Bullets(Continuous),
    Pendulum,
    Silo,
}

impl Scene {
    pub(crate) const ALL: [Self; 9] = [
        Self::Ropes,
        Self::Pile,
        Self::Hopper,
        Self::Stack,
        Self::Bullets(Continuous::Discrete),
        Self::Bullets(Continuous::Soft),
        Self::Bullets(Continuous::Ccd),
        Self::Pendulum,
        Self::Silo,
    ];

    /// The name in tables.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Bullets(Continuous::Discrete) => "bullets, discrete",
            Self::Bullets(Continuous::Soft) => "bullets, soft CCD",
            Self::Bullets(Continuous::Ccd) => "bullets, CCD",
            _ => self.group(),
        }
    }

    /// The name on the command line and in charts.
    pub(crate) const fn group(self) -> &'static str {
        match self {
            Self::Ropes => "ropes",
            Self::Pile => "pile",
            Self::Hopper => "hopper",
            Self::Stack => "stack",
            Self::Bullets(_) => "bullets",
            Self::Pendulum => "pendulum",
            Self::Silo => "silo",
        }
    }

    /// The names on the command line, each once.
    pub(crate) fn groups() -> Vec<&'static str> {
        let mut groups = Self::ALL.map(Self::group).to_vec();
        groups.dedup();
        groups
    }

    /// What happens, and what would be right, in one line.
    pub(crate) const fn description(self) -> &'static str {
        match self {
            Self::Ropes => "Chains of capsules fall over obstacles; their joints should hold.",
            Self::Pile => {
                "Balls and boxes fall into a walled box; they should rest, and not in each other."
            }
            Self::Hopper => {
                "Grains run through a hole in a floor onto another floor; none should leave through a wall."
            }
            Self::Stack => "Towers of ten boxes, which should stand where they were built.",
            Self::Bullets(Continuous::Discrete) => {
                "Balls at 10 to 160 a second hit a thin wall; none should pass."
            }
            Self::Bullets(Continuous::Soft) => "The same with soft CCD.",
            Self::Bullets(Continuous::Ccd) => "The same with CCD.",
            Self::Pendulum => {
                "Pendulums, of which single ones should swing by the cosine, and chains should keep their energy."
            }
            Self::Silo => {
                "Grains at rest between walls without friction; the floor should bear their weight."
            }
        }
    }

    /// How many bodies there are, about.
    pub(crate) const fn bodies(self) -> usize {
        match self {
            Self::Ropes | Self::Pile | Self::Hopper => 200,
            Self::Stack | Self::Silo => 120,
            Self::Bullets(_) => 200,
            Self::Pendulum => 100,
        }
    }

    /// How many seconds are simulated.
    pub(crate) const fn seconds(self) -> f64 {
        match self {
            Self::Bullets(_) => 1.2,
            _ => 2.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Scene;

    #[test]
    fn names_are_unique_and_groups_too() {
        let mut names = Scene::ALL.map(Scene::name).to_vec();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Scene::ALL.len());
        let mut groups = Scene::groups();
        assert_eq!(groups.len(), 7);
        groups.sort_unstable();
        groups.dedup();
        assert_eq!(groups.len(), 7);
    }
}
