//! The colours of the pictures: few, restrained, and told apart by lightness as well as by hue.
//!
//! Pictures have their own background of medium darkness, so that they look alike on light and on dark pages.

use crate::Color;

/// The background at its upper edge.
pub const SKY: Color = Color([0x3c, 0x48, 0x5a]);

/// The background at its lower edge.
pub const HORIZON: Color = Color([0x26, 0x2e, 0x3b]);

/// The ground, where it is lit.
pub const GROUND: Color = Color([0x62, 0x6f, 0x83]);

/// The lines of the grid on the ground.
pub const GRID: Color = Color([0x7e, 0x8b, 0x9e]);

/// Fixed bodies: walls, obstacles, containers.
pub const FIXED: Color = Color([0x93, 0x9d, 0xab]);

/// Text.
pub const TEXT: Color = Color([0xf2, 0xf4, 0xf7]);

/// Secondary text: the names of figures.
pub const FAINT: Color = Color([0xa9, 0xb4, 0xc4]);

/// The panel behind text.
pub const PANEL: Color = Color([0x12, 0x17, 0x20]);

/// Colours of groups, neighbours in the list far from each other.
const GROUPS: [Color; 8] = [
    Color([0xf2, 0xb1, 0x34]), // amber
    Color([0x3f, 0xa7, 0xd6]), // sky blue
    Color([0xe8, 0x6a, 0x58]), // coral
    Color([0x5c, 0xc0, 0xa0]), // mint
    Color([0xf3, 0xe3, 0xc3]), // cream
    Color([0x8e, 0x86, 0xd5]), // lavender
    Color([0x2f, 0x7f, 0x8f]), // petrol
    Color([0xe5, 0x93, 0xb0]), // rose
];

/// From slow to fast, from few to many: darker and cooler to lighter and warmer.
const RAMP: [Color; 6] = [
    Color([0x2b, 0x5c, 0x8f]),
    Color([0x2e, 0x93, 0xa8]),
    Color([0x6c, 0xc3, 0xa2]),
    Color([0xe9, 0xd8, 0x8f]),
    Color([0xf4, 0xa2, 0x59]),
    Color([0xe8, 0x5d, 0x4e]),
];

/// The colour of a body, or of a group of bodies, by its index: eight colours in turn.
pub fn by_index(index: usize) -> Color {
    GROUPS[index % GROUPS.len()]
}

/// A colour on the way from cool and dark (`share` 0) to warm and light (1): for speeds, counts, ages. NaN counts as 0.
pub fn by_share(share: f32) -> Color {
    let place = share.max(0.0).clamp(0.0, 1.0) * (RAMP.len() - 1) as f32;
    let index = (place as usize).min(RAMP.len() - 2);
    RAMP[index].mix(RAMP[index + 1], place - index as f32)
}

#[cfg(test)]
mod tests {
    use super::{RAMP, by_index, by_share};

    #[test]
    fn groups_take_turns() {
        assert_ne!(by_index(0), by_index(1));
        assert_eq!(by_index(3), by_index(11));
        by_index(usize::MAX);
    }

    #[test]
    fn the_ramp_has_two_ends() {
        assert_eq!(by_share(0.0), RAMP[0]);
        assert_eq!(by_share(0.2), RAMP[1]);
        assert_eq!(by_share(1.0), RAMP[5]);
        assert_eq!(by_share(f32::INFINITY), RAMP[5]);
        assert_eq!(by_share(f32::NAN), RAMP[0]);
    }
}
