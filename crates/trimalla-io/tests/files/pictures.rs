//! Pictures: well-formed, the same every time, small, and possible for every mesh.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use crate::common::{POLY, grid, hard_mesh, hard_pslg, read_poly, scaled};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla_io::bars::{Bar, BarChart};
use trimalla_io::svg::{draw_mesh, draw_pslg};
use trimalla_io::{Overlay, PictureOptions};

fn picture(mesh: &IndexedMesh, options: &PictureOptions) -> String {
    let mut bytes = Vec::new();
    draw_mesh(&mut bytes, mesh, options).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    check(&text);
    text
}

/// Elements are closed, and no number has become anything else.
fn check(text: &str) {
    assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"), "{text}");
    assert!(!text.contains("NaN") && !text.contains("\"inf"), "{text}");
    for path in text.split(" d=\"").skip(1) {
        let path = path.split('"').next().unwrap_or_default();
        assert!(path.chars().all(|c| "Mmlhvaz0123456789.- ".contains(c)), "{path}");
    }
    for element in ["svg", "g", "text", "title"] {
        let opened = text.matches(&format!("<{element}>")).count() + text.matches(&format!("<{element} ")).count();
        assert_eq!(opened, text.matches(&format!("</{element}>")).count(), "{element}");
    }
}

#[test]
fn every_mesh_has_a_picture() {
    let point = IndexedMesh { points: vec![Point::new(3.0, 4.0)], ..IndexedMesh::default() };
    let flat = IndexedMesh { triangles: vec![[0, 0, 0]], ..point.clone() };
    for mesh in
        [IndexedMesh::default(), point, flat, hard_mesh(), grid(3), scaled(1e300), scaled(f64::MAX), scaled(1e-320)]
    {
        for options in [
            PictureOptions::default(),
            PictureOptions::default().with_title("<&>").with_vertices(true).with_legend(false),
        ] {
            picture(&mesh, &options);
        }
    }
}

#[test]
fn every_drawing_has_a_picture() {
    for pslg in [Pslg::default(), hard_pslg(), read_poly(POLY.as_bytes(), "p").unwrap()] {
        let mut bytes = Vec::new();
        draw_pslg(&mut bytes, &pslg, &PictureOptions::default().with_title("drawing")).unwrap();
        check(&String::from_utf8(bytes).unwrap());
    }
}

#[test]
fn the_same_mesh_has_the_same_picture() {
    let options = PictureOptions::default().with_title("grid");
    assert_eq!(picture(&grid(9), &options), picture(&grid(9), &options));
}

#[test]
fn size_does_not_show_in_colours() {
    let mut large = grid(5);
    large.points.iter_mut().for_each(|p| *p = Point::new(p.x * 2.0_f64.powi(900), p.y * 2.0_f64.powi(900)));
    assert_eq!(picture(&grid(5), &PictureOptions::default()), picture(&large, &PictureOptions::default()));
}

#[test]
fn pictures_are_small() {
    let mesh = grid(100);
    let text = picture(&mesh, &PictureOptions::default());
    let bytes_a_triangle = text.len() / mesh.triangles.len();
    assert!(bytes_a_triangle < 36, "{bytes_a_triangle}");
    assert!(text.matches("<path").count() < 40, "one path a class");
}

#[test]
fn charts_stand_below_the_picture_and_change_nothing_in_it() {
    let plain = picture(&grid(4), &PictureOptions::default());
    let mut charts: Vec<BarChart> =
        (0..20).map(|i| BarChart::of_counts("a < b", [("first", 3 * i), ("second & last", 5)])).collect();
    let odd = [f64::NAN, f64::INFINITY, -1.0].map(|size| Bar { label: "?".to_owned(), size, value: "?".to_owned() });
    charts.push(BarChart { title: "odd".to_owned(), bars: odd.to_vec() });
    let text = picture(&grid(4), &PictureOptions::default().with_charts(charts));
    assert_eq!(text.matches("second &amp; last").count(), 20);
    // The frame and the sheet's size come first; then the picture is the same, and the charts follow.
    let inner = |text: &str| text.lines().skip(2).collect::<Vec<_>>().join("\n");
    assert!(inner(&text).starts_with(inner(&plain).trim_end_matches("</svg>")));
    let height = |text: &str| -> f64 {
        let view = text.split("viewBox=\"0 0 ").nth(1).and_then(|t| t.split('"').next()).unwrap();
        view.split(' ').nth(1).unwrap().parse().unwrap()
    };
    assert!(height(&text) > height(&plain) + 100.0);
}

#[test]
fn an_overlay_is_painted_in_place_of_triangles() {
    use trimalla::polygon::{Polygon, SeenCorner, art_gallery};
    use trimalla::trace::NoTrace;
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]].map(Point::from);
    let gallery = art_gallery(Polygon::new(&points, &[5]).unwrap(), &mut NoTrace).unwrap();
    let mesh = IndexedMesh { triangles: gallery.triangles.clone(), points: points.to_vec(), ..IndexedMesh::default() };
    let view = [0, 1, 3].map(|v| SeenCorner::Vertex { vertex: v, at: points[v as usize] });
    let overlay = Overlay::of_gallery(&points, &gallery).with_view(Point::new(1.0, 0.5), &view);
    let text = picture(&mesh, &PictureOptions::default().with_overlay(overlay.clone()));
    assert!(text.contains(">guards<") && text.contains(">corners seen<") && !text.contains("<g stroke"), "{text}");
    let mut pixels = Vec::new();
    trimalla_io::png::draw_mesh(&mut pixels, &mesh, &PictureOptions::default().with_overlay(overlay)).unwrap();
    let mut plain = Vec::new();
    trimalla_io::png::draw_mesh(&mut plain, &mesh, &PictureOptions::default()).unwrap();
    assert_ne!(pixels, plain);
    // Of a gallery of other points nothing is painted.
    assert_eq!(Overlay::of_gallery(&points[..0], &gallery), Overlay::of_gallery(&[], &gallery));
    picture(&IndexedMesh::default(), &PictureOptions::default().with_overlay(Overlay::of_gallery(&[], &gallery)));
}
