//! The reference algorithms that the paper compares itself with or builds on.
//!
//! They are exact, and tested like every kernel, but nobody should need them except to compare.
