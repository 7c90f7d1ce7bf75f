//! The pixels of a picture, and a legend on them.

use crate::{Color, palette};
use anyhow::{Context, Result, ensure};
use glam::Vec3;
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};
use std::fmt::Display;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// The longest side, in pixels.
const MAX_SIDE: usize = 8192;

/// Letters, and the distance between two lines of them.
const HEIGHT: RasterHeight = RasterHeight::Size16;
const PITCH: usize = 20;
const MARGIN: usize = 12;

/// The opacity of the panel of a legend, and the radius of its corners.
const OPACITY: f32 = 0.86;
const ROUND: f32 = 6.0;

/// The least width of a value in letters, so that the panel keeps its width while values grow.
const VALUE: usize = 9;

/// A picture: made by [`Drawing::picture`](crate::Drawing::picture), to be written on and saved.
#[derive(Clone, Debug)]
pub struct Picture {
    size: [usize; 2],
    /// The light of each pixel, row after row from the top.
    pixels: Vec<Vec3>,
}

/// A panel in the upper left corner of a [`Picture`]: a title, and figures beneath it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Legend {
    title: String,
    facts: Vec<(String, String)>,
}

impl Legend {
    /// A legend with a title only.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            facts: Vec::new(),
        }
    }

    /// With one more line: a name and its value.
    pub fn fact(mut self, name: impl Into<String>, value: impl Display) -> Self {
        self.facts.push((name.into(), value.to_string()));
        self
    }
}

impl Picture {
    /// A picture of this light.
    pub(crate) fn new(size: [usize; 2], pixels: Vec<Vec3>) -> Self {
        Self { size, pixels }
    }

    /// Whether a picture can have this size.
    pub(crate) fn check_size([width, height]: [usize; 2]) -> Result<()> {
        let can_be = |side| (1..=MAX_SIDE).contains(&side);
        let is_possible = can_be(width) && can_be(height);
        ensure!(
            is_possible,
            "a picture cannot be {width} by {height} pixels: a side has 1 to {MAX_SIDE}"
        );
        Ok(())
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The colour of a pixel, counted from the upper left corner; `None` outside.
    pub fn pixel(&self, column: usize, row: usize) -> Option<Color> {
        let index = self.index(column, row)?;
        Some(Color::from_light(self.pixels[index]))
    }

    fn index(&self, column: usize, row: usize) -> Option<usize> {
        let [width, height] = self.size;
        (column < width && row < height).then(|| row * width + column)
    }

    /// Red, green and blue of each pixel, row after row from the top.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let colors = self.pixels.iter().map(|&light| Color::from_light(light));
        colors.flat_map(|color| color.0).collect()
    }

    /// Writes it to a PNG file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<()> {
        let cannot = || format!("cannot write {}", path.display());
        let file = BufWriter::new(File::create(path).with_context(cannot)?);
        let [width, height] = self.size.map(|side| side as u32);
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().with_context(cannot)?;
        writer
            .write_image_data(&self.bytes())
            .with_context(cannot)?;
        writer.finish().with_context(cannot)
    }

    /// The name of a frame's file: `pour.png` becomes `pour-0007.png`.
    pub fn numbered(path: &Path, number: usize) -> PathBuf {
        let mut name = path.file_stem().unwrap_or_default().to_owned();
        name.push(format!("-{number:04}."));
        name.push(path.extension().unwrap_or("png".as_ref()));
        path.with_file_name(name)
    }

    /// Lays a legend over the upper left corner.
    pub fn legend(&mut self, legend: &Legend) {
        let letter = get_raster_width(FontWeight::Regular, HEIGHT);
        let count = |text: &str| text.chars().count();
        let width = |(name, value): &(String, String)| count(name) + 2 + count(value).max(VALUE);
        let widest = legend.facts.iter().map(width).max().unwrap_or_default();
        let letters = widest.max(count(&legend.title));
        let height = legend.facts.len() * PITCH + HEIGHT.val() + 3 * MARGIN / 2;
        self.panel([letters * letter + 2 * MARGIN, height]);

        let [left, mut top] = [2 * MARGIN, MARGIN + 3 * MARGIN / 4];
        self.text([left, top], &legend.title, FontWeight::Bold, palette::TEXT);
        for (name, value) in &legend.facts {
            top += PITCH;
            self.text([left, top], name, FontWeight::Regular, palette::FAINT);
            let indent = letters.saturating_sub(count(value)) * letter;
            self.text(
                [left + indent, top],
                value,
                FontWeight::Regular,
                palette::TEXT,
            );
        }
    }

    /// Darkens a rectangle with round corners.
    fn panel(&mut self, size: [usize; 2]) {
        let half = size.map(|side| side as f32 / 2.0);
        for row in 0..size[1] {
            for column in 0..size[0] {
                // How far outside of the rectangle between the corners' centres.
                let [x, y] = [(column, half[0]), (row, half[1])].map(|(place, half)| {
                    ((place as f32 + 0.5 - half).abs() - (half - ROUND)).max(0.0)
                });
                let coverage = (ROUND + 0.5 - x.hypot(y)).clamp(0.0, 1.0);
                let place = [MARGIN + column, MARGIN + row];
                self.blend(place, palette::PANEL, OPACITY * coverage);
            }
        }
    }

    /// Writes a line of text whose upper left corner is at this pixel. What reaches over the edge is cut off; letters
    /// beyond ASCII become question marks.
    fn text(&mut self, [left, top]: [usize; 2], text: &str, weight: FontWeight, color: Color) {
        let advance = get_raster_width(weight, HEIGHT);
        for (index, letter) in text.chars().enumerate() {
            let raster = |letter| get_raster(letter, weight, HEIGHT);
            let letter = raster(letter).or_else(|| raster('?'));
            let rows = letter
                .iter()
                .flat_map(|letter| letter.raster().iter().enumerate());
            for (row, shares) in rows {
                for (column, &share) in shares.iter().enumerate() {
                    let place = [left + index * advance + column, top + row];
                    self.blend(place, color, f32::from(share) / 255.0);
                }
            }
        }
    }

    /// Lays a colour over a pixel, if there is one.
    fn blend(&mut self, [column, row]: [usize; 2], color: Color, opacity: f32) {
        if let Some(index) = self.index(column, row) {
            let pixel = &mut self.pixels[index];
            *pixel = pixel.lerp(color.light(), opacity);
        }
    }
}

/// A number with commas between thousands.
pub fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
