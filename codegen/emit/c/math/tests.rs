//! What must hold of the parts as texts.

use super::*;

/// Claim: what is derived from the texts is what was written down by hand.
#[test]
fn derived_requirements_are_those_of_the_table() {
    let table = deadbeat_math::c::FRAGMENTS;
    assert_eq!(PARTS.len(), table.len());
    for (part, fragment) in PARTS.iter().zip(table) {
        assert_eq!((part.name, part.text), (fragment.name, fragment.source));
        let derived: BTreeSet<&str> = part.requires().map(|it| it.name).collect();
        let written: BTreeSet<&str> = fragment.requires.iter().copied().collect();
        assert_eq!(derived, written, "{}", part.name);
    }
}
