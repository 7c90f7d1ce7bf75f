//! Colours that most people can distinguish, in pairs of a strong one and a light one, with one meaning in all charts: reds are
//! unisize, blues are Rapier's own broad phases, and all others the rest. Each colour has its own shape of points as well.

use plotters::style::RGBColor;

/// For the fast kernel and for unisize as a whole.
pub const RED: RGBColor = RGBColor(213, 0, 0);
/// The light red.
pub const SALMON: RGBColor = RGBColor(228, 112, 88);
/// A strong blue, for Rapier 0.27.
pub const BLUE: RGBColor = RGBColor(0, 90, 181);
/// The light blue, for Rapier 0.36.
pub const SKY: RGBColor = RGBColor(80, 170, 230);
/// A strong green.
pub const GREEN: RGBColor = RGBColor(0, 130, 80);
/// The light green.
pub const MINT: RGBColor = RGBColor(110, 200, 130);
/// A strong purple.
pub const PURPLE: RGBColor = RGBColor(120, 60, 160);
/// A dark yellow.
pub const OCHRE: RGBColor = RGBColor(200, 140, 0);
/// Nearly black.
pub const BLACK: RGBColor = RGBColor(60, 60, 60);
/// The light black.
pub const GREY: RGBColor = RGBColor(160, 160, 160);
/// A strong pink.
pub const PINK: RGBColor = RGBColor(225, 70, 180);
/// The light pink.
pub const ROSE: RGBColor = RGBColor(240, 160, 215);

/// The reds.
pub const OURS: [RGBColor; 2] = [RED, SALMON];

/// For what is neither unisize nor Rapier.
pub const OTHERS: [RGBColor; 8] = [GREEN, MINT, BLACK, GREY, PURPLE, OCHRE, PINK, ROSE];
