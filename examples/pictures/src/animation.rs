//! Frames as a GIF file that loops.
//!
//! All frames share one palette, made from all of them. Each frame after the first stores only the pixels that differ
//! from what is already shown, up to a tolerance: small changes of shadows would make up much of the file.

use crate::Picture;
use anyhow::{Result, ensure};
use color_quant::NeuQuant;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use std::borrow::Cow;
use std::collections::HashMap;
use std::io::Write;

/// Between two frames, in hundredths of a second.
const DELAY: u16 = 5;

/// How much longer the last frame stays, and in how many frames it fades into the first.
const HOLD: u16 = 80;
const FADE: usize = 5;

/// The transparent index: the last one.
const TRANSPARENT: u8 = 255;

/// About how many pixels the palette is made from.
const SAMPLES: usize = 400_000;

/// Frames of one size, to be written as a looping GIF file.
#[derive(Clone, Debug)]
pub struct Animation {
    colors: usize,
    tolerance: u8,
    size: [usize; 2],
    /// The bytes of each frame.
    frames: Vec<Vec<u8>>,
}

impl Animation {
    /// An animation of 20 frames per second, with a palette of this many colours, 16 to 255. A pixel keeps its colour until a
    /// channel changes by more than `tolerance`, of 255 (normal range: 0 to 20), and takes that of its left neighbour if that is
    /// within half of it.
    pub fn new(colors: usize, tolerance: u8) -> Self {
        Self {
            colors: colors.clamp(16, TRANSPARENT as usize),
            tolerance,
            size: [0; 2],
            frames: Vec::new(),
        }
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// If it differs in size from those before it.
    pub fn push(&mut self, frame: &Picture) -> Result<()> {
        if self.frames.is_empty() {
            self.size = frame.size();
        }
        ensure!(frame.size() == self.size, "frames differ in size");
        self.frames.push(frame.bytes());
        Ok(())
    }

    /// Adds frames in which the last one fades into the first, for a loop without a jump.
    pub fn fade_to_start(&mut self) {
        let (Some(first), Some(last)) = (self.frames.first().cloned(), self.frames.last().cloned())
        else {
            return;
        };
        for frame in 1..=FADE {
            let share = frame as f32 / (FADE + 1) as f32;
            let mix = |(&from, &to): (&u8, &u8)| {
                (f32::from(from) * (1.0 - share) + f32::from(to) * share).round() as u8
            };
            self.frames.push(last.iter().zip(&first).map(mix).collect());
        }
    }

    /// Writes the bytes of a GIF file. **O(pixels of all frames)**.
    ///
    /// # Errors
    /// If there are no frames, or if they cannot be written.
    pub fn write_gif_to(&self, writer: impl Write) -> Result<()> {
        ensure!(
            !self.frames.is_empty(),
            "an animation has at least one frame"
        );
        let [width, height] = self.size.map(|side| side as u16);
        let palette = Palette::of(&self.frames, self.colors);
        let mut encoder = Encoder::new(writer, width, height, &palette.bytes())?;
        encoder.set_repeat(Repeat::Infinite)?;
        // Nothing is shown yet, so every pixel of the first frame is stored.
        let mut shown = vec![TRANSPARENT; self.size[0] * self.size[1]];
        for (index, frame) in self.frames.iter().enumerate() {
            let is_last = index + 1 == self.frames.len();
            let changes = self.changes(&palette, &mut shown, frame);
            encoder
                .write_frame(&self.cropped(&changes, if is_last { DELAY + HOLD } else { DELAY }))?;
        }
        Ok(())
    }

    /// The pixels of a frame that differ from what is shown, which is updated; the others are transparent.
    fn changes(&self, palette: &Palette, shown: &mut [u8], frame: &[u8]) -> Vec<u8> {
        let is_near = |index: u8, bytes: &[u8], tolerance: u8| {
            let Some(color) = palette.colors.get(index as usize) else {
                return false;
            };
            let mut channels = color.iter().zip(bytes);
            channels.all(|(&channel, &other)| channel.abs_diff(other) <= tolerance)
        };
        let wanted = palette.indices(frame);
        let mut changes = vec![TRANSPARENT; wanted.len()];
        for (at, bytes) in frame.chunks_exact(3).enumerate() {
            if wanted[at] == shown[at] || is_near(shown[at], bytes, self.tolerance) {
                continue;
            }
            // Runs of one colour compress well.
            let left = if at % self.size[0] > 0 {
                changes[at - 1]
            } else {
                TRANSPARENT
            };
            let is_run = is_near(left, bytes, self.tolerance / 2);
            shown[at] = if is_run { left } else { wanted[at] };
            changes[at] = shown[at];
        }
        changes
    }

    /// The rectangle of the pixels that are not transparent; a frame has at least one pixel.
    fn cropped(&self, pixels: &[u8], delay: u16) -> Frame<'static> {
        let width = self.size[0];
        let (mut lo, mut hi) = (self.size, [0; 2]);
        for (at, _) in pixels
            .iter()
            .enumerate()
            .filter(|(_, pixel)| **pixel != TRANSPARENT)
        {
            for (axis, place) in [at % width, at / width].into_iter().enumerate() {
                lo[axis] = lo[axis].min(place);
                hi[axis] = hi[axis].max(place + 1);
            }
        }
        if lo[0] >= hi[0] {
            (lo, hi) = ([0; 2], [1; 2]);
        }
        let rows = pixels.chunks_exact(width).take(hi[1]).skip(lo[1]);
        let buffer: Vec<u8> = rows.flat_map(|row| &row[lo[0]..hi[0]]).copied().collect();
        Frame {
            delay,
            dispose: DisposalMethod::Keep,
            transparent: Some(TRANSPARENT),
            left: lo[0] as u16,
            top: lo[1] as u16,
            width: (hi[0] - lo[0]) as u16,
            height: (hi[1] - lo[1]) as u16,
            buffer: Cow::Owned(buffer),
            ..Frame::default()
        }
    }
}

/// The colours of an animation.
struct Palette {
    network: NeuQuant,
    colors: Vec<[u8; 3]>,
}

impl Palette {
    fn of(frames: &[Vec<u8>], colors: usize) -> Self {
        let all = || frames.iter().flat_map(|frame| frame.chunks_exact(3));
        // Odd, so that the samples are not all from a few columns.
        let step = (all().count() / SAMPLES) | 1;
        let samples: Vec<u8> = all()
            .step_by(step)
            .flat_map(|color| [color[0], color[1], color[2], 255])
            .collect();
        let network = NeuQuant::new(3, colors, &samples);
        let map = network.color_map_rgb();
        let colors = map.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
        Self { network, colors }
    }

    /// Red, green and blue of each colour; black for the transparent one.
    fn bytes(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.colors.iter().flatten().copied().collect();
        bytes.resize(3 * (usize::from(TRANSPARENT) + 1), 0);
        bytes
    }

    /// The index of the colour nearest to each pixel. There are at most 255 of them.
    fn indices(&self, frame: &[u8]) -> Vec<u8> {
        let mut known = HashMap::new();
        let mut index = |color: [u8; 3]| {
            let [red, green, blue] = color;
            let find = || self.network.index_of(&[red, green, blue, 255]) as u8;
            *known.entry(color).or_insert_with(find)
        };
        frame
            .chunks_exact(3)
            .map(|c| index([c[0], c[1], c[2]]))
            .collect()
    }
}
