//! All overlapping pairs of n boxes of one size, by every library that can find them.
//!
//! The boxes drift on by a frame between any two measurements. Contenders take turns of some frames each, in
//! one order and then in the other, so that none is always first, and each finds its own memory in the caches.

mod broccoli;
mod cgal;
mod contender;
mod ours;
mod rstar;
mod zelll;

#[path = "kernels"]
mod parry2 {
    //! Parry's tree in two dimensions.
    use parry2d as parry;

    #[path = "parry.rs"]
    mod tree;
    pub(super) use tree::families;
}

#[path = "kernels"]
mod parry3 {
    //! Parry's tree in three dimensions.
    use parry3d as parry;

    #[path = "parry.rs"]
    mod tree;
    pub(super) use tree::families;
}

use crate::pair_set;
use anyhow::{Context, Result};
use contender::{Contender, Family, Frame};
use unisize_report::{Report, progress_bar};
use unisize_scenes::DriftingBoxes;

/// How long one number of boxes is measured.
struct Effort {
    count: usize,
    /// Frames for each setting of a library, to find the best one.
    trial_frames: usize,
    rounds: usize,
    frames_a_round: usize,
}

const EFFORTS: [Effort; 4] = [
    effort(1 << 10, 20, 5, 80),
    effort(1 << 14, 10, 5, 16),
    effort(1 << 17, 5, 5, 6),
    effort(1 << 20, 1, 5, 2),
];

/// Beyond this, a case in 3D takes more than a minute, and only the higher density is measured.
const SPARSE_MAX_COUNT_3D: usize = 1 << 17;

const QUICK_EFFORTS: [Effort; 2] = [effort(1 << 10, 5, 3, 10), effort(1 << 14, 3, 3, 3)];

const fn effort(count: usize, trial_frames: usize, rounds: usize, frames_a_round: usize) -> Effort {
    Effort {
        count,
        trial_frames,
        rounds,
        frames_a_round,
    }
}

/// Measures every library in two and three dimensions.
pub(crate) fn measure(quick: bool, report: &mut Report) -> Result<()> {
    measure_in(&families_2d(), [0.8, 0.2], quick, report)?;
    measure_in(&families_3d(), [0.4, 0.1], quick, report)
}

fn measure_in<const D: usize>(
    families: &[Family<D>],
    [dense, sparse]: [f64; 2],
    quick: bool,
    report: &mut Report,
) -> Result<()> {
    let efforts = if quick { &QUICK_EFFORTS[..] } else { &EFFORTS };
    let mut cases: Vec<_> = efforts.iter().map(|effort| (dense, effort)).collect();
    if !quick {
        let is_quick_enough = |effort: &&Effort| D == 2 || effort.count <= SPARSE_MAX_COUNT_3D;
        let sparse_efforts = efforts.iter().filter(is_quick_enough);
        cases.extend(sparse_efforts.map(|effort| (sparse, effort)));
    }
    let bar = progress_bar(cases.len() as u64);
    for (density, effort) in cases {
        let case = format!("kernels, {D}D, density {density}, n = {}", effort.count);
        bar.set_message(case.clone());
        let contenders = contend(families, density, effort).context(case)?;
        for contender in &contenders {
            bar.suspend(|| contender.report(density, &contenders[0], report))?;
        }
        bar.inc(1);
    }
    Ok(())
}

/// Every library in two dimensions, that of this repository first.
fn families_2d() -> Vec<Family<2>> {
    let mut families = ours::families(usize::MAX);
    families.extend(cgal::families());
    families.extend(parry2::families());
    families.push(broccoli::family());
    families.extend(others());
    families
}

/// Every library in three dimensions, that of this repository first.
fn families_3d() -> Vec<Family<3>> {
    let mut families = ours::families(1 << 17);
    families.extend(cgal::families());
    families.extend(parry3::families());
    families.extend(others());
    families
}

/// Those that are the same in every dimension.
fn others<const D: usize>() -> Vec<Family<D>>
where
    [f32; D]: ::rstar::Point<Scalar = f32>,
{
    vec![rstar::family(), zelll::family()]
}

fn contend<'a, const D: usize>(
    families: &'a [Family<D>],
    density: f64,
    effort: &Effort,
) -> Result<Vec<Contender<'a, D>>> {
    let boxes = DriftingBoxes::new(effort.count, density, 7);
    let mut frame = Frame::default();
    frame.show(&boxes);
    let expected = pair_set::of_boxes(&frame.boxes)?;

    let mut contenders = Vec::new();
    for family in families {
        if effort.count <= family.max_count {
            let trial_frames = effort.trial_frames;
            let best = Contender::best_of(family, &boxes, &expected, trial_frames, &mut frame)?;
            contenders.push(best);
        }
    }
    for round in 0..effort.rounds {
        let run =
            |contender: &mut Contender<'_, D>| contender.run(effort.frames_a_round, &mut frame);
        if round % 2 == 0 {
            contenders.iter_mut().try_for_each(run)?;
        } else {
            contenders.iter_mut().rev().try_for_each(run)?;
        }
    }
    for contender in &contenders {
        contender.check_last(&mut frame)?;
    }
    Ok(contenders)
}
