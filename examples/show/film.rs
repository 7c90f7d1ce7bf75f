//! A film of the world, as a GIF or as numbered PNG files.

use super::options::Options;
use super::rivals::Rivals;
use super::{HeldPairs, Show};
use anyhow::{Context, Result, bail};
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;
use unisize_pictures::{Animation, Drawing, Legend, Picture, thousands};

/// Where frames go.
pub(super) struct Film {
    size: [usize; 2],
    filmed_from: usize,
    steps_per_frame: usize,
    format: Format,
}

enum Format {
    Nothing,
    Gif(Animation, BufWriter<File>),
    Pngs(PathBuf, usize),
}

impl Film {
    pub(super) fn new<S: Show>(options: &Options) -> Result<Self> {
        let format = match &options.out {
            None => Format::Nothing,
            Some(path) => match path.extension().and_then(|extension| extension.to_str()) {
                Some("gif") => {
                    // Opened before the long run, which would be lost if this failed.
                    let cannot = || format!("cannot write {}", path.display());
                    let file = BufWriter::new(File::create(path).with_context(cannot)?);
                    Format::Gif(Animation::new(S::COLORS, S::TOLERANCE), file)
                }
                Some("png") => Format::Pngs(path.clone(), 0),
                _ => bail!("{} ends in neither .gif nor .png", path.display()),
            },
        };
        Ok(Self {
            size: options.size(),
            filmed_from: S::FILMED_FROM.min(options.steps::<S>().saturating_sub(1)),
            steps_per_frame: S::STEPS_PER_FRAME,
            format,
        })
    }

    /// Whether the world is drawn after this step.
    pub(super) fn wants(&self, step: usize) -> bool {
        !matches!(self.format, Format::Nothing)
            && step > self.filmed_from
            && (step - self.filmed_from - 1) % self.steps_per_frame == 0
    }

    /// Adds a frame.
    pub(super) fn add(
        &mut self,
        show: &impl Show,
        broad_phase: &Rivals,
        milliseconds: f64,
    ) -> Result<()> {
        let mut drawing = Drawing::new();
        show.draw(&mut drawing, broad_phase);
        let mut picture = drawing.picture(&show.camera(), self.size)?;
        picture.legend(
            &Legend::new(broad_phase.choice.name())
                .fact("bodies", thousands(show.bodies()))
                .fact("pairs", thousands(broad_phase.pairs().len()))
                .fact("broad phase", format!("{milliseconds:.2} ms")),
        );
        match &mut self.format {
            Format::Nothing => Ok(()),
            Format::Gif(animation, _) => animation.push(&picture),
            Format::Pngs(path, number) => {
                *number += 1;
                picture.write_png(&Picture::numbered(path, *number))
            }
        }
    }

    /// Writes the animation, if there is one.
    pub(super) fn finish(self) -> Result<()> {
        if let Format::Gif(mut animation, mut file) = self.format {
            animation.fade_to_start();
            animation.write_gif_to(&mut file)?;
            file.flush()?;
        }
        Ok(())
    }
}
