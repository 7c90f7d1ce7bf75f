//! The broad phase as it is written and read by serde, in the middle of a simulation.
//!
//! What is written decides all events to come. What only decides how much work it is to find them is made anew, as are outlines of shapes
//! and the tree for queries.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

use super::collider_key::ColliderKey;
use super::rapier::math::{DIM, Real};
use super::{Settings, UnisizeBroadPhase};
use crate::proxy_table::{ProxyTable, TableSnapshot};

/// The number of the format. It changes with every change of a field, or of what a field decides.
const FORMAT: u32 = 12;

/// The fields of a [`UnisizeBroadPhase`] that cannot be derived from others.
#[derive(serde::Serialize, serde::Deserialize)]
struct Snapshot {
    /// First, so that it is read before anything that another version may write differently.
    #[serde(deserialize_with = "this_format")]
    format: u32,
    settings: Settings,
    table: TableSnapshot<Real, DIM, ColliderKey>,
}

fn this_format<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
    match u32::deserialize(deserializer)? {
        FORMAT => Ok(FORMAT),
        other => Err(D::Error::custom(format_args!(
            "snapshot: it has format {other}, and this version of unisize reads format {FORMAT}"
        ))),
    }
}

/// What is written decides all events to come: a simulation that is restored, with all of Rapier's
/// sets, goes on as the one that was saved. For that the format must keep numbers bit for bit, as binary formats do. If
/// another version of the library wrote the snapshot in another format, reading it is an error that says so.
impl Serialize for UnisizeBroadPhase {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let snapshot = Snapshot {
            format: FORMAT,
            settings: self.settings,
            table: self.table.snapshot(),
        };
        snapshot.serialize(serializer)
    }
}

/// Data that no broad phase can have written is an error, and whatever is read without one is safe to use. The check
/// takes about as long as a full search for pairs.
impl<'de> Deserialize<'de> for UnisizeBroadPhase {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Snapshot {
            settings, table, ..
        } = Snapshot::deserialize(deserializer)?;
        let table =
            ProxyTable::restored(&Self::resolved(settings), table).map_err(D::Error::custom)?;
        Ok(Self {
            table,
            ..Self::with_settings(settings)
        })
    }
}
