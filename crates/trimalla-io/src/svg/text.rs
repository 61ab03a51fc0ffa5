//! The text of a picture: its opening, and how places and letters are written.

use std::fmt;
use std::io::{self, Write};

use super::strip::Strip;
use crate::picture::{Frame, INK, MARGIN, PAPER, Place};

/// Opens the picture, with room for a strip below it, and writes background and heading.
pub(super) fn open(out: &mut dyn Write, frame: &Frame, title: &str, strip: &Strip<'_>) -> io::Result<()> {
    let (width, height) = frame.size();
    let (width, height) = (width.max(strip.width).round(), (height + strip.height).round());
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"system-ui,Helvetica,Arial,'DejaVu Sans',sans-serif\">"
    )?;
    if !title.is_empty() {
        writeln!(out, "<title>{}</title>", Escaped(title))?;
    }
    writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>")?;
    if !title.is_empty() {
        let y = MARGIN + 16.0;
        writeln!(
            out,
            "<text x=\"{MARGIN}\" y=\"{y}\" font-size=\"22\" font-weight=\"600\" fill=\"{INK}\">{}</text>",
            Escaped(title)
        )?;
    }
    Ok(())
}

/// The place as the argument of a path's `M`.
pub(super) fn absolute(place: Place) -> impl fmt::Display {
    struct Pair(Place);
    impl fmt::Display for Pair {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "{} {}", Hundredths(self.0.x), Hundredths(self.0.y))
        }
    }
    Pair(place)
}

/// Relative line commands. The steps are differences of rounded places, so they add up without drifting.
pub(super) struct Polyline<'a> {
    pub(super) from: Place,
    pub(super) to: &'a [Place],
}

impl fmt::Display for Polyline<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut at = self.from;
        for (i, &next) in self.to.iter().enumerate() {
            let (dx, dy) = (next.x - at.x, next.y - at.y);
            let (before, between) = (
                if i == 0 {
                    "l"
                } else if dx < 0 {
                    ""
                } else {
                    " "
                },
                if dy < 0 { "" } else { " " },
            );
            write!(f, "{before}{}{between}{}", Hundredths(dx), Hundredths(dy))?;
            at = next;
        }
        Ok(())
    }
}

/// Shows a number of hundredths as a decimal without needless zeros.
pub(super) struct Hundredths(pub(super) i64);

impl fmt::Display for Hundredths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (sign, size) = (if self.0 < 0 { "-" } else { "" }, self.0.unsigned_abs());
        match (size / 100, size % 100) {
            (whole, 0) => write!(f, "{sign}{whole}"),
            (whole, part) => {
                write!(f, "{sign}")?;
                if whole > 0 {
                    write!(f, "{whole}")?;
                }
                if part % 10 == 0 { write!(f, ".{}", part / 10) } else { write!(f, ".{part:02}") }
            }
        }
    }
}

/// Text inside an element; characters that XML does not allow become blanks.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '\u{fffe}' | '\u{ffff}' => f.write_str(" ")?,
                c if c.is_control() => f.write_str(" ")?,
                c => write!(f, "{c}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hundredths_are_short() {
        let shown = [0, 5, -50, 100, -1234, 120].map(|n| Hundredths(n).to_string());
        assert_eq!(shown, ["0", ".05", "-.5", "1", "-12.34", "1.2"]);
    }

    #[test]
    fn titles_cannot_break_the_picture() {
        assert_eq!(Escaped("a<b>&\0c").to_string(), "a&lt;b&gt;&amp; c");
    }
}
