//! How cells are named.

pub(crate) fn bracketed(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(", {unit}") }
}

/// An expression's text as a name.
pub(crate) fn identifier(text: &str) -> String {
    const LONGEST: usize = 32;
    let mut name = String::new();
    for c in text.chars() {
        if c.is_ascii_alphanumeric() {
            name.push(c.to_ascii_lowercase());
        } else if !name.ends_with('_') {
            name.push('_');
        }
    }
    let name = name.trim_matches('_');
    let starts_well = name.starts_with(|c: char| c.is_ascii_lowercase());
    if starts_well && name.len() <= LONGEST && crate::names::reserved(name).is_none() {
        name.to_owned()
    } else {
        "injection".to_owned()
    }
}
