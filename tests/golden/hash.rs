//! A hash that is the same everywhere, FNV-1a: <http://www.isthe.com/chongo/tech/comp/fnv>.

pub(crate) struct Hash(pub(crate) u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Hashes a number, its least significant byte first.
    pub(crate) fn write(&mut self, number: u32) {
        for byte in number.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

/// Checks the hash of a replay or a scene, which `hashes.txt` has for each flavour.
pub(crate) fn golden(flavour: &str, name: &str, found: &Hash) {
    let mut rows = include_str!("hashes.txt").lines().skip(2);
    let mut columns = rows.next().expect("the names").split_whitespace();
    let column = columns.position(|column| column == flavour);
    let mut rows = rows.map(str::split_whitespace);
    let row = rows.find(|row| row.clone().next() == Some(name));
    let golden = row.and_then(|mut row| row.nth(column?));
    let found = format!("{:016x}", found.0);
    assert_eq!(golden, Some(&found[..]), "{name} in {flavour}");
}
