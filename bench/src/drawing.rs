//! The drawing file: `DRAWING1`, three counts, then points, segments and hole seeds, little endian.

use std::fs::File;
use std::io::{BufReader, BufWriter, Read, Write};
use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use crate::Outcome;

const MAGIC: &[u8; 8] = b"DRAWING1";

/// Writes a drawing.
pub fn write(path: &Path, drawing: &Pslg) -> Outcome<()> {
    let mut file = BufWriter::new(File::create(path)?);
    file.write_all(MAGIC)?;
    for count in [drawing.points.len(), drawing.segments.len(), drawing.holes.len()] {
        file.write_all(&(count as u64).to_le_bytes())?;
    }
    drawing.points.iter().try_for_each(|p| write_point(&mut file, p))?;
    for v in drawing.segments.iter().flatten() {
        file.write_all(&v.to_le_bytes())?;
    }
    drawing.holes.iter().try_for_each(|p| write_point(&mut file, p))?;
    Ok(file.flush()?)
}

fn write_point(file: &mut impl Write, p: &Point) -> std::io::Result<()> {
    file.write_all(&p.x.to_le_bytes())?;
    file.write_all(&p.y.to_le_bytes())
}

/// Reads a drawing; takes no memory but the drawing's.
pub fn read(path: &Path) -> Outcome<Pslg> {
    let mut file = BufReader::new(File::open(path)?);
    let mut word = || -> Outcome<[u8; 8]> {
        let mut bytes = [0; 8];
        file.read_exact(&mut bytes)?;
        Ok(bytes)
    };
    if &word()? != MAGIC {
        return Err(format!("{} is no drawing", path.display()).into());
    }
    let mut count = || Ok::<_, Box<dyn std::error::Error>>(usize::try_from(u64::from_le_bytes(word()?))?);
    let (n, m, h) = (count()?, count()?, count()?);
    let point = |word: &mut dyn FnMut() -> Outcome<[u8; 8]>| -> Outcome<Point> {
        Ok(Point::new(f64::from_le_bytes(word()?), f64::from_le_bytes(word()?)))
    };
    let mut drawing = Pslg { points: Vec::with_capacity(n), segments: Vec::with_capacity(m), ..Pslg::default() };
    for _ in 0..n {
        drawing.points.push(point(&mut word)?);
    }
    for _ in 0..m {
        let [a, b, c, d, e, f, g, h] = word()?;
        drawing.segments.push([u32::from_le_bytes([a, b, c, d]), u32::from_le_bytes([e, f, g, h])]);
    }
    for _ in 0..h {
        drawing.holes.push(point(&mut word)?);
    }
    Ok(drawing)
}
