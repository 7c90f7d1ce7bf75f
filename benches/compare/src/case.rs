//! The subject of a row of the table: a scene with its own number of bodies or another one.

use unisize_scenes::SceneKind;

/// A scene, and a number of bodies; without one, the scene has its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Case {
    pub(super) kind: SceneKind,
    pub(super) bodies: Option<usize>,
}

impl Case {
    const fn of(kind: SceneKind, bodies: usize) -> Self {
        Self {
            kind,
            bodies: Some(bodies),
        }
    }

    /// Every scene at its own number of bodies.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        SceneKind::ALL.into_iter().map(Self::from)
    }

    /// Some scenes with a larger number of bodies, which show the effect of size.
    pub(super) fn large() -> impl Iterator<Item = Self> {
        use SceneKind::{FallingBalls, MixedOneAndAHalf, Pyramid};
        let kinds = [FallingBalls, Pyramid, MixedOneAndAHalf];
        kinds.into_iter().map(|kind| Self::of(kind, 8_000))
    }

    /// The name of the scene, followed by the number of bodies if that is not its own.
    pub(super) fn name(self) -> String {
        let name = self.kind.name();
        self.bodies
            .map_or_else(|| name.to_owned(), |bodies| format!("{name}-{bodies}"))
    }

    /// The case of this [name](Self::name), if there is one.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        if let Some(kind) = SceneKind::from_name(name) {
            return Some(kind.into());
        }
        let (kind, bodies) = name.rsplit_once('-')?;
        let bodies = bodies.parse().ok().filter(|bodies| *bodies > 0)?;
        Some(Self::of(SceneKind::from_name(kind)?, bodies))
    }
}

impl From<SceneKind> for Case {
    fn from(kind: SceneKind) -> Self {
        Self { kind, bodies: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back_to_their_cases() {
        for case in Case::all().chain(Case::large()) {
            assert_eq!(Case::from_name(&case.name()), Some(case));
        }
        let large = Case::of(SceneKind::MixedOneAndAHalf, 8_000);
        assert_eq!(large.name(), "mixed-1.5-8000");
        // The number of a scene's name is not one of bodies.
        assert_eq!(
            Case::from_name("mixed-8"),
            Some(SceneKind::MixedEight.into())
        );
        for name in ["8000", "pyramid-", "pyramid-0", "nowhere-8000"] {
            assert_eq!(Case::from_name(name), None, "{name}");
        }
    }
}
