//! What the fuzzer plays: bytes encode a sequence, whose updates are checked like those of a random one.
//!
//! Some bytes stand for a whole row of colliders, or for most of them in one list, which random sequences hardly ever
//! have: colliders are then read, and searched for, in another way. Bytes that run out read as zeros, so every input is
//! valid.

use arbitrary::{Result, Unstructured};

use crate::flavours;
use crate::ops::{
    ANGLES, BodyKind, FAR, FAR_INDICES, FILTERS, GROUP_BITS, Groups, LARGE, LENGTH_UNITS, LENGTHS,
    List, MARGINS, NEAR, NORMALS, NewCollider, Op, Parent, Pick, SKINS, SMALL, Sequence, Shape,
    Triple, Types,
};

/// How many colliders there may be; the model looks at every pair of them.
const MOST: usize = 80;

/// How many updates a sequence may have.
const MOST_UPDATES: usize = 60;

/// Long enough that colliders are no longer read in the order of the list.
const LONG_LIST: usize = 300;

/// Plays the sequence that the bytes encode.
pub(crate) fn play(bytes: &[u8]) {
    let mut bytes = Bytes(Unstructured::new(bytes));
    // Nothing here can fail, but `Unstructured`'s types do not know that.
    let Ok((way, sequence)) = bytes.way_and_sequence() else {
        return;
    };
    flavours::play(&sequence, way % 8, way / 8);
}

struct Bytes<'a>(Unstructured<'a>);

