//! Which snapshots can be read.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

/// The number of the format. It changes with every change of a field, or of what a field decides.
const NUMBER: u32 = 9;

/// The mark at the beginning of a snapshot: written as the number of the format, and read only if the number is the
/// same.
pub(crate) struct SnapshotFormat;

impl Serialize for SnapshotFormat {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        NUMBER.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for SnapshotFormat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match u32::deserialize(deserializer)? {
            NUMBER => Ok(Self),
            other => Err(D::Error::custom(format_args!(
                "snapshot: it has format {other}, and this version of unisize reads format {NUMBER}"
            ))),
        }
    }
}
