//! One library in one case: its best setting is searched for, then measured.

use crate::pair_set;
use crate::times::Times;
use anyhow::{Result, bail};
use std::hint::black_box;
use std::io;
use std::time::{Duration, Instant};
use unisize::Aabb;
use unisize_report::Report;
use unisize_scenes::DriftingBoxes;

/// The boxes of one moment. Whatever else a kernel needs is built from this, as a part of its time.
#[derive(Default)]
pub(crate) struct Frame<const D: usize> {
    /// For unisize.
    pub(crate) boxes: Vec<Aabb<f32, D>>,
    /// For all others, the same: the least coordinates of each box, then the greatest.
    pub(crate) corners: Vec<[[f32; D]; 2]>,
}

impl<const D: usize> Frame<D> {
    /// Shows the boxes as they are now.
    pub(crate) fn show(&mut self, drifting: &DriftingBoxes<D>) {
        let corners = |mins: &[f32; D]| [*mins, mins.map(|x| x + DriftingBoxes::<D>::SIZE)];
        self.corners.clear();
        self.corners.extend(drifting.mins().iter().map(corners));
        self.boxes.clear();
        let aabb = |&[mins, maxs]: &[[f32; D]; 2]| Aabb::new(mins, maxs);
        self.boxes.extend(self.corners.iter().map(aabb));
    }
}

/// Something that finds all overlapping pairs of boxes.
pub(crate) trait Kernel<const D: usize> {
    /// Finds the pairs of these boxes, and keeps them as a list: all of this is timed.
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()>;

    /// The pairs found, each once, in any order.
    fn pairs(&self) -> &[[u32; 2]];
}

/// A kernel that puts the pairs into an empty list.
struct Listing<F> {
    find: F,
    pairs: Vec<[u32; 2]>,
}

impl<F, const D: usize> Kernel<D> for Listing<F>
where
    F: FnMut(&Frame<D>, &mut Vec<[u32; 2]>) -> Result<()>,
{
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        self.pairs.clear();
        (self.find)(frame, &mut self.pairs)
    }

    fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }
}

/// A way to set a kernel up. It has no name if there is no other.
pub(crate) struct Setting<const D: usize> {
    pub(crate) name: String,
    pub(crate) create: Box<dyn Fn() -> Result<Box<dyn Kernel<D>>>>,
}

impl<const D: usize> Setting<D> {
    pub(crate) fn new<K: Kernel<D> + 'static>(
        name: impl ToString,
        create: impl Fn() -> Result<K> + 'static,
    ) -> Self {
        Self {
            name: name.to_string(),
            create: Box::new(move || Ok(Box::new(create()?))),
        }
    }

    /// For a kernel that is no more than a function.
    pub(crate) fn listing<F>(name: impl ToString, create: impl Fn() -> F + 'static) -> Self
    where
        F: FnMut(&Frame<D>, &mut Vec<[u32; 2]>) -> Result<()> + 'static,
    {
        Self::new(name, move || {
            let (find, pairs) = (create(), Vec::new());
            Ok(Listing { find, pairs })
        })
    }
}

/// A library, with all settings worth trying.
pub(crate) struct Family<const D: usize> {
    pub(crate) name: &'static str,
    pub(crate) settings: Vec<Setting<D>>,
    /// With more boxes, a frame takes seconds.
    pub(crate) max_count: usize,
    /// Its frames differ, and only so many together tell its time.
    pub(crate) least_frames: usize,
}

impl<const D: usize> Family<D> {
    pub(crate) fn new(name: &'static str, settings: impl IntoIterator<Item = Setting<D>>) -> Self {
        Self {
            name,
            settings: settings.into_iter().collect(),
            max_count: usize::MAX,
            least_frames: 1,
        }
    }
}

/// A setting is tried no longer if its first frame takes so much more than the best setting's frames.
const HOPELESS: f64 = 3.0;

