//! `trimalla visible`: what a point of a domain sees.

use std::fmt::Write as _;
use std::time::Instant;

use clap::Args;
use serde_json::json;
use trimalla::delaunay::AlgorithmKey;
use trimalla::geometry::{Point, Ring};
use trimalla::polygon::{PolygonError, SeenCorner};
use trimalla::trace::NoTrace;
use trimalla::{DomainPolygon, IndexedMesh, Pslg};
use trimalla_io::Overlay;

use crate::args::{DrawingOptions, OutputOptions, ReportOptions};
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing};
use crate::outputs::{self, Outputs};
use crate::{drawing_faults, json, progress, text};

const HELP: &str = "\
Examples:
  trimalla visible plan.poly --from 2,3 -o seen.svg
  trimalla visible plan.poly --from 2,3 --to 8,3 --to 9,9
  trimalla visible plan.poly --from 2,3 -o seen.poly -o seen.csv

The boundary belongs to the domain: a line of sight may touch a vertex, run along a side and end on the
boundary. What is inside the domain, points and segments, hides nothing. Whether --to is seen is exact; so
is which corners the visibility polygon has. A corner that is no vertex is where the line past a vertex
meets a side; its coordinates are rounded. What is seen along a line only has no area, and is left out of
the polygon, though --to may lie on it. Parts of a domain that meet only in a vertex do not see each other.

A picture (.svg, .png) shows the domain and the visibility polygon in it. A drawing (.poly) is the visibility
polygon alone, so that it can be triangulated or meshed. A table (.csv) has the columns x, y, kind, vertex,
side_from, side_to, a line for each corner, counter-clockwise: kind is 'vertex', 'side' with the vertex past which
the place is seen, or 'viewpoint' where --from is on the boundary.";

/// Find what a point of a domain sees: its visibility polygon, and whether other points are visible
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    drawing: DrawingOptions,

    /// The point that looks around
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = point)]
    from: Point,

    /// Say whether this point is seen; may be given several times
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = point)]
    to: Vec<Point>,

    #[command(flatten)]
    output: OutputOptions,

    #[command(flatten)]
    report: ReportOptions,
}

/// Two numbers with a comma between them.
fn point(text: &str) -> Result<Point, String> {
    let numbers = text.split_once(',').and_then(|(x, y)| Some([x.trim().parse().ok()?, y.trim().parse().ok()?]));
    let point = numbers.map(|[x, y]: [f64; 2]| Point::new(x, y)).filter(|p| p.is_finite());
    point.ok_or_else(|| "two finite numbers with a comma between them are needed, such as 2.5,-3".to_owned())
}

