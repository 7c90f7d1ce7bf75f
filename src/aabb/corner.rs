//! A corner of a box as serde reads and writes it, because serde itself supports only arrays of certain
//! lengths.

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

use crate::real::Real;

pub(super) fn serialize<R: Serialize, S: Serializer, const D: usize>(
    corner: &[R; D],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let mut tuple = serializer.serialize_tuple(D)?;
    for coordinate in corner {
        tuple.serialize_element(coordinate)?;
    }
    tuple.end()
}

pub(super) fn deserialize<'de, R, A, const D: usize>(deserializer: A) -> Result<[R; D], A::Error>
where
    R: Real + Deserialize<'de>,
    A: Deserializer<'de>,
{
    deserializer.deserialize_tuple(D, Corner(PhantomData))
}

struct Corner<R, const D: usize>(PhantomData<R>);

impl<'de, R: Real + Deserialize<'de>, const D: usize> Visitor<'de> for Corner<R, D> {
    type Value = [R; D];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{D} coordinates")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut coordinates: A) -> Result<[R; D], A::Error> {
        let mut corner = [R::ZERO; D];
        for (k, coordinate) in corner.iter_mut().enumerate() {
            let next = coordinates.next_element()?;
            *coordinate = next.ok_or_else(|| A::Error::invalid_length(k, &self))?;
        }
        Ok(corner)
    }
}
