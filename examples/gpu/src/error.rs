//! What can go wrong.

use thiserror::Error;
use unisize::InvalidInput;

/// Why the pairs of some boxes cannot be found on a GPU.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum GpuError {
    /// A box has a NaN or `mins > maxs`; the first one is named.
    #[error(transparent)]
    Invalid(#[from] InvalidInput),
    /// More boxes than the sweep has memory for, or a buffer that is larger than the device allows.
    #[error("{wanted} {what} are more than {limit}, which is the limit")]
    TooMany {
        /// What there is too much of.
        what: &'static str,
        /// How many there would be.
        wanted: u64,
        /// How many there may be.
        limit: u64,
    },
    /// No adapter, or no device on it.
    #[error("no GPU: {0}")]
    NoDevice(String),
    /// The device has failed, or was lost.
    #[error("the device failed: {0}")]
    Device(String),
}

/// An error if there is too much.
pub(crate) fn check(what: &'static str, wanted: u64, limit: u64) -> Result<(), GpuError> {
    let too_many = GpuError::TooMany {
        what,
        wanted,
        limit,
    };
    if wanted > limit {
        Err(too_many)
    } else {
        Ok(())
    }
}
