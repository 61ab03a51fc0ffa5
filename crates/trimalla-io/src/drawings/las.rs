//! LAS: points of laser scanners.

use trimalla::geometry::Point;

use super::shapefile::double;
use super::sketch::{Kind, Path, Sketch, Vertex, fault_in};
use crate::error::IoError;

/// Reads a file: x, y and the height of each point.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Sketch, IoError> {
    let fault = |message: &str| fault_in(name, "", 0, message);
    let short = || fault("expected a header of LAS, found the end of the file");
    if !bytes.starts_with(b"LASF") {
        return Err(fault("expected a LAS file, which begins with LASF"));
    }
    let half = |at: usize| bytes.get(at..at + 2).map(|b| u16::from_le_bytes([b[0], b[1]])).ok_or_else(short);
    let word =
        |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).ok_or_else(short);
    let real = |at: usize| double(bytes, at).ok_or_else(short);
    let format = bytes.get(104).copied().ok_or_else(short)?;
    if format & 0x80 != 0 {
        return Err(fault("expected points that are not compressed, found LAZ: decompress them first (laszip, pdal)"));
    }
    let (start, width) = (word(96)? as usize, usize::from(half(105)?));
    let minor = bytes.get(25).copied().unwrap_or(0);
    let wide_count =
        || bytes.get(247..255).map(|b| u64::from_le_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]]));
    let count = match word(107)? {
        0 if minor >= 4 => wide_count().ok_or_else(short)?,
        count => u64::from(count),
    };
    if width < 20 {
        return Err(fault("expected records of points of at least 20 bytes"));
    }
    let [scale, offset] = [131, 155].map(|at| Ok::<_, IoError>([real(at)?, real(at + 8)?, real(at + 16)?]));
    let (scale, offset) = (scale?, offset?);
    let records = bytes.get(start..).unwrap_or_default();
    if (records.len() / width) as u64 >= count {
        let mut sketch = Sketch::new("record", "file");
        let layer = sketch.layers.number("points");
        let vertices = records.chunks_exact(width).take(count as usize).map(|record| {
            let coordinate = |i: usize| {
                let raw = i32::from_le_bytes([record[4 * i], record[4 * i + 1], record[4 * i + 2], record[4 * i + 3]]);
                f64::from(raw) * scale[i] + offset[i]
            };
            Vertex { at: Point::new(coordinate(0), coordinate(1)), z: coordinate(2) }
        });
        sketch.add(Kind::Points, layer, 1, Path::of(vertices, false).into_iter().collect());
        return Ok(sketch);
    }
    let found = records.len() / width;
    Err(fault(&format!("expected {count} points, as the header says, found {found}")))
}
