//! The figures: one for each algorithm, on the same points and on the same polygon.

use std::error::Error;
use std::fs;
use std::path::Path;

use trimalla::delaunay::Delaunay;
use trimalla::drawing::Pslg;
use trimalla::dual::Voronoi;
use trimalla::geometry::{BoundingBox, Point, math};
use trimalla::interpolate::{Levels, Surface};
use trimalla::polygon::{Polygon, TrapezoidMap, Visibility, monotone_pieces};
use trimalla::trace::NoTrace;
use trimalla::{ByMethod, DomainOptions, Method, triangulate_by};
use trimalla_io::{Format, Overlay, PictureOptions, WriteOptions, write_mesh_to, write_pslg_to};

type Done = Result<(), Box<dyn Error>>;

/// Points with heights, seeded.
pub(crate) fn points() -> Pslg {
    let mut state = 7_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 40) as u32) / f64::from(1 << 24)
    };
    // On an ellipse, so that no triangle is flat for the sake of the hull; and inside.
    let rim = (0..10).map(|i| (f64::from(i) * std::f64::consts::PI / 5.0, 1.0)).collect::<Vec<_>>();
    let inside = (0..14).map(|_| (2.0 * std::f64::consts::PI * next(), 0.85 * next().sqrt()));
    let place = |(angle, radius): (f64, f64)| {
        Point::new(80.0 + 80.0 * radius * math::cos(angle), 50.0 + 50.0 * radius * math::sin(angle))
    };
    let points: Vec<Point> = inside.chain(rim).map(place).collect();
    let height = |p: &Point| 40.0 * math::sin(p.x / 30.0) * math::cos(p.y / 25.0) + 0.2 * p.x;
    let point_attributes = points.iter().map(height).collect();
    Pslg { points, attributes_per_point: 1, point_attributes, ..Pslg::default() }
}

/// An outline with bays, and a hole.
fn rings() -> [Vec<[f64; 2]>; 2] {
    let outline = [
        [0.0, 0.0],
        [30.0, 18.0],
        [62.0, 4.0],
        [70.0, 30.0],
        [108.0, 2.0],
        [150.0, 12.0],
        [132.0, 40.0],
        [158.0, 70.0],
        [120.0, 62.0],
        [112.0, 96.0],
        [88.0, 66.0],
        [62.0, 100.0],
        [50.0, 74.0],
        [18.0, 92.0],
        [26.0, 52.0],
        [4.0, 44.0],
    ];
    let hole = [[58.0, 44.0], [84.0, 36.0], [96.0, 50.0], [70.0, 58.0]];
    [outline.to_vec(), hole.to_vec()]
}

/// Writes all of them.
pub(crate) fn write_all(folder: &Path) -> Done {
    let [outline, hole] = rings();
    let (whole, simple) = (Pslg::of_rings([outline.clone(), hole]), Pslg::of_ring(outline));
    let nested = DomainOptions { rule: trimalla::domain::DomainRule::Nesting, ..DomainOptions::default() };
    for method in Method::all().filter(|method| *method != Method::Conforming) {
        let (drawing, options) = match method {
            Method::Polygon(_) if method.key() == "diagonals" => (&simple, nested),
            Method::Polygon(_) => (&whole, nested),
            _ => (&points(), DomainOptions::default()),
        };
        match triangulate_by(drawing, method, &options, 0, &mut NoTrace) {
            Ok(made) => mesh(folder, method.key(), &made)?,
            // Some algorithms take domains only.
            Err(_) => mesh(folder, method.key(), &triangulate_by(&simple, method, &nested, 0, &mut NoTrace)?)?,
        }
    }
    of_the_polygon(folder, &whole)?;
    of_the_points(folder, &points())
}

/// Pieces, trapezoids, and what a point sees.
fn of_the_polygon(folder: &Path, whole: &Pslg) -> Done {
    let ends = [16, 20];
    let polygon = Polygon::new(&whole.points, &ends)?;
    let pieces = monotone_pieces(polygon, &mut NoTrace)?;
    let diagonals = pieces.diagonals.iter().map(|diagonal| diagonal.ends);
    let divided = Pslg { segments: whole.segments.iter().copied().chain(diagonals).collect(), ..whole.clone() };
    drawing(folder, "pieces", &divided)?;
    let mut map = whole.clone();
    for chord in TrapezoidMap::new(polygon, 0, &mut NoTrace)?.chords() {
        add_line(&mut map, [whole.points[chord.from as usize], chord.at]);
    }
    drawing(folder, "trapezoids", &map)?;
    let from = Point::new(40.0, 40.0);
    let corners = Visibility::new(polygon, &mut NoTrace)?.seen_from(from, &mut NoTrace)?;
    drawing_with(folder, "visibility", whole, Overlay::default().with_view(from, &corners))
}

/// The Voronoi diagram and contour lines.
fn of_the_points(folder: &Path, cloud: &Pslg) -> Done {
    let delaunay = Delaunay::new(&cloud.points)?;
    let bounds = BoundingBox::of(cloud.points.iter().copied()).unwrap_or_default();
    let clipped = Voronoi::new(&delaunay).clipped_to_box(bounds)?;
    let mut diagram = Pslg { points: clipped.points().to_vec(), segments: clipped.sides(), ..Pslg::default() };
    diagram.points.extend(&cloud.points);
    drawing(folder, "diagram", &diagram)?;
    let surface = Surface::new(&delaunay, &cloud.point_attributes)?;
    let mut lines = Pslg { points: cloud.points.clone(), ..Pslg::default() };
    for contour in surface.contours(&Levels::Every(10.0))? {
        let ends = contour.points.windows(2).map(|pair| [pair[0], pair[1]]);
        ends.for_each(|ends| add_line(&mut lines, ends));
    }
    drawing(folder, "contours", &lines)
}

fn add_line(drawing: &mut Pslg, ends: [Point; 2]) {
    let first = drawing.points.len() as u32;
    drawing.points.extend(ends);
    drawing.segments.push([first, first + 1]);
}

fn mesh(folder: &Path, name: &str, made: &ByMethod) -> Done {
    let overlay = made.gallery.as_ref().map(|gallery| Overlay::of_gallery(&made.mesh.points, gallery));
    let picture = PictureOptions::default().with_vertices(true).with_legend(false);
    let picture = picture.with_overlay(overlay.unwrap_or_default());
    let mut file = fs::File::create(folder.join(format!("{name}.svg")))?;
    Ok(write_mesh_to(&mut file, Format::Svg, &made.mesh, &WriteOptions::default().with_picture(picture))?)
}

fn drawing(folder: &Path, name: &str, drawing: &Pslg) -> Done {
    drawing_with(folder, name, drawing, Overlay::default())
}

fn drawing_with(folder: &Path, name: &str, drawing: &Pslg, overlay: Overlay) -> Done {
    let picture = PictureOptions::default().with_only_lone_vertices(true).with_legend(false).with_overlay(overlay);
    let mut file = fs::File::create(folder.join(format!("{name}.svg")))?;
    Ok(write_pslg_to(&mut file, Format::Svg, drawing, &WriteOptions::default().with_picture(picture))?)
}
