//! Frames as a GIF file that loops.
//!
//! All frames share one palette, made from all of them. Each frame after the first stores only the pixels that differ
//! from what is already shown, up to a tolerance.

use crate::{Picture, PictureError};
use color_quant::NeuQuant;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

/// The transparent index: the last one.
const TRANSPARENT: u8 = 255;

/// The least and the most colours there may be beside it.
const COLORS: [usize; 2] = [16, TRANSPARENT as usize];

/// About how many pixels the palette is made from.
const SAMPLES: usize = 400_000;

/// Frames of one size, to be written as a looping GIF file.
#[derive(Clone, Debug)]
pub struct Animation {
    frames_per_second: u32,
    colors: usize,
    tolerance: u8,
    hold: f32,
    size: [usize; 2],
    /// The bytes of each frame.
    frames: Vec<Vec<u8>>,
}

impl Animation {
    /// An animation at this speed. The format has delays in hundredths of a second, so 50, 33, 25, 20, ... are exact or nearly
    /// so, and 50 is the most.
    pub fn new(frames_per_second: u32) -> Self {
        Self {
            frames_per_second,
            colors: COLORS[1],
            tolerance: 6,
            hold: 0.0,
            size: [0; 2],
            frames: Vec::new(),
        }
    }

    /// With a palette of at most this many colours, 16 to 255. Default: 255. Fewer colours make smaller files.
    pub fn colors(mut self, colors: usize) -> Self {
        self.colors = colors.clamp(COLORS[0], COLORS[1]);
        self
    }

    /// A pixel keeps its colour until a channel changes by more than this, of 255, and takes that of its left neighbour if
    /// that is within half of it. Default: 6; normal range: 0 to 20. Small changes of shadows make up much of a file.
    pub fn tolerance(mut self, tolerance: u8) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Shows the last frame this many seconds longer. Default: 0.
    pub fn hold(mut self, seconds: f32) -> Self {
        self.hold = seconds;
        self
    }

    /// The number of frames.
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Whether there are no frames.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// [`PictureError::FrameSize`] if it differs in size from those before it.
    pub fn push(&mut self, frame: Picture) -> Result<(), PictureError> {
        if self.frames.is_empty() {
            self.size = frame.size();
        } else if frame.size() != self.size {
            return Err(PictureError::FrameSize {
                frame: frame.size(),
                animation: self.size,
            });
        }
        self.frames.push(frame.bytes());
        Ok(())
    }

    /// Adds this many frames in which the last one fades into the first, for a loop without a jump.
    pub fn fade_to_start(&mut self, frames: usize) {
        let (Some(first), Some(last)) = (self.frames.first().cloned(), self.frames.last().cloned())
        else {
            return;
        };
        for frame in 1..=frames {
            let share = frame as f32 / (frames + 1) as f32;
            let mix = |(&from, &to): (&u8, &u8)| {
                (f32::from(from) * (1.0 - share) + f32::from(to) * share).round() as u8
            };
            let faded = last.iter().zip(&first).map(mix).collect();
            self.frames.push(faded);
        }
    }

    /// Writes a GIF file.
    ///
    /// # Errors
    /// As [`write_gif_to`](Self::write_gif_to), or [`PictureError::File`] if the file cannot be written.
    pub fn write_gif(&self, path: &Path) -> Result<(), PictureError> {
        let at_path = |source| PictureError::File {
            path: path.to_owned(),
            source,
        };
        let mut file = BufWriter::new(File::create(path).map_err(at_path)?);
        self.write_gif_to(&mut file)?;
        file.flush().map_err(at_path)
    }

    /// Writes the bytes of a GIF file. **O(pixels of all frames)**.
    ///
    /// # Errors
    /// [`PictureError::NoFrames`] if there are none, [`PictureError::Gif`] if they cannot be written.
    pub fn write_gif_to(&self, writer: impl Write) -> Result<(), PictureError> {
        if self.frames.is_empty() {
            return Err(PictureError::NoFrames);
        }
        // Sides are at most `Picture::MAX_SIDE`.
        let [width, height] = self.size.map(|side| side as u16);
        let palette = Palette::of(&self.frames, self.colors);
        let mut encoder = Encoder::new(writer, width, height, &palette.bytes())?;
        encoder.set_repeat(Repeat::Infinite)?;
        let mut shown: Option<Vec<u8>> = None;
        for (index, frame) in self.frames.iter().enumerate() {
            let wanted = palette.indices(frame);
            let (area, pixels) = match &mut shown {
                None => {
                    shown = Some(wanted.clone());
                    ([0, 0, self.size[0], self.size[1]], wanted)
                }
                Some(shown) => self.difference(&palette, shown, frame, &wanted),
            };
            let [left, top, width, height] = area.map(|place| place as u16);
            encoder.write_frame(&Frame {
                delay: self.delay(index),
                dispose: DisposalMethod::Keep,
                transparent: Some(TRANSPARENT),
                left,
                top,
                width,
                height,
                buffer: Cow::Owned(pixels),
                ..Frame::default()
            })?;
        }
        Ok(())
    }