/// Milliseconds of a first frame below which a setting is tried in any case: allocation may be most of it.
const WORTH_TRYING_MS: f64 = 50.0;

/// A family at its best setting, with boxes of its own that drift on, the same for all contenders.
pub(crate) struct Contender<'a, const D: usize> {
    family: &'a Family<D>,
    setting: &'a str,
    kernel: Box<dyn Kernel<D>>,
    boxes: DriftingBoxes<D>,
    times: Times,
}

impl<'a, const D: usize> Contender<'a, D> {
    /// Tries every setting on so many frames, and keeps the one with the best mean. On the first frame,
    /// every one is compared with the oracle.
    pub(crate) fn best_of(
        family: &'a Family<D>,
        boxes: &DriftingBoxes<D>,
        expected: &[[u32; 2]],
        frames: usize,
        frame: &mut Frame<D>,
    ) -> Result<Self> {
        let mut best: Option<Self> = None;
        for setting in &family.settings {
            let mut contender = Self {
                family,
                setting: &setting.name,
                kernel: (setting.create)()?,
                boxes: boxes.clone(),
                times: Times::default(),
            };
            frame.show(&contender.boxes);
            let start = Instant::now();
            contender.kernel.find_pairs(frame)?;
            let first_ms = start.elapsed().as_secs_f64() * 1e3;
            contender.check(expected)?;
            let limit_ms = |best: &Self| (HOPELESS * best.times.typical()).max(WORTH_TRYING_MS);
            let is_hopeless = |best: &Self| first_ms > limit_ms(best);
            if family.least_frames <= 1 && best.as_ref().is_some_and(is_hopeless) {
                continue;
            }
            contender.run(frames, frame)?;
            let is_better = |best: &Self| contender.times.typical() < best.times.typical();
            if best.as_ref().is_none_or(is_better) {
                best = Some(contender);
            }
        }
        let Some(mut best) = best else {
            bail!("{} has no settings", family.name);
        };
        best.times = Times::default();
        Ok(best)
    }

    /// Measures so many frames, or a few more if the family needs them, each after the boxes have drifted on.
    pub(crate) fn run(&mut self, frames: usize, frame: &mut Frame<D>) -> Result<()> {
        let frames = frames.next_multiple_of(self.family.least_frames);
        let mut time = Duration::ZERO;
        for _ in 0..frames {
            self.boxes.advance();
            frame.show(&self.boxes);
            let start = Instant::now();
            self.kernel.find_pairs(black_box(frame))?;
            time += start.elapsed();
            black_box(&self.kernel);
        }
        self.times.push(frames, time);
        Ok(())
    }

    /// Compares the pairs of the last frame with the oracle's.
    pub(crate) fn check_last(&self, frame: &mut Frame<D>) -> Result<()> {
        frame.show(&self.boxes);
        self.check(&pair_set::of_boxes(&frame.boxes)?)
    }

    fn check(&self, expected: &[[u32; 2]]) -> Result<()> {
        let found = pair_set::ordered(self.kernel.pairs());
        if let Some(difference) = pair_set::difference(&found, expected) {
            bail!("{} ({}) found {difference}", self.family.name, self.setting);
        }
        Ok(())
    }

    /// Prints and writes the mean milliseconds of a frame, and the ratio to those of unisize's own in this case: above 1, unisize is faster.
    /// The density is the part of the area or volume that the boxes would fill if they did not overlap.
    pub(crate) fn report(&self, density: f64, ours: &Self, report: &mut Report) -> io::Result<()> {
        let ms = self.times.typical();
        report.row(&[
            ("subject", "kernels".into()),
            ("dim", D.into()),
            ("density", density.into()),
            ("count", self.boxes.mins().len().into()),
            ("contender", self.family.name.into()),
            ("setting", self.setting.into()),
            ("frames", self.times.frames.into()),
            ("typical_ms", ms.into()),
            ("pairs", self.kernel.pairs().len().into()),
            ("ratio", (ms / ours.times.typical()).into()),
        ])
    }
}
