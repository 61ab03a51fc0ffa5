//! Smaller inputs with the same kind of fault: parts are left out as long as the fault stays.

use std::time::{Duration, Instant};

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::refine::NamedOptions;
use trimalla_io::recipe;

use crate::input::{Case, Edit, FileCase, Input};

/// Looks for a smaller input with the same kind of fault, until nothing can be left out or time is up.
///
/// `kind_of` tries an input and names the kind of its fault.
pub fn reduced(input: &Input, time: Duration, kind_of: &mut dyn FnMut(&Input) -> Option<String>) -> Input {
    let Some(kind) = kind_of(input) else { return input.clone() };
    let end = Instant::now() + time;
    let mut best = input.clone();
    let mut fails = |candidate: &Input| Instant::now() < end && kind_of(candidate).as_deref() == Some(&kind);
    loop {
        let before = best.clone();
        match &before {
            Input::Drawing(_) => of_drawing(&mut best, &mut fails),
            Input::File(_) => of_file(&mut best, &mut fails),
        }
        if best == before || Instant::now() >= end {
            return best;
        }
    }
}

type Fails<'a> = &'a mut dyn FnMut(&Input) -> bool;

/// Leaves out runs of items, long ones first; `without` makes an input without the items of a range.
fn drop_runs(
    best: &mut Input,
    count: impl Fn(&Input) -> usize,
    without: impl Fn(&Input, usize, usize) -> Input,
    fails: Fails<'_>,
) {
    let mut run = count(best).div_ceil(2);
    while run > 0 {
        let mut from = 0;
        while from < count(best) {
            let candidate = without(best, from, (from + run).min(count(best)));
            if fails(&candidate) {
                *best = candidate;
            } else {
                from += run;
            }
        }
        run = if run == 1 { 0 } else { run.div_ceil(2) };
    }
}

fn of_file(best: &mut Input, fails: Fails<'_>) {
    let bytes = |input: &Input| match input {
        Input::File(file) => file.bytes.clone(),
        Input::Drawing(_) => Vec::new(),
    };
    let with = |input: &Input, bytes: Vec<u8>| match input {
        Input::File(file) => Input::File(FileCase { bytes, ..file.clone() }),
        other => other.clone(),
    };
    drop_runs(best, |i| bytes(i).len(), |i, from, to| with(i, [&bytes(i)[..from], &bytes(i)[to..]].concat()), fails);
}

fn case(input: &Input) -> Case {
    match input {
        Input::Drawing(case) => (**case).clone(),
        Input::File(_) => Case::of(Pslg::default()),
    }
}

fn drawn(case: Case) -> Input {
    Input::Drawing(Box::new(case))
}

/// A list without a range.
fn cut<T: Clone>(list: &[T], from: usize, to: usize) -> Vec<T> {
    [&list[..from], &list[to..]].concat()
}

fn of_drawing(best: &mut Input, fails: Fails<'_>) {
    drop_runs(
        best,
        |i| case(i).edits.len(),
        |i, from, to| {
            let c = case(i);
            drawn(Case { edits: cut(&c.edits, from, to), ..c })
        },
        fails,
    );
    drop_runs(
        best,
        |i| case(i).drawing.segments.len(),
        |i, from, to| {
            let mut c = case(i);
            c.drawing.segments = cut(&c.drawing.segments, from, to);
            if !c.drawing.segment_markers.is_empty() {
                c.drawing.segment_markers = cut(&c.drawing.segment_markers, from, to);
            }
            drawn(c)
        },
        fails,
    );
    drop_runs(best, |i| case(i).drawing.points.len(), |i, from, to| drawn(without_points(case(i), from, to)), fails);
    for candidate in simpler(&case(best)) {
        let candidate = drawn(candidate);
        if fails(&candidate) {
            *best = candidate;
        }
    }
    lines_of_recipe(best, fails);
    rounder(best, fails);
}

/// Points of a range and the segments at them left out; numbers follow.
fn without_points(mut c: Case, from: usize, to: usize) -> Case {
    let gone = |v: u32| (from..to).contains(&(v as usize));
    let new = |v: u32| if (v as usize) < to { v } else { v - (to - from) as u32 };
    let d = &mut c.drawing;
    let kept: Vec<usize> = (0..d.segments.len()).filter(|&s| !d.segments[s].iter().any(|&v| gone(v))).collect();
    if !d.segment_markers.is_empty() {
        d.segment_markers = kept.iter().map(|&s| d.segment_markers[s]).collect();
    }
    d.segments = kept.iter().map(|&s| d.segments[s].map(new)).collect();
    let width = d.attributes_per_point;
    d.points = cut(&d.points, from, to);
    if !d.point_markers.is_empty() {
        d.point_markers = cut(&d.point_markers, from, to);
    }
    d.point_attributes = cut(&d.point_attributes, from * width, to * width);
    c.edits = c.edits.iter().filter_map(|&e| renumbered(e, &gone, &new)).collect();
    // The budget counts vertices.
    c.recipe.max_vertices = c.recipe.max_vertices.map(|m| m.saturating_sub(to - from));
    c
}

