//! All overlapping pairs of n boxes of one size, by every library that can find them.
//!
//! The boxes drift on by a frame between any two measurements. Contenders take turns of some frames each, in
//! one order and then in the other, so that none is always first, and each finds its own memory in the caches.

#[cfg(feature = "box_intersect_ze")]
mod box_intersect_ze;
mod broccoli;
mod cgal;
mod contender;
mod frame;
mod ours;
mod parry2;
mod parry3;
mod rstar;
mod zelll;

use crate::pair_set::PairSet;
use crate::progress::Progress;
use crate::row::{self, Row};
use anyhow::{Context, Result};
use contender::{Contender, Family};
use frame::Frame;
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
    effort(1 << 10, 20, 4, 100),
    effort(1 << 14, 10, 4, 25),
    effort(1 << 17, 5, 4, 6),
    effort(1 << 20, 2, 2, 2),
];

const QUICK_EFFORTS: [Effort; 2] = [effort(1 << 10, 5, 2, 10), effort(1 << 14, 3, 2, 4)];

const fn effort(count: usize, trial_frames: usize, rounds: usize, frames_a_round: usize) -> Effort {
    Effort {
        count,
        trial_frames,
        rounds,
        frames_a_round,
    }
}

/// Measures every library in two and three dimensions.
pub(crate) fn measure(quick: bool, progress: &Progress) -> Result<Vec<Row>> {
    let efforts = if quick { &QUICK_EFFORTS[..] } else { &EFFORTS };
    let densities = if quick { 1 } else { 2 };
    progress.expect(2 * densities * efforts.len());
    let mut rows = Vec::new();
    for density in &[0.8, 0.2][..densities] {
        for effort in efforts {
            rows.extend(measure_case(&families_2d(), *density, effort, progress)?);
        }
    }
    for density in &[0.4, 0.1][..densities] {
        for effort in efforts {
            rows.extend(measure_case(&families_3d(), *density, effort, progress)?);
        }
    }
    Ok(rows)
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
    vec![
        rstar::family(),
        zelll::family(),
        #[cfg(feature = "box_intersect_ze")]
        box_intersect_ze::family(),
    ]
}

fn measure_case<const D: usize>(
    families: &[Family<D>],
    density: f64,
    effort: &Effort,
    progress: &Progress,
) -> Result<Vec<Row>> {
    let case = format!("kernels, {D}D, density {density}, n = {}", effort.count);
    progress.begin(case.clone());
    let rows = contend(families, density, effort).context(case)?;
    progress.end();
    Ok(rows)
}

fn contend<const D: usize>(
    families: &[Family<D>],
    density: f64,
    effort: &Effort,
) -> Result<Vec<Row>> {
    let boxes = DriftingBoxes::new(effort.count, density, 7);
    let mut frame = Frame::new();
    frame.show(&boxes);
    let expected = PairSet::of_boxes(&frame.boxes)?;

    let mut contenders = Vec::new();
    for family in families {
        if effort.count <= family.max_count {
            let trial_frames = effort.trial_frames;
            let best = Contender::best_of(family, &boxes, &expected, trial_frames, &mut frame)?;
            contenders.push(best);
        }
    }
    for round in 0..effort.rounds {
        let run = |contender: &mut Contender<D>| contender.run(effort.frames_a_round, &mut frame);
        if round % 2 == 0 {
            contenders.iter_mut().try_for_each(run)?;
        } else {
            contenders.iter_mut().rev().try_for_each(run)?;
        }
    }
    for contender in &contenders {
        contender.check_last(&mut frame)?;
    }
    let mut rows: Vec<_> = contenders.iter().map(|c| c.row(density)).collect();
    row::set_ratios(&mut rows);
    Ok(rows)
}
