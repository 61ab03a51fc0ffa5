//! DXF: drawings of CAD programs, as text.
//!
//! A file is a list of pairs, each a line with a code and a line with a value. Read here and not by a crate: the one
//! there is names no line of what it refuses, and brings image formats and dates along.

mod entity;
mod pairs;
mod polyline;

use std::collections::HashMap;

use self::entity::Entity;
use self::pairs::{Pair, Pairs};
use super::affine::Affine;
use super::sketch::{Fill, Kind, Path, Sketch, fault_at};
use crate::error::IoError;

/// Blocks in blocks are followed as deep as this.
const DEEPEST: usize = 16;

/// Blocks may be placed so often that a small file has more pieces than fit into memory.
const MOST_PLACED: usize = 1 << 21;

/// Reads a file.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Sketch, IoError> {
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err(fault_at(name, 1, 1, "DXF as text", "binary DXF: save it as text (ASCII) DXF"));
    }
    let pairs = Pairs::read(bytes, name)?;
    let file = File::of(&pairs, name)?;
    let mut reader = Reader { file: &file, pairs: &pairs, sketch: Sketch::new("line", "layer"), placed: 0 };
    reader.sketch.told.extend(file.unit.map(|unit| format!("unit: {unit}")));
    for entity in &file.entities {
        reader.add(entity, &Affine::IDENTITY, None, 0)?;
    }
    Ok(reader.sketch)
}

/// A block: entities that may be placed several times.
#[derive(Debug, Default)]
struct Block {
    base: [f64; 2],
    entities: Vec<Entity>,
}

/// The sections of a file, as far as they matter.
#[derive(Debug, Default)]
struct File {
    unit: Option<&'static str>,
    /// Layers that are frozen or off.
    hidden: Vec<String>,
    blocks: HashMap<String, Block>,
    entities: Vec<Entity>,
}

impl File {
    fn of(pairs: &Pairs<'_>, name: &str) -> Result<Self, IoError> {
        let mut file = Self::default();
        let mut at = 0;
        let mut has_sections = false;
        while at < pairs.len() {
            let pair = pairs.get(at);
            if pair.code == 0 && pair.value == "SECTION" && at + 1 < pairs.len() {
                has_sections = true;
                let section = pairs.get(at + 1).value;
                let end = (at + 2..pairs.len()).find(|&i| pairs.get(i).is(0, "ENDSEC")).unwrap_or(pairs.len());
                match section {
                    "HEADER" => file.unit = unit(pairs, at + 2, end),
                    "TABLES" => file.hidden = hidden_layers(pairs, at + 2, end),
                    "BLOCKS" => file.blocks = blocks(pairs, at + 2, end)?,
                    "ENTITIES" => file.entities = Entity::all(pairs, at + 2, end),
                    _ => {}
                }
                at = end;
            }
            at += 1;
        }
        if has_sections { Ok(file) } else { Err(fault_at(name, 1, 1, "a section of DXF", "none")) }
    }
}

/// The unit that the header names.
fn unit(pairs: &Pairs<'_>, from: usize, to: usize) -> Option<&'static str> {
    let at = (from..to).find(|&i| pairs.get(i).is(9, "$INSUNITS"))?;
    let code: usize = pairs.get((at + 1).min(to.saturating_sub(1))).value.parse().ok()?;
    let names = [
        "none",
        "inches",
        "feet",
        "miles",
        "millimetres",
        "centimetres",
        "metres",
        "kilometres",
        "microinches",
        "mils",
        "yards",
        "ångströms",
        "nanometres",
        "micrometres",
        "decimetres",
        "decametres",
        "hectometres",
        "gigametres",
    ];
    names.get(code).copied()
}

/// The layers that are frozen or switched off.
fn hidden_layers(pairs: &Pairs<'_>, from: usize, to: usize) -> Vec<String> {
    let layers = Entity::all(pairs, from, to).into_iter().filter(|entity| entity.is(pairs, "LAYER"));
    let is_hidden = |layer: &Entity| {
        let flags = layer.first(pairs, 70).and_then(|p| p.value.parse::<i64>().ok()).unwrap_or(0);
        let colour = layer.first(pairs, 62).and_then(|p| p.value.parse::<i64>().ok()).unwrap_or(1);
        flags & 1 != 0 || colour < 0
    };
    layers.filter(is_hidden).filter_map(|layer| layer.first(pairs, 2).map(|pair| pair.value.to_owned())).collect()
}

fn blocks(pairs: &Pairs<'_>, from: usize, to: usize) -> Result<HashMap<String, Block>, IoError> {
    let mut blocks = HashMap::new();
    let mut current: Option<(String, Block)> = None;
    for entity in Entity::all(pairs, from, to) {
        if entity.is(pairs, "BLOCK") {
            let name = entity.first(pairs, 2).map_or("", |pair| pair.value).to_owned();
            let base = [entity.number_or(pairs, 10, 0.0)?, entity.number_or(pairs, 20, 0.0)?];
            current = Some((name, Block { base, entities: Vec::new() }));
        } else if entity.is(pairs, "ENDBLK") {
            blocks.extend(current.take());
        } else if let Some((_, block)) = &mut current {
            block.entities.push(entity);
        }
    }
    Ok(blocks)
}

struct Reader<'a> {
    file: &'a File,
    pairs: &'a Pairs<'a>,
    sketch: Sketch,
    /// How many entities of blocks were placed.
    placed: usize,
}

