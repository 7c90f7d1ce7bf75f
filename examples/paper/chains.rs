//! Ropes and particles in Rapier, on its own broad phase and on unisize.

use crate::Run;
use anyhow::{Result, ensure};
use unisize::rapier3d_027::UnisizeBroadPhase;
use unisize_scenes::SceneKind;
use unisize_scenes::dim3::{Candidate, Comparison};

/// Scenes, with their bodies.
const SCENES: [(&str, SceneKind, usize); 4] = [
    ("ropes", SceneKind::Ropes, 2_000),
    ("ropes", SceneKind::Ropes, 8_000),
    ("particles, poured", SceneKind::Hopper, 10_000),
    ("particles, falling", SceneKind::FallingBalls, 20_000),
];
const STEPS: usize = 300;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    for (name, kind, bodies) in SCENES {
        let (bodies, steps) = run.choose((bodies / 80, 30), (bodies, STEPS));
        let comparison = Comparison {
            steps,
            contacts_every: 50,
            repeats: 0,
            ..Comparison::new(kind, bodies, 1)
        };
        let candidate = Candidate::new(UnisizeBroadPhase::new)
            .with_pairs(|ours: &UnisizeBroadPhase| ours.pairs().collect());
        let outcome = comparison.run(&candidate, |_| ());
        let difference = outcome.first_difference.as_deref().unwrap_or_default();
        ensure!(outcome.is_equal(), "{name}: {difference}");
        let ms = |total: std::time::Duration| total.as_secs_f64() * 1e3 / outcome.steps as f64;
        let row = format!("{name}, {} bodies", outcome.bodies);
        let mut add = |column: &str, value| run.table.add("chains", &row, column, value);
        add(
            "contact pairs at the end, the same in both",
            outcome.contacts.at_end as f64,
        );
        add(
            "Rapier's broad phase, ms a step",
            ms(outcome.timing.default.total),
        );
        add("unisize, ms a step", ms(outcome.timing.candidate.total));
        add("ratio", outcome.ratio());
    }
    Ok(())
}
