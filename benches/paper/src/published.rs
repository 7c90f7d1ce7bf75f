//! The figures of the paper, as printed there.

/// Density and the logarithm of the number of squares; milliseconds a frame of [Bar92], [KMZ13] and theirs on a laptop of 2014; thousands
/// of collisions, and milliseconds of the pairing phase.
pub(crate) type Line = (f64, u32, [f64; 3], [f64; 2]);

/// Table 1 and the table of Figure 3, by density and then by size.
pub(crate) const LINES: [Line; 16] = [
    (0.2, 17, [93.0, 90.0, 17.0], [53.0, 7.0]),
    (0.2, 18, [236.0, 199.0, 35.0], [105.0, 14.0]),
    (0.2, 19, [664.0, 438.0, 90.0], [210.0, 48.0]),
    (0.2, 20, [1883.0, 955.0, 220.0], [420.0, 127.0]),
    (0.4, 17, [129.0, 98.0, 17.0], [105.0, 7.0]),
    (0.4, 18, [332.0, 215.0, 36.0], [210.0, 15.0]),
    (0.4, 19, [936.0, 470.0, 91.0], [420.0, 48.0]),
    (0.4, 20, [2653.0, 1021.0, 216.0], [840.0, 135.0]),
    (0.6, 17, [157.0, 103.0, 17.0], [158.0, 7.0]),
    (0.6, 18, [405.0, 225.0, 36.0], [315.0, 15.0]),
    (0.6, 19, [1143.0, 489.0, 87.0], [631.0, 48.0]),
    (0.6, 20, [3239.0, 1063.0, 219.0], [1260.0, 136.0]),
    (0.8, 17, [181.0, 106.0, 18.0], [211.0, 8.0]),
    (0.8, 18, [502.0, 232.0, 37.0], [421.0, 15.0]),
    (0.8, 19, [1318.0, 504.0, 87.0], [841.0, 48.0]),
    (0.8, 20, [3747.0, 1093.0, 215.0], [1681.0, 137.0]),
];

/// Worst, average and median milliseconds a frame in Figure 4.
pub(crate) const CONVERGING: [f64; 3] = [17.5, 13.5, 13.2];

/// The gain by sorting both axes at once.
pub(crate) const THREADS: f64 = 1.25;