impl Reader<'_> {
    /// Adds an entity under a map; `of_insert` is the layer on which its block is placed.
    fn add(&mut self, entity: &Entity, map: &Affine, of_insert: Option<&str>, depth: usize) -> Result<(), IoError> {
        let kind = entity.kind(self.pairs);
        let line = entity.line(self.pairs);
        let own = entity.first(self.pairs, 8).map_or("0", |pair| pair.value);
        // What is on layer 0 of a block takes the layer of the insert.
        let layer = of_insert.filter(|_| own == "0").unwrap_or(own);
        if self.file.hidden.iter().any(|hidden| hidden == own) {
            self.sketch.skipped.add("entities on layers that are off or frozen", line);
            return Ok(());
        }
        if entity.number_or(self.pairs, 67, 0.0)? != 0.0 {
            self.sketch.skipped.add("entities of paper space", line);
            return Ok(());
        }
        if kind == "INSERT" {
            return self.insert(entity, map, layer, depth);
        }
        let Some(plane) = self.plane(entity, kind)? else {
            self.sketch.skipped.add("entities in planes that are tilted", line);
            return Ok(());
        };
        let Some((kind, paths)) = entity.paths(self.pairs)? else {
            self.sketch.skipped.add(&format!("{} entities", plain(kind)), line);
            return Ok(());
        };
        let map = map.after(&plane);
        let layer = self.sketch.layers.number(layer);
        let (closed, open): (Vec<Path>, Vec<Path>) =
            paths.iter().map(|path| map.path(path)).partition(|path| path.is_closed);
        for path in closed {
            self.sketch.add(Kind::Area(Fill::EvenOdd), layer, line, vec![path]);
        }
        self.sketch.add(kind, layer, line, open);
        Ok(())
    }

    /// The map of an entity's own plane: the identity, or a reflection where it is seen from below. `None` where the
    /// plane is tilted.
    fn plane(&self, entity: &Entity, kind: &str) -> Result<Option<Affine>, IoError> {
        let [x, y, z] =
            [210, 220, 230].map(|code| entity.number_or(self.pairs, code, if code == 230 { 1.0 } else { 0.0 }));
        let (x, y, z) = (x?, y?, z?);
        let is_tilted = x.abs() > 1e-9 || y.abs() > 1e-9;
        let in_world = matches!(kind, "LINE" | "POINT" | "ELLIPSE" | "SPLINE" | "3DFACE");
        Ok(match (is_tilted && !matches!(kind, "LINE" | "POINT" | "3DFACE"), z < 0.0 && !in_world) {
            (true, _) => None,
            (false, true) => Some(Affine::scale(-1.0, 1.0)),
            (false, false) => Some(Affine::IDENTITY),
        })
    }

    /// Places a block, once or in rows and columns.
    fn insert(&mut self, entity: &Entity, map: &Affine, layer: &str, depth: usize) -> Result<(), IoError> {
        let (pairs, file) = (self.pairs, self.file);
        let number = |code, default| entity.number_or(pairs, code, default);
        let line = entity.line(pairs);
        let name = entity.first(pairs, 2).map_or("", |pair| pair.value);
        let Some(block) = file.blocks.get(name) else {
            self.sketch.skipped.add("inserts of blocks that the file does not have", line);
            return Ok(());
        };
        if depth == DEEPEST {
            return Err(pairs.fault(entity.line(pairs), format!("blocks in blocks at most {DEEPEST} deep"), "more"));
        }
        let Some(plane) = self.plane(entity, "INSERT")? else {
            self.sketch.skipped.add("inserts in planes that are tilted", line);
            return Ok(());
        };
        let scale = Affine::scale(number(41, 1.0)?, number(42, 1.0)?);
        let turn = Affine::rotation(number(50, 0.0)?);
        let [columns, rows] = [number(70, 1.0)?, number(71, 1.0)?].map(|n| n.clamp(1.0, 32_767.0) as u32);
        let (dx, dy) = (number(44, 0.0)?, number(45, 0.0)?);
        let place = Affine::translation(number(10, 0.0)?, number(20, 0.0)?);
        for (column, row) in (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))) {
            let offset = Affine::translation(f64::from(column) * dx, f64::from(row) * dy);
            let own = scale.after(&Affine::translation(-block.base[0], -block.base[1]));
            let all = map.after(&plane).after(&place).after(&turn).after(&offset).after(&own);
            for inner in &block.entities {
                self.placed += 1 + inner.size();
                if self.placed > MOST_PLACED {
                    return Err(pairs.fault(line, format!("blocks with at most {MOST_PLACED} pairs in all"), "more"));
                }
                self.add(inner, &all, Some(layer), depth + 1)?;
            }
        }
        Ok(())
    }
}

/// The name of a kind of entities in a message.
fn plain(kind: &str) -> String {
    kind.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').take(24).collect()
}

/// A number of a pair.
fn number_of(pairs: &Pairs<'_>, pair: Pair<'_>) -> Result<f64, IoError> {
    let value = pair.value.parse::<f64>().ok().filter(|value| value.is_finite());
    value.ok_or_else(|| {
        pairs.fault(
            pair.line + 1,
            format!("a number for code {}", pair.code),
            crate::error::quote(pair.value.as_bytes()),
        )
    })
}
