//! Numbers in messages.

/// A number in five digits, as short as they allow.
#[must_use]
pub fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.4e}").parse().unwrap_or(x);
    let is_plain = rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs());
    if is_plain { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// A count with its noun: `1 segment`, `2 segments`.
#[must_use]
pub fn count(n: usize, noun: &str) -> String {
    let irregular = match noun {
        "vertex" => Some("vertices"),
        "new vertex" => Some("new vertices"),
        _ => None,
    };
    match (n, irregular) {
        (1, _) => format!("1 {noun}"),
        (_, Some(plural)) => format!("{n} {plural}"),
        _ => format!("{n} {noun}s"),
    }
}
