//! The pixels of a picture.

use crate::{Color, PictureError};
use glam::Vec3;
use rayon::prelude::*;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// A picture: made by [`Drawing::picture`](crate::Drawing::picture), to be written on and saved.
#[derive(Clone, Debug)]
pub struct Picture {
    size: [usize; 2],
    /// The light of each pixel, row after row from the top.
    pub(crate) pixels: Vec<Vec3>,
}

impl Picture {
    /// The longest side, in pixels.
    pub const MAX_SIDE: usize = 8192;

    /// A black picture.
    pub(crate) fn new(size: [usize; 2]) -> Result<Self, PictureError> {
        let [width, height] = size;
        if size.iter().any(|side| !(1..=Self::MAX_SIDE).contains(side)) {
            return Err(PictureError::Size { width, height });
        }
        Ok(Self {
            size,
            pixels: vec![Vec3::ZERO; width * height],
        })
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

    /// Lays a colour over a pixel, if there is one.
    pub(crate) fn blend(&mut self, column: usize, row: usize, color: Color, opacity: f32) {
        if let Some(index) = self.index(column, row) {
            let pixel = &mut self.pixels[index];
            *pixel = pixel.lerp(color.light(), opacity);
        }
    }

    fn index(&self, column: usize, row: usize) -> Option<usize> {
        let [width, height] = self.size;
        (column < width && row < height).then(|| row * width + column)
    }

    /// Red, green and blue of each pixel, row after row from the top.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let pixels = self.pixels.par_iter();
        pixels
            .flat_map_iter(|&light| Color::from_light(light).0)
            .collect()
    }

    /// Writes it to a PNG file.
    ///
    /// # Errors
    /// [`PictureError::File`] or [`PictureError::Png`] if it cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<(), PictureError> {
        let at_path = |source| PictureError::File {
            path: path.to_owned(),
            source,
        };
        let mut file = BufWriter::new(File::create(path).map_err(at_path)?);
        self.write_png_to(&mut file)?;
        file.flush().map_err(at_path)
    }

    /// Writes it as a PNG file.
    ///
    /// # Errors
    /// [`PictureError::Png`] if it cannot be written.
    pub fn write_png_to(&self, writer: impl Write) -> Result<(), PictureError> {
        // Sides are at most `MAX_SIDE`.
        let [width, height] = self.size.map(|side| side as u32);
        let mut encoder = png::Encoder::new(writer, width, height);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.bytes())?;
        writer.finish()?;
        Ok(())
    }

    /// The name of a frame's file: `pour.png` becomes `pour-0007.png`.
    pub fn numbered(path: &Path, number: usize) -> PathBuf {
        let mut name = path.file_stem().unwrap_or_default().to_owned();
        name.push(format!("-{number:04}."));
        name.push(path.extension().unwrap_or("png".as_ref()));
        path.with_file_name(name)
    }
}
