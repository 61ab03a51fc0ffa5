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

/// A whole number with its digits in groups of three: `1,234,567`.
#[must_use]
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn digits_are_grouped_from_the_right() {
        let texts = [0, 999, 1000, 12_345, 1_234_567].map(grouped);
        assert_eq!(texts, ["0", "999", "1,000", "12,345", "1,234,567"]);
    }
}
