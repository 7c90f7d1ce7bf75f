//! A scene on stage: it is stepped, timed, and drawn.

use super::rapier::math::DIM;
use super::rapier::prelude::*;
use super::show::{HeldPairs, Show};
use super::watched::Watched;
use crate::choice::Choice;
use crate::history::Sample;
use crate::lines::{Extent, Line, pair_line};
use crate::setup::Setup;
use crate::stage::{Fact, Stage};
use std::time::{Duration, Instant};
use unisize_pictures::{Camera, Drawing, thousands};

/// A scene with its broad phases.
pub(crate) struct Live<S> {
    show: S,
    watched: Watched,
    choice: Choice,
    steps: usize,
}

impl<S: Show> Live<S> {
    pub(crate) fn new(bodies: usize, setup: &Setup) -> Self {
        Self {
            show: S::build(bodies),
            watched: Watched::new(setup, S::CONTACTS),
            choice: setup.choice,
            steps: 0,
        }
    }
}

impl<S: Show> Stage for Live<S> {
    fn step(&mut self) -> Sample {
        self.steps += 1;
        self.show.prepare(self.steps, &self.watched);
        let before = self.watched.clock();
        let start = Instant::now();
        self.show.world().step(&mut self.watched, &(), &());
        let elapsed = start.elapsed();
        let after = self.watched.clock();
        let broad_phase = |before: Option<Duration>, after: Option<Duration>| {
            Some(after?.saturating_sub(before?).as_secs_f64() * 1e3)
        };
        let watched = after.all.saturating_sub(before.all);
        Sample {
            unisize: broad_phase(before.unisize, after.unisize),
            default: broad_phase(before.default, after.default),
            rest: elapsed.saturating_sub(watched).as_secs_f64() * 1e3,
        }
    }

    fn steps(&self) -> usize {
        self.steps
    }

    fn length(&self) -> usize {
        S::STEPS
    }

    fn change(&mut self, setup: &Setup) {
        self.watched.succeeded_by(setup);
        self.choice = setup.choice;
        list_all(&mut self.show.world().colliders);
    }

    fn camera(&self) -> Camera {
        self.show.camera()
    }

    fn draw(&self, drawing: &mut Drawing) {
        self.show.draw(drawing, &self.watched);
    }

    fn extents(&mut self) -> Vec<Extent> {
        let colliders = self.show.world().colliders.iter();
        colliders.map(|(_, collider)| extent(collider)).collect()
    }

    fn pair_lines(&mut self) -> Vec<Line> {
        let pairs = self.watched.pairs();
        let colliders = &self.show.world().colliders;
        let ends = |pair: ColliderPair| {
            let first = colliders.get(pair.collider1)?;
            let second = colliders.get(pair.collider2)?;
            // Pairs of walls are of no interest.
            let moves = first.parent().is_some() || second.parent().is_some();
            moves.then(|| pair_line(&extent(first), &extent(second)))
        };
        pairs.into_iter().filter_map(ends).collect()
    }

    fn strips(&self) -> [u32; 2] {
        let stats = self.watched.stats();
        let [rows, columns] = stats.map_or([0; 2], |stats| stats.strips);
        if DIM == 2 { [rows, 0] } else { [rows, columns] }
    }

    fn facts(&self) -> Vec<Fact> {
        let mut facts = vec![
            Fact::new("bodies", thousands(self.show.bodies()), "that move"),
            Fact::new("steps", thousands(self.steps), "so far, 60 per second"),
        ];
        if let Some(stats) = self.watched.stats() {
            let strips = match self.strips() {
                [0, _] => "none".to_owned(),
                [rows, 0] => rows.to_string(),
                [rows, columns] => format!("{rows} × {columns}"),
            };
            let searches = thousands(stats.full_runs as usize);
            let updates = thousands(stats.updates as usize);
            facts.extend([
                Fact::new("pairs", thousands(stats.pairs), "of boxes that overlap"),
                Fact::new(
                    "candidates",
                    thousands(stats.candidates),
                    "pairs that are held or may soon be",
                ),
                Fact::new(
                    "boxes moved",
                    format!("{} of {}", thousands(stats.moved), thousands(stats.listed)),
                    "colliders whose box changed in the last update, of those listed to it",
                ),
                Fact::new(
                    "pairs added, ended",
                    format!("{}, {}", thousands(stats.added), thousands(stats.deleted)),
                    "by the last update",
                ),
                Fact::new(
                    "above the base",
                    thousands(stats.above_base),
                    "boxes that are new, gone, or outside their fat box since the last search for all pairs",
                ),
                Fact::new(
                    "foresight",
                    match stats.foresight {
                        1 => "1 move".to_owned(),
                        moves => format!("{moves} moves"),
                    },
                    "the number of moves for which a search serves",
                ),
                Fact::new(
                    "full searches",
                    format!("{searches} in {updates} updates"),
                    "searches for all pairs; the other updates needed none",
                ),
                Fact::new(
                    "classes of sizes",
                    stats.classes.to_string(),
                    "each with a grid of its own",
                ),
                Fact::new(
                    "strips",
                    strips,
                    "of the grid of the smallest boxes, along the second and the third axis",
                ),
            ]);
        }
        if let Some(pairs) = self.watched.default_pair_count() {
            facts.push(Fact::new(
                "pairs of the default",
                thousands(pairs),
                "of boxes that overlap, by Rapier's own broad phase",
            ));
        }
        facts
    }

    fn agree(&self) -> Option<bool> {
        self.watched.agree()
    }
}

/// Lists all colliders for the next step, because a new broad phase knows none. Setting a collider's position lists it, even if
/// the position is the same.
pub(super) fn list_all(colliders: &mut ColliderSet) {
    for (_, collider) in colliders.iter_mut() {
        collider.set_position(*collider.position());
    }
}

/// The box of a collider, the third axis being 0 in the plane.
fn extent(collider: &Collider) -> Extent {
    let aabb = collider.compute_aabb();
    let mut extent = Extent::default();
    for axis in 0..DIM {
        extent.mins[axis] = aabb.mins[axis] as f32;
        extent.maxs[axis] = aabb.maxs[axis] as f32;
    }
    extent
}
