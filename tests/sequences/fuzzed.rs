//! Reads sequences from bytes: the fuzzer's, and those that `strategies` draws.
//!
//! Some of the fuzzer's stand for a whole row of colliders, or for most of them in one list, which random sequences hardly ever
//! have: colliders are then read, and searched for, in another way. Bytes that run out read as zeros, so every input is
//! valid.

use arbitrary::Unstructured;

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
    let mut bytes = Bytes::new(bytes);
    // It once chose a kernel too. Inputs that were kept mean what they meant.
    let flavour = bytes.below(24) % 8;
    let mut sequence = bytes.sequence();
    bytes.read_updates(&mut sequence.updates);
    flavours::play(&sequence, flavour);
}

/// Bytes that have not been read yet.
pub(crate) struct Bytes<'a>(Unstructured<'a>);

impl<'a> Bytes<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(Unstructured::new(bytes))
    }

    /// A sequence without updates.
    pub(crate) fn sequence(&mut self) -> Sequence {
        let sequence = Sequence {
            length_unit: self.one_of(&LENGTH_UNITS),
            margin: self.one_of(&MARGINS),
            filter: self.one_of(&FILTERS),
            updates: Vec::new(),
        };
        // The inputs that are kept have two more bytes here.
        _ = (self.below(6), self.below(5));
        sequence
    }

    fn read_updates(&mut self, updates: &mut Vec<Vec<Op>>) {
        let (mut ops, mut count) = (Vec::new(), 0);
        while !self.0.is_empty() && updates.len() < MOST_UPDATES {
            if self.below(4) == 0 {
                updates.push(std::mem::take(&mut ops));
            } else if self.below(12) == 0 {
                self.push_many(&mut ops, &mut count);
            } else {
                let op = self.op();
                let inserts = matches!(op, Op::Insert(..) | Op::Replace(..) | Op::Announce(..));
                if !inserts || count < MOST {
                    count += usize::from(inserts);
                    ops.push(op);
                }
            }
        }
        updates.push(ops);
    }

    /// Something that happens to many colliders at once.
    fn push_many(&mut self, ops: &mut Vec<Op>, count: &mut usize) {
        let wanted = 1 + self.below(40);
        match self.below(4) {
            0 => {
                let (mut new, parent) = (self.new_collider(), self.parent());
                let step = self.triple(&LARGE);
                for _ in 0..wanted.min(MOST - *count) {
                    ops.push(Op::Insert(new, parent));
                    for k in 0..3 {
                        new.at[k] += step[k];
                    }
                    *count += 1;
                }
            }
            1 => {
                let (first, by) = (self.pick(), self.triple(&SMALL));
                ops.extend((0..wanted).map(|i| Op::Move(first + i, by)));
            }
            2 => {
                let (first, by) = (self.pick(), self.triple(&LARGE));
                ops.extend((0..wanted).map(|i| Op::Move(first + i, by)));
            }
            _ => {
                let list = (0..LONG_LIST).rev();
                ops.extend(list.map(|i| Op::ListAgain(List::Modified, i)));
            }
        }
    }

    pub(crate) fn insertion(&mut self) -> Op {
        Op::Insert(self.new_collider(), self.parent())
    }

    pub(crate) fn op(&mut self) -> Op {
        match self.below(44) {
            0..=3 => self.insertion(),
            4..=6 => Op::Move(self.pick(), self.triple(&SMALL)),
            7 | 40 | 41 => Op::Move(self.pick(), self.triple(&LARGE)),
            8 => Op::Shift(self.pick(), self.triple(&LARGE)),
            9 => Op::Teleport(self.pick(), self.place()),
            10 => Op::Spoil(self.pick()),
            11 => Op::Resize(self.pick(), self.shape()),
            12 => Op::Skin(self.pick(), self.one_of(&SKINS)),
            13 => Op::Sensor(self.pick(), self.flag()),
            14 | 15 => Op::Enable(self.pick(), self.flag()),
            16 | 17 => Op::Regroup(self.pick(), self.groups()),
            18 => Op::Retype(self.pick(), self.types()),
            19 => Op::EnableBody(self.pick(), self.flag()),
            20 => Op::BodyType(self.pick(), self.body_kind()),
            21 => Op::Push(self.pick(), self.triple(&LARGE)),
            22 | 23 => Op::Reparent(self.pick(), self.flag().then(|| self.pick())),
            24 | 25 => Op::Remove(self.pick()),
            26 => Op::Replace(self.pick(), self.new_collider()),
            27 => Op::RemoveBody {
                body: self.pick(),
                with_colliders: self.flag(),
            },
            28 => Op::ListAgain(self.list(), self.pick()),
            29 => Op::ListStale(self.list(), self.pick()),
            30 => Op::ListBogus(self.list(), self.index(), self.below(4) as u32),
            31 | 42 => Op::Turn(self.pick(), self.triple(&ANGLES)),
            32 => Op::Hook(self.pick(), self.flag()),
            33 => Op::LengthUnit(self.one_of(&LENGTH_UNITS)),
            34 => Op::Carry(self.pick(), self.triple(&SMALL)),
            35 => Op::Carry(self.pick(), self.triple(&LARGE)),
            36 => Op::CarryAll(1 + self.below(6), self.triple(&LARGE), self.flag()),
            37 => Op::Announce(self.new_collider(), self.triple(&SMALL)),
            38 => Op::HandOver(self.pick(), self.flag().then(|| self.place())),
            43 => match self.below(4) {
                0 => Op::Renew(self.flag()),
                1 => Op::Ask,
                _ => Op::Rewind(1 + self.below(3)),
            },
            _ => match self.below(2) {
                0 => Op::HandOverStale(self.pick(), self.place()),
                _ => Op::HandOverBogus(self.index(), self.below(4) as u32, self.place()),
            },
        }
    }

    /// A number below this one, which is at most 256.
    fn below(&mut self, end: usize) -> usize {
        // Nothing here can fail, but `Unstructured`'s types do not know that.
        self.0.int_in_range(0..=end - 1).unwrap_or(0)
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    fn flag(&mut self) -> bool {
        self.below(2) == 1
    }

    fn triple(&mut self, lengths: &[f32]) -> Triple {
        [(); 3].map(|()| self.one_of(lengths))
    }

    fn pick(&mut self) -> Pick {
        self.below(MOST)
    }

    fn list(&mut self) -> List {
        self.one_of(&[List::Modified, List::Removed])
    }

    /// The index of a handle, which may or may not be that of a collider.
    fn index(&mut self) -> u32 {
        match self.flag() {
            true => self.one_of(&FAR_INDICES),
            false => self.below(2 * MOST) as u32,
        }
    }

    fn place(&mut self) -> Triple {
        let is_far = self.below(12) == 11;
        self.triple(if is_far { &FAR } else { &NEAR })
    }

    fn shape(&mut self) -> Shape {
        match self.below(10) {
            0..=2 => Shape::Ball(self.one_of(&LENGTHS)),
            3..=5 => Shape::Cuboid(self.triple(&LENGTHS)),
            6 => Shape::Capsule(self.one_of(&LENGTHS), self.one_of(&LENGTHS)),
            7 | 8 => Shape::Compound(self.one_of(&LENGTHS), self.one_of(&LENGTHS)),
            _ => Shape::HalfSpace(self.triple(&NORMALS)),
        }
    }

    fn groups(&mut self) -> Groups {
        Groups {
            memberships: self.one_of(&GROUP_BITS),
            filter: self.one_of(&GROUP_BITS),
        }
    }

    fn types(&mut self) -> Types {
        self.one_of(&[Types::Usual, Types::All, Types::None, Types::Fixed])
    }

    fn body_kind(&mut self) -> BodyKind {
        self.one_of(&[
            BodyKind::Dynamic,
            BodyKind::Dynamic,
            BodyKind::Dynamic,
            BodyKind::Fixed,
            BodyKind::KinematicPosition,
            BodyKind::KinematicVelocity,
        ])
    }

    fn parent(&mut self) -> Parent {
        match self.below(7) {
            0..=3 => Parent::New(self.body_kind()),
            4 | 5 => Parent::Existing(self.pick()),
            _ => Parent::None,
        }
    }

    fn new_collider(&mut self) -> NewCollider {
        NewCollider {
            shape: self.shape(),
            at: self.place(),
            sensor: self.below(5) == 4,
            enabled: self.below(10) < 9,
            // Most meet all.
            groups: match self.below(3) {
                0 => self.groups(),
                _ => Groups {
                    memberships: u32::MAX,
                    filter: u32::MAX,
                },
            },
            types: self.types(),
        }
    }
}