/// What was found.
struct View {
    from: Point,
    /// The corners of the visibility polygons, one for each part of the domain that the point is in.
    seen: Vec<Vec<SeenCorner>>,
    /// The points that were asked about, and whether they are seen.
    sights: Vec<(Point, bool)>,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    outputs::recover(&options.output.output, options.report.quiet);
    let drawing = read_drawing(&options.drawing.input, options.drawing.import())?;
    let outputs = Outputs::sparing(drawing.files.clone()).with_lines(&options.output, &drawing)?;
    let stream = outputs.report_stream(&options.report)?;
    let names = drawing.numbers();
    let start = Instant::now();
    let domain = options.drawing.domain_options(AlgorithmKey::default());
    let made = trimalla::triangulate(&drawing.value, &domain);
    let made = made.map_err(|error| drawing_faults::failure(&names, &error))?;
    let view = look(&made.mesh, options).map_err(|error| Failure::bad_input(error.to_string()))?;
    if view.seen.is_empty() {
        let message = format!("{} is outside of the domain of {}", view.from, drawing.name());
        return Err(Failure::bad_input(message).hint("--domain says what belongs to the domain"));
    }
    let seconds = start.elapsed().as_secs_f64();
    let warnings: Vec<_> =
        drawing.notes.iter().cloned().chain(made.warnings.iter().map(|w| names.warning(w))).collect();
    options.report.warn(&warnings);
    progress::begin_writing()?;
    let overlay = overlay(&made.mesh, &view);
    let outputs = outputs.with_pictures(|picture| picture.with_overlay(overlay.clone()));
    let prepared = outputs.prepare_lines(&view.drawing(), &table(&view, &drawing))?;
    let [area, of] = [view.area(), area_of(&made.mesh)];
    if options.report.json {
        let to = |&(at, is_seen): &(Point, bool)| json!({ "at": [at.x, at.y], "visible": is_seen });
        json::print(&json!({
            "from": [view.from.x, view.from.y],
            "corners": view.corners().count(),
            "area": area,
            "domain_area": of,
            "to": view.sights.iter().map(to).collect::<Vec<_>>(),
            "seconds": seconds,
            "warnings": warnings,
        }))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        lines.heading(text::of_drawing(&drawing));
        lines.row("from", view.from);
        lines.row("sees", format_args!("{} corners, area {area} of {of}", view.corners().count()));
        for (at, is_seen) in &view.sights {
            lines.row("to", format_args!("{at}: {}", if *is_seen { "visible" } else { "not visible" }));
        }
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}

/// Looks around in every part of the domain.
fn look(domain: &IndexedMesh, options: &Options) -> Result<View, PolygonError> {
    let mut view =
        View { from: options.from, seen: Vec::new(), sights: options.to.iter().map(|&at| (at, false)).collect() };
    for part in DomainPolygon::all_of(domain) {
        let corners = part.seen_from(view.from, &mut NoTrace)?;
        view.seen.extend((!corners.is_empty()).then_some(corners));
        for (at, is_seen) in &mut view.sights {
            *is_seen |= part.is_visible(view.from, *at)?;
        }
    }
    Ok(view)
}

impl View {
    fn corners(&self) -> impl Iterator<Item = &SeenCorner> {
        self.seen.iter().flatten()
    }

    fn area(&self) -> f64 {
        let of_ring = |ring: &Vec<SeenCorner>| {
            let corners: Vec<Point> = ring.iter().map(SeenCorner::at).collect();
            Ring::new(&corners).signed_area()
        };
        self.seen.iter().map(of_ring).sum()
    }

    /// The visibility polygon as a drawing.
    fn drawing(&self) -> Pslg {
        let mut drawing = Pslg::default();
        for ring in &self.seen {
            let mut corners: Vec<Point> = ring.iter().map(SeenCorner::at).collect();
            corners.dedup();
            if corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            drawing.add_ring(corners);
        }
        drawing
    }
}

fn area_of(domain: &IndexedMesh) -> f64 {
    let corners = domain.triangles.iter().map(|t| t.map(|v| domain.points[v as usize]));
    corners.map(|corners| Ring::new(&corners).signed_area()).sum()
}

/// The boundary of the domain, what is seen of it, and lines of sight.
fn overlay(domain: &IndexedMesh, view: &View) -> Overlay {
    let sides = domain.boundary_edges().into_iter().map(|ends| ends.map(|v| domain.points[v as usize]));
    let overlay = Overlay::default().with_lines(sides);
    let overlay = view.seen.iter().fold(overlay, |overlay, seen| overlay.with_view(view.from, seen));
    view.sights.iter().fold(overlay, |overlay, &(at, is_seen)| overlay.with_sight(view.from, at, is_seen))
}

/// Comma-separated values.
fn table<T>(view: &View, drawing: &Input<T>) -> String {
    let mut table = String::from("x,y,kind,vertex,side_from,side_to\n");
    let number = |vertex: u32| drawing.number(vertex as usize);
    for corner in view.corners() {
        let what = match *corner {
            SeenCorner::Viewpoint(_) => "viewpoint,,,".to_owned(),
            SeenCorner::Vertex { vertex, .. } => format!("vertex,{},,", number(vertex)),
            SeenCorner::OnSide { side: [a, b], past, .. } => {
                format!("side,{},{},{}", number(past), number(a), number(b))
            }
        };
        let Point { x, y } = corner.at();
        let _ = writeln!(table, "{x},{y},{what}");
    }
    table
}
