//! The broad phase as serde writes and reads it, between two updates of a simulation.
//!
//! A snapshot has only the state that decides future events. Reading it rebuilds the state that decides how fast they are found. The first
//! updates and queries after that rebuild the caches of shapes and the query tree.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

use super::collider_key::ColliderKey;
use super::outline::Outline;
use super::rapier::math::{DIM, Real};
use super::{Settings, UnisizeBroadPhase};
use crate::pair_filter::PairFilter;
use crate::proxy_table::{ProxyTable, TableSnapshot};

/// The version of the format. It changes whenever a field or its meaning changes.
const FORMAT: u32 = 16;

/// The fields of a [`UnisizeBroadPhase`] that cannot be derived from others.
#[derive(serde::Serialize, serde::Deserialize)]
struct Snapshot {
    /// The first field, so that it is read before any that another version may write differently.
    #[serde(deserialize_with = "this_format")]
    format: u32,
    settings: Settings,
    table: TableSnapshot<Real, DIM, Outline, ColliderKey>,
}

fn this_format<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
    match u32::deserialize(deserializer)? {
        FORMAT => Ok(FORMAT),
        other => Err(D::Error::custom(format_args!(
            "snapshot: it has format {other}, and this version of unisize reads format {FORMAT}"
        ))),
    }
}

/// A snapshot has everything that decides future events: a restored simulation, with all of Rapier's sets, continues like the saved one. This
/// needs a format that keeps numbers bit for bit, infinite ones too, as binary formats do. The tree for queries is built anew, so queries,
/// and CCD in 0.36, may visit colliders in another order.
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

/// Computes in about the time of a full search for pairs, because it checks the data.
///
/// # Errors
///
/// Returns an error for data that no broad phase can have written, and for snapshots of versions of this library with another format.
impl<'de> Deserialize<'de> for UnisizeBroadPhase {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Snapshot {
            settings, table, ..
        } = Snapshot::deserialize(deserializer)?;
        let volumes = Self::filter(&settings) == PairFilter::Shapes;
        let table = ProxyTable::restored(volumes, table).map_err(D::Error::custom)?;
        Ok(Self {
            table,
            ..Self::with_settings(settings)
        })
    }
}
