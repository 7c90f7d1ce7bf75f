//! One scene at each level, in turns.

use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::{Scene, Steppable, install};
use super::sieve::Sieve;
use crate::levels::{Figures, Level, STEPS, WARM_UP};
use std::time::Instant;
use unisize_scenes::SceneKind;

/// The figures of each level.
pub(crate) fn race(kind: SceneKind, bodies: usize, levels: &[Level]) -> Vec<Figures> {
    let mut racers: Vec<_> = levels
        .iter()
        .map(|level| {
            let settings = Settings::default().with_filter(level.filter);
            let sieve = Sieve::new(UnisizeBroadPhase::with_settings(settings), level.test);
            (
                Scene::build(kind, bodies, 1),
                install(sieve),
                Figures::default(),
            )
        })
        .collect();
    for step in 0..STEPS {
        // Another one goes first in each step.
        racers.rotate_left(1);
        for (scene, broad_phase, figures) in &mut racers {
            scene.prepare();
            let start = Instant::now();
            scene.world.step(broad_phase.for_step(), &(), &());
            let whole = start.elapsed() - broad_phase.spent;
            if step < WARM_UP {
                continue;
            }
            let broad = broad_phase.inner.timing().last;
            let pairs = scene.world.narrow_phase.contact_pairs();
            for pair in pairs {
                figures.pairs += 1;
                figures.contacts += usize::from(pair.has_any_active_contact());
            }
            figures.broad += broad;
            figures.rest += whole.saturating_sub(broad);
        }
    }
    racers.rotate_right(STEPS % levels.len());
    racers.into_iter().map(|(.., figures)| figures).collect()
}
