//! `.line` files: blocks of a count and that many points.

use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::rings::{push_chain, push_ring};
use super::{index, number, text_of};

/// Reads all blocks; a block whose last point repeats the first is a ring, others are open lines.
#[must_use]
pub fn read_line(path: &Path) -> Pslg {
    let text = text_of(path);
    let mut tokens = text.split_whitespace();
    let mut pslg = Pslg::default();
    while let Some(count) = tokens.next() {
        let mut next = || number(tokens.next().unwrap_or_else(|| panic!("{} ends early", path.display())));
        let block: Vec<Point> = (0..index(count)).map(|_| Point::new(next(), next())).collect();
        if block.first() == block.last() {
            push_ring(&mut pslg, &block);
        } else {
            push_chain(&mut pslg, &block);
        }
    }
    pslg
}
