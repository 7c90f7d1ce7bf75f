//! Ropes and particles in Rapier, on its broad phase and on unisize, and the backbone of a protein by all methods.

use crate::method;
use crate::page::Page;
use crate::progress::progress_bar;
use crate::race::{race, unit_boxes};
use crate::table::{Table, count, digits};
use anyhow::{Result, ensure};
use unisize::rapier3d_027::UnisizeBroadPhase;
use unisize_scenes::dim3::{Candidate, Comparison};
use unisize_scenes::{Backbone, SceneKind};

/// Scenes, with their bodies.
const SCENES: [(&str, SceneKind, usize); 4] = [
    ("ropes", SceneKind::Ropes, 2_000),
    ("ropes", SceneKind::Ropes, 8_000),
    ("particles, poured", SceneKind::Hopper, 10_000),
    ("particles, falling", SceneKind::FallingBalls, 20_000),
];
const STEPS: usize = 300;
const QUICK_BODIES: usize = 100;
const QUICK_STEPS: usize = 30;

/// Links of a backbone.
const LINKS: [usize; 3] = [1 << 12, 1 << 15, 1 << 18];
const FRAMES: usize = 5;

pub(super) fn run(page: &Page, quick: bool) -> Result<()> {
    let steps = if quick { QUICK_STEPS } else { STEPS };
    let bar = progress_bar((SCENES.len() * steps) as u64);
    let mut table = Table::new([
        "scene",
        "bodies",
        "contact pairs at the end",
        "same contacts",
        "Rapier's broad phase, ms a step",
        "unisize, ms a step",
        "ratio",
    ]);
    for (name, kind, bodies) in SCENES {
        bar.set_message(name);
        let bodies = if quick { QUICK_BODIES } else { bodies };
        let comparison = Comparison {
            steps,
            contacts_every: 50,
            repeats: 0,
            ..Comparison::new(kind, bodies, 1)
        };
        let candidate = Candidate::new(UnisizeBroadPhase::new)
            .with_pairs(|ours: &UnisizeBroadPhase| ours.pairs().collect());
        let outcome = comparison.run(&candidate, |_| bar.inc(1));
        let difference = outcome.first_difference.as_deref().unwrap_or_default();
        ensure!(outcome.is_equal(), "{name}: {difference}");
        let ms = |total: std::time::Duration| total.as_secs_f64() * 1e3 / outcome.steps as f64;
        table.push([
            name.to_owned(),
            outcome.bodies.to_string(),
            outcome.contacts.at_end.to_string(),
            "yes".to_owned(),
            digits(ms(outcome.timing.default.total)),
            digits(ms(outcome.timing.candidate.total)),
            digits(outcome.ratio()),
        ]);
    }
    bar.finish_and_clear();
    page.put("chains", &table)?;
    backbone(page, quick)
}

fn backbone(page: &Page, quick: bool) -> Result<()> {
    let (links, frames) = if quick {
        (&LINKS[..1], 2)
    } else {
        (&LINKS[..], FRAMES)
    };
    let bar = progress_bar((links.len() * (frames + 1)) as u64);
    bar.set_message("backbone");
    let mut methods = method::all();
    let head = ["links", "pairs"].map(str::to_owned).into_iter();
    let names = methods
        .iter()
        .map(|method| format!("{}, ms", method.name()));
    let mut table = Table::new(head.chain(names));
    for &n in links {
        let mut chain = Backbone::new(n, 7);
        let next = |boxes: &mut Vec<_>| {
            chain.advance();
            unit_boxes(chain.mins(), boxes);
        };
        let outcome = race(&mut methods, frames, next, |_| bar.inc(1))?;
        let mut row = vec![count(n), format!("{:.0}", outcome.mean_pairs())];
        row.extend(outcome.times.iter().map(|times| digits(times.median())));
        table.push(row);
    }
    bar.finish_and_clear();
    page.put("backbone", &table)
}
