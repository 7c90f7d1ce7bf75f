//! A panel that explains the picture: a title, and figures beneath it.

use crate::{Picture, Weight, palette};
use std::fmt::Display;

/// The opacity of the panel.
const OPACITY: f32 = 0.86;

/// The least width of a value in letters, so that the panel keeps its width while values grow.
const VALUE: usize = 9;

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
    /// Lays a legend over the upper left corner.
    pub fn legend(&mut self, legend: &Legend) {
        let [letter, height] = self.letter_size();
        let margin = height * 3 / 4;
        let pitch = height * 5 / 4;
        let count = |text: &str| text.chars().count();
        let names = legend.facts.iter().map(|(name, _)| count(name)).max();
        let values = legend.facts.iter().map(|(_, value)| count(value)).max();
        let of_facts = match (names, values) {
            (Some(names), Some(values)) => names + 2 + values.max(VALUE),
            _ => 0,
        };
        let letters = of_facts.max(count(&legend.title));
        let size = [
            letters * letter + 2 * margin,
            legend.facts.len() * pitch + height + 3 * margin / 2,
        ];
        self.panel([margin; 2], size);

        let [left, mut top] = [2 * margin, margin + 3 * margin / 4];
        self.text([left, top], &legend.title, Weight::Bold, palette::TEXT);
        for (name, value) in &legend.facts {
            top += pitch;
            self.text([left, top], name, Weight::Regular, palette::FAINT);
            let indent = letters.saturating_sub(count(value)) * letter;
            self.text([left + indent, top], value, Weight::Regular, palette::TEXT);
        }
    }

    /// Darkens a rectangle with round corners.
    fn panel(&mut self, corner: [usize; 2], size: [usize; 2]) {
        const RADIUS: f32 = 6.0;
        let half = size.map(|side| side as f32 / 2.0);
        for row in 0..size[1] {
            for column in 0..size[0] {
                // How far outside of the rectangle between the corners' centres.
                let [x, y] = [(column, half[0]), (row, half[1])].map(|(place, half)| {
                    ((place as f32 + 0.5 - half).abs() - (half - RADIUS)).max(0.0)
                });
                let coverage = (RADIUS + 0.5 - x.hypot(y)).clamp(0.0, 1.0);
                let (column, row) = (corner[0] + column, corner[1] + row);
                self.blend(column, row, palette::PANEL, OPACITY * coverage);
            }
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

#[cfg(test)]
mod tests {
    use super::{Legend, thousands};
    use crate::{Color, Picture};

    #[test]
    fn a_legend_stays_in_its_corner() {
        let mut picture = Picture::new([400, 300]).unwrap();
        picture.pixels.fill(Color([255; 3]).light());
        picture.legend(
            &Legend::new("unisize")
                .fact("bodies", 3)
                .fact("pairs", thousands(1234)),
        );
        let white = Some(Color([255; 3]));
        assert_ne!(picture.pixel(20, 20), white);
        for place in [[0, 0], [399, 0], [0, 299], [399, 299], [12, 12]] {
            assert_eq!(picture.pixel(place[0], place[1]), white, "{place:?}");
        }
    }

    #[test]
    fn a_legend_fits_any_picture() {
        for size in [[1, 1], [7, 2000], [2000, 7]] {
            let mut picture = Picture::new(size).unwrap();
            picture.legend(&Legend::new("").fact("", "a long value that fits no small picture"));
            picture.legend(&Legend::new("title"));
        }
    }

    #[test]
    fn thousands_are_told_apart() {
        for (number, text) in [
            (0, "0"),
            (999, "999"),
            (1000, "1,000"),
            (1234567, "1,234,567"),
        ] {
            assert_eq!(thousands(number), text);
        }
    }
}