    /// In hundredths of a second.
    fn delay(&self, frame: usize) -> u16 {
        let delay = (100.0 / self.frames_per_second.max(1) as f32)
            .round()
            .max(2.0);
        let hold = if frame + 1 == self.frames.len() {
            100.0 * self.hold.max(0.0)
        } else {
            0.0
        };
        // Saturates.
        (delay + hold) as u16
    }

    /// Whether two colours are the same within this tolerance.
    fn is_near(color: [u8; 3], other: &[u8], tolerance: u8) -> bool {
        let mut channels = color.iter().zip(other);
        channels.all(|(&channel, &other)| channel.abs_diff(other) <= tolerance)
    }

    /// The part of a frame that differs from what is shown, which is updated: the area as left, top, width and height, and
    /// its pixels.
    fn difference(
        &self,
        palette: &Palette,
        shown: &mut [u8],
        frame: &[u8],
        wanted: &[u8],
    ) -> ([usize; 4], Vec<u8>) {
        let width = self.size[0];
        let mut changes = vec![TRANSPARENT; wanted.len()];
        let (mut lo, mut hi) = ([usize::MAX; 2], [0; 2]);
        for (index, bytes) in frame.chunks_exact(3).enumerate() {
            let before = palette.colors[shown[index] as usize];
            if wanted[index] == shown[index] || Self::is_near(before, bytes, self.tolerance) {
                continue;
            }
            let mut new = wanted[index];
            // Runs of one colour compress well.
            if index % width > 0 && changes[index - 1] != TRANSPARENT {
                let left = changes[index - 1];
                if Self::is_near(palette.colors[left as usize], bytes, self.tolerance / 2) {
                    new = left;
                }
            }
            shown[index] = new;
            changes[index] = new;
            for (axis, place) in [index % width, index / width].into_iter().enumerate() {
                lo[axis] = lo[axis].min(place);
                hi[axis] = hi[axis].max(place + 1);
            }
        }
        if lo[0] >= hi[0] {
            // A frame has at least one pixel.
            return ([0, 0, 1, 1], vec![TRANSPARENT]);
        }
        let rows = changes.chunks_exact(width).take(hi[1]).skip(lo[1]);
        let pixels = rows.flat_map(|row| &row[lo[0]..hi[0]]).copied().collect();
        ([lo[0], lo[1], hi[0] - lo[0], hi[1] - lo[1]], pixels)
    }
}

/// The colours of an animation.
struct Palette {
    colors: Vec<[u8; 3]>,
    /// Picks the nearest of them, unless the frames have no other colours.
    network: Option<NeuQuant>,
}

impl Palette {
    fn of(frames: &[Vec<u8>], colors: usize) -> Self {
        let all = || frames.iter().flat_map(|frame| frame.chunks_exact(3));
        let mut few = BTreeSet::new();
        for color in all() {
            few.insert([color[0], color[1], color[2]]);
            if few.len() > colors {
                return Self::learnt(all(), colors);
            }
        }
        Self {
            colors: few.into_iter().collect(),
            network: None,
        }
    }

    fn learnt<'a>(all: impl Iterator<Item = &'a [u8]> + Clone, colors: usize) -> Self {
        let pixels = all.clone().count();
        // A prime number, so that the samples are not all from a few columns.
        let step = [
            1, 2, 3, 5, 7, 11, 17, 29, 53, 101, 211, 401, 809, 1601, 3203, 6397,
        ]
        .into_iter()
        .find(|step| pixels / step <= SAMPLES)
        .unwrap_or(12799);
        let samples: Vec<u8> = all
            .step_by(step)
            .flat_map(|color| [color[0], color[1], color[2], 255])
            .collect();
        let network = NeuQuant::new(3, colors, &samples);
        let colors = network.color_map_rgb();
        let colors = colors.chunks_exact(3);
        Self {
            colors: colors.map(|color| [color[0], color[1], color[2]]).collect(),
            network: Some(network),
        }
    }

    /// Red, green and blue of each colour; black for the transparent one.
    fn bytes(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.colors.iter().flatten().copied().collect();
        bytes.resize(3 * (usize::from(TRANSPARENT) + 1), 0);
        bytes
    }

    /// The index of the colour nearest to each pixel.
    fn indices(&self, frame: &[u8]) -> Vec<u8> {
        let mut known = HashMap::new();
        frame
            .chunks_exact(3)
            .map(|color| {
                let color = [color[0], color[1], color[2]];
                *known.entry(color).or_insert_with(|| self.index(color))
            })
            .collect()
    }

    fn index(&self, color: [u8; 3]) -> u8 {
        let [red, green, blue] = color;
        let index = match &self.network {
            Some(network) => network.index_of(&[red, green, blue, 255]),
            None => self.colors.binary_search(&color).unwrap_or(0),
        };
        // There are at most 255 of them.
        index as u8
    }
}
