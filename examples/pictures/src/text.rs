//! Text on a picture, in a font that comes with its crate.

use crate::{Color, Picture};
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

/// How thick letters are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// As usual.
    #[default]
    Regular,
    /// Thick.
    Bold,
}

impl Weight {
    fn of_font(self) -> FontWeight {
        match self {
            Self::Regular => FontWeight::Regular,
            Self::Bold => FontWeight::Bold,
        }
    }
}

/// The height of a line of text on a picture of this height.
fn raster_height(picture_height: usize) -> RasterHeight {
    match picture_height {
        0..600 => RasterHeight::Size16,
        600..900 => RasterHeight::Size20,
        900..1300 => RasterHeight::Size24,
        _ => RasterHeight::Size32,
    }
}

impl Picture {
    /// Width and height of a letter, in pixels. All letters are equally wide; larger pictures have larger ones.
    pub fn letter_size(&self) -> [usize; 2] {
        let height = raster_height(self.size()[1]);
        [get_raster_width(FontWeight::Regular, height), height.val()]
    }

    /// Writes a line of text whose upper left corner is at this pixel. What reaches over the edge is cut off; letters
    /// beyond Latin-1 become question marks.
    pub fn text(&mut self, corner: [usize; 2], text: &str, weight: Weight, color: Color) {
        let height = raster_height(self.size()[1]);
        let advance = self.letter_size()[0];
        let [mut left, top] = corner;
        for letter in text.chars() {
            let letter = get_raster(letter, weight.of_font(), height)
                .or_else(|| get_raster('?', weight.of_font(), height));
            for (row, shares) in letter
                .iter()
                .flat_map(|letter| letter.raster().iter().enumerate())
            {
                for (column, &share) in shares.iter().enumerate() {
                    let (column, row) = (left.saturating_add(column), top.saturating_add(row));
                    self.blend(column, row, color, f32::from(share) / 255.0);
                }
            }
            left = left.saturating_add(advance);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Weight;
    use crate::{Color, Picture};

    /// The pixels that are not black: the first column and row, the last column and row, and how many there are.
    fn inked(picture: &Picture) -> Option<([usize; 4], usize)> {
        let [width, height] = picture.size();
        let places = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
        let inked: Vec<_> = places
            .filter(|&[column, row]| picture.pixel(column, row) != Some(Color([0; 3])))
            .collect();
        let columns = || inked.iter().map(|place| place[0]);
        let rows = || inked.iter().map(|place| place[1]);
        let bounds = [
            columns().min()?,
            rows().min()?,
            columns().max()?,
            rows().max()?,
        ];
        Some((bounds, inked.len()))
    }

    #[test]
    fn text_is_where_it_is_written() {
        let mut picture = Picture::new([100, 60]).unwrap();
        let [width, height] = picture.letter_size();
        picture.text([10, 20], "H4", Weight::Regular, Color([255; 3]));
        let ([left, top, right, bottom], count) = inked(&picture).unwrap();
        assert!(left >= 10 && right < 10 + 2 * width && right > 10 + width);
        assert!(top >= 20 && bottom < 20 + height);
        assert!((20..2 * width * height).contains(&count));

        let mut bold = Picture::new([100, 60]).unwrap();
        bold.text([10, 20], "H4", Weight::Bold, Color([255; 3]));
        assert!(inked(&bold).unwrap().1 > count);
    }

    #[test]
    fn text_over_the_edge_is_cut_off() {
        let mut picture = Picture::new([20, 10]).unwrap();
        picture.text([15, 0], "\u{1f980}W\n", Weight::Bold, Color([255; 3]));
        assert!(inked(&picture).is_some());
        let mut empty = Picture::new([20, 10]).unwrap();
        empty.text([usize::MAX, usize::MAX], "W", Weight::Bold, Color([255; 3]));
        assert_eq!(inked(&empty), None);
    }
}
