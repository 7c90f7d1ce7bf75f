//! The hashes that are stored.

use super::hash::Hash;

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