fn renumbered(edit: Edit, gone: &dyn Fn(u32) -> bool, new: &dyn Fn(u32) -> u32) -> Option<Edit> {
    Some(match edit {
        Edit::Remove(v) | Edit::Move(v, _) | Edit::Merge(v) if gone(v) => return None,
        Edit::InsertSegment(a, b) if gone(a) || gone(b) => return None,
        Edit::Remove(v) => Edit::Remove(new(v)),
        Edit::Move(v, p) => Edit::Move(new(v), p),
        Edit::Merge(v) => Edit::Merge(new(v)),
        Edit::InsertSegment(a, b) => Edit::InsertSegment(new(a), new(b)),
        other => other,
    })
}

/// The case with one thing at its default; nothing here may take another step back, or both would be taken for ever.
fn simpler(c: &Case) -> Vec<Case> {
    let plain = Case::of(c.drawing.clone());
    let bare = Pslg { points: c.drawing.points.clone(), segments: c.drawing.segments.clone(), ..Pslg::default() };
    let mut all = vec![
        Case { drawing: Pslg { holes: c.drawing.holes.clone(), ..bare.clone() }, ..c.clone() },
        Case { drawing: bare, ..c.clone() },
        Case { cancel: None, ..c.clone() },
        Case { domain: trimalla::DomainOptions { algorithm: plain.domain.algorithm, ..c.domain }, ..c.clone() },
        Case { domain: trimalla::DomainOptions { crossings: plain.domain.crossings, ..c.domain }, ..c.clone() },
        Case { domain: trimalla::DomainOptions { rule: trimalla::domain::DomainRule::Hull, ..c.domain }, ..c.clone() },
    ];
    for fewer in [2, 8] {
        let most =
            c.recipe.max_vertices.map(|m| c.drawing.points.len() + m.saturating_sub(c.drawing.points.len()) / fewer);
        let mut less = c.clone();
        less.recipe.max_vertices = most;
        all.push(less);
    }
    all.retain(|other| other != c);
    all
}

/// Lines of the recipe left out one by one.
fn lines_of_recipe(best: &mut Input, fails: Fails<'_>) {
    let lines = |input: &Input| {
        let mut text = Vec::new();
        let _ = recipe::write(&mut text, &case(input).recipe);
        String::from_utf8_lossy(&text).lines().map(str::to_owned).collect::<Vec<String>>()
    };
    let mut at = 0;
    while at < lines(best).len() {
        let text = cut(&lines(best), at, at + 1).join("\n");
        // The budget stays: the default one is millions of vertices.
        let max_vertices = case(best).recipe.max_vertices;
        let with_budget = |recipe: NamedOptions| NamedOptions { max_vertices, ..recipe };
        let candidate = recipe::read(text.as_bytes(), "less").map(with_budget);
        match candidate.map(|recipe| drawn(Case { recipe, ..case(best) })) {
            Ok(candidate) if candidate != *best && fails(&candidate) => *best = candidate,
            _ => at += 1,
        }
    }
}

/// Coordinates moved to the origin, rounded to few digits: all of them, then one by one.
fn rounder(best: &mut Input, fails: Fails<'_>) {
    let mapped = |c: &Case, f: &dyn Fn(usize, Point) -> Point| {
        let mut c = c.clone();
        c.drawing.points = c.drawing.points.iter().enumerate().map(|(i, &p)| f(i, p)).collect();
        drawn(c)
    };
    let least = |of: fn(&Point) -> f64| case(best).drawing.points.iter().map(of).fold(f64::INFINITY, f64::min);
    let corner = Point::new(least(|p| p.x), least(|p| p.y));
    let mut candidates = vec![mapped(&case(best), &|_, p| Point::new(p.x - corner.x, p.y - corner.y))];
    for digits in [1, 2, 3, 6, 9, 12] {
        candidates.push(mapped(&case(best), &|_, p| Point::new(rounded(p.x, digits), rounded(p.y, digits))));
    }
    for candidate in candidates {
        if is_finite(&candidate) && candidate != *best && fails(&candidate) {
            *best = candidate;
            break;
        }
    }
    for v in 0..case(best).drawing.points.len() {
        for digits in [1, 2, 3, 6] {
            let candidate = mapped(&case(best), &|i, p| {
                if i == v { Point::new(rounded(p.x, digits), rounded(p.y, digits)) } else { p }
            });
            if candidate == *best {
                break;
            }
            if fails(&candidate) {
                *best = candidate;
                break;
            }
        }
    }
}

/// NaN is not equal to itself: with it, nothing would come to an end.
fn is_finite(input: &Input) -> bool {
    case(input).drawing.points.iter().all(|p| p.is_finite())
}

/// A number with so many digits.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}