impl Bytes<'_> {
    /// Which flavour and kernel to play with, and what.
    fn way_and_sequence(&mut self) -> Result<(usize, Sequence)> {
        let way = self.0.int_in_range(0..=23)?;
        let mut sequence = Sequence {
            length_unit: self.one_of(&LENGTH_UNITS)?,
            margin: self.one_of(&MARGINS)?,
            foresight: None,
            layers: true,
            filter: self.one_of(&FILTERS)?,
            updates: vec![Vec::new()],
        };
        let mut count = 0;
        while !self.0.is_empty() && sequence.updates.len() <= MOST_UPDATES {
            let Some(ops) = sequence.updates.last_mut() else {
                break;
            };
            if self.0.ratio(1_u8, 4_u8)? {
                sequence.updates.push(Vec::new());
            } else if self.0.ratio(1_u8, 12_u8)? {
                self.push_many(ops, &mut count)?;
            } else {
                let op = self.op()?;
                match op {
                    Op::Insert(..) | Op::Replace(..) if count >= MOST => continue,
                    Op::Insert(..) | Op::Replace(..) => count += 1,
                    _ => {}
                }
                ops.push(op);
            }
        }
        Ok((way, sequence))
    }

    /// Something that happens to many colliders at once.
    fn push_many(&mut self, ops: &mut Vec<Op>, count: &mut usize) -> Result<()> {
        let wanted = self.0.int_in_range(1..=40_usize)?;
        match self.0.int_in_range(0..=3)? {
            0 => {
                let (mut new, parent) = (self.new_collider()?, self.parent()?);
                let step = self.triple(&LARGE)?;
                for _ in 0..wanted.min(MOST - *count) {
                    ops.push(Op::Insert(new, parent));
                    for k in 0..3 {
                        new.at[k] += step[k];
                    }
                    *count += 1;
                }
            }
            1 => {
                let (first, by) = (self.pick()?, self.triple(&SMALL)?);
                ops.extend((0..wanted).map(|i| Op::Move(first + i, by)));
            }
            2 => {
                let (first, by) = (self.pick()?, self.triple(&LARGE)?);
                ops.extend((0..wanted).map(|i| Op::Move(first + i, by)));
            }
            _ => {
                let list = (0..LONG_LIST).rev();
                ops.extend(list.map(|i| Op::ListAgain(List::Modified, i)));
            }
        }
        Ok(())
    }

    fn op(&mut self) -> Result<Op> {
        Ok(match self.0.int_in_range(0..=30)? {
            0..=2 => Op::Insert(self.new_collider()?, self.parent()?),
            3 | 4 => Op::Move(self.pick()?, self.triple(&SMALL)?),
            5 | 6 => Op::Move(self.pick()?, self.triple(&LARGE)?),
            7 => Op::Shift(self.pick()?, self.triple(&LARGE)?),
            8 => Op::Teleport(self.pick()?, self.place()?),
            9 => Op::Spoil(self.pick()?),
            10 => Op::Resize(self.pick()?, self.shape()?),
            11 => Op::Skin(self.pick()?, self.one_of(&SKINS)?),
            12 => Op::Sensor(self.pick()?, self.flag()?),
            13 | 14 => Op::Enable(self.pick()?, self.flag()?),
            15 => Op::Regroup(self.pick()?, self.groups()?),
            16 => Op::Retype(self.pick()?, self.types()?),
            17 => Op::EnableBody(self.pick()?, self.flag()?),
            18 => Op::BodyType(self.pick()?, self.body_kind()?),
            19 => Op::Push(self.pick()?, self.triple(&LARGE)?),
            20 => Op::Reparent(self.pick()?, self.other_pick()?),
            21 | 22 => Op::Remove(self.pick()?),
            23 => Op::Replace(self.pick()?, self.new_collider()?),
            24 => Op::RemoveBody {
                body: self.pick()?,
                with_colliders: self.flag()?,
            },
            25 => Op::ListAgain(self.list()?, self.pick()?),
            26 => Op::ListStale(self.list()?, self.pick()?),
            27 => Op::ListBogus(self.list()?, self.index()?, self.0.int_in_range(0..=3)?),
            28 => Op::Turn(self.pick()?, self.triple(&ANGLES)?),
            29 => Op::Hook(self.pick()?, self.flag()?),
            _ => Op::LengthUnit(self.one_of(&LENGTH_UNITS)?),
        })
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> Result<T> {
        self.0.choose(choices).copied()
    }

    fn flag(&mut self) -> Result<bool> {
        self.0.arbitrary()
    }

    fn triple(&mut self, lengths: &[f32]) -> Result<Triple> {
        let mut one = || self.one_of(lengths);
        Ok([one()?, one()?, one()?])
    }

    fn pick(&mut self) -> Result<Pick> {
        self.0.int_in_range(0..=MOST - 1)
    }

    fn other_pick(&mut self) -> Result<Option<Pick>> {
        let is_some = self.flag()?;
        is_some.then(|| self.pick()).transpose()
    }

    fn list(&mut self) -> Result<List> {
        self.one_of(&[List::Modified, List::Removed])
    }

    /// The index of a handle, which may or may not be that of a collider.
    fn index(&mut self) -> Result<u32> {
        if self.flag()? {
            self.one_of(&FAR_INDICES)
        } else {
            self.0.int_in_range(0..=2 * MOST as u32)
        }
    }

    fn place(&mut self) -> Result<Triple> {
        let is_far = self.0.ratio(1_u8, 12_u8)?;
        self.triple(if is_far { &FAR } else { &NEAR })
    }

    fn shape(&mut self) -> Result<Shape> {
        Ok(match self.0.int_in_range(0..=9)? {
            0..=2 => Shape::Ball(self.one_of(&LENGTHS)?),
            3..=5 => Shape::Cuboid(self.triple(&LENGTHS)?),
            6 => Shape::Capsule(self.one_of(&LENGTHS)?, self.one_of(&LENGTHS)?),
            7 | 8 => Shape::Compound(self.one_of(&LENGTHS)?, self.one_of(&LENGTHS)?),
            _ => Shape::HalfSpace(self.triple(&NORMALS)?),
        })
    }

    fn groups(&mut self) -> Result<Groups> {
        Ok(Groups {
            memberships: self.one_of(&GROUP_BITS)?,
            filter: self.one_of(&GROUP_BITS)?,
        })
    }

    fn types(&mut self) -> Result<Types> {
        self.one_of(&[Types::Usual, Types::All, Types::None])
    }

    fn body_kind(&mut self) -> Result<BodyKind> {
        self.one_of(&[
            BodyKind::Dynamic,
            BodyKind::Fixed,
            BodyKind::KinematicPosition,
            BodyKind::KinematicVelocity,
        ])
    }

    fn parent(&mut self) -> Result<Parent> {
        Ok(match self.0.int_in_range(0..=23)? {
            0 | 1 => Parent::None,
            2..=4 => Parent::New(self.body_kind()?),
            _ => Parent::Existing(self.pick()?),
        })
    }

    fn new_collider(&mut self) -> Result<NewCollider> {
        Ok(NewCollider {
            shape: self.shape()?,
            at: self.place()?,
            sensor: false,
            enabled: !self.0.ratio(1_u8, 10_u8)?,
            groups: self.groups()?,
            types: self.types()?,
        })
    }
}
