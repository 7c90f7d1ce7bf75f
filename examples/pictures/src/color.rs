//! Colours: three bytes outside, light inside.

use glam::Vec3;

/// A colour as red, green and blue, in the sRGB space of files and screens.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Color(pub [u8; 3]);

impl Color {
    /// Between this colour (at 0) and another (at 1), in equal steps of light. NaN counts as 0.
    pub fn mix(self, other: Self, share: f32) -> Self {
        // NaN becomes 0; `clamp` alone would keep it.
        let share = share.max(0.0).clamp(0.0, 1.0);
        Self::from_light(self.light().lerp(other.light(), share))
    }

    /// The amounts of red, green and blue light, 0 to 1, as graphics cards want them.
    pub fn linear(self) -> [f32; 3] {
        self.light().into()
    }

    /// The amounts of light, 0 to 1: sums and means of these are right, those of the bytes are too dark.
    pub(crate) fn light(self) -> Vec3 {
        let channel = |byte: u8| {
            let share = f32::from(byte) / 255.0;
            if share <= 0.04045 {
                share / 12.92
            } else {
                ((share + 0.055) / 1.055).powf(2.4)
            }
        };
        Vec3::from(self.0.map(channel))
    }

    /// The colour of this light.
    pub(crate) fn from_light(light: Vec3) -> Self {
        let channel = |share: f32| {
            let share = share.clamp(0.0, 1.0);
            let share = if share <= 0.003_130_8 {
                share * 12.92
            } else {
                1.055 * share.powf(1.0 / 2.4) - 0.055
            };
            (share * 255.0).round() as u8
        };
        Self(light.to_array().map(channel))
    }
}

#[cfg(test)]
mod tests {
    use super::Color;

    #[test]
    fn light_leads_back_to_the_colour() {
        for byte in 0..=255 {
            let color = Color([byte, 255 - byte, byte / 2]);
            assert_eq!(Color::from_light(color.light()), color);
        }
        assert_eq!(Color([255, 0, 255]).linear(), [1.0, 0.0, 1.0]);
    }

    #[test]
    fn a_mix_goes_from_one_colour_to_the_other() {
        let (black, white) = (Color([0; 3]), Color([255; 3]));
        assert_eq!(black.mix(white, -1.0), black);
        assert_eq!(black.mix(white, 2.0), white);
        assert_eq!(black.mix(white, f32::NAN), black);
        // Half of the light of white is the byte 188.
        assert_eq!(black.mix(white, 0.5), Color([188; 3]));
    }
}
