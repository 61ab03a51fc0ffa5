//! Drawings of other programs: what becomes of shapes, and where faults are.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]
#![allow(clippy::print_stderr, reason = "a skipped test says so")]

use trimalla::domain::DomainRule;
use trimalla::geometry::Point;
use trimalla::{DomainOptions, Pslg, triangulate};
use trimalla_io::drawings::{DrawingFormat, DrawingOptions, Drawn, Rings, read};
use trimalla_io::{Files, Memory, read_pslg};

fn drawn(format: DrawingFormat, text: &str, options: &DrawingOptions) -> Drawn {
    read(text.as_bytes(), format, "f", None, options).unwrap_or_else(|error| panic!("{error}"))
}

fn plain(format: DrawingFormat, text: &str) -> Drawn {
    drawn(format, text, &DrawingOptions::default())
}

/// The area of the domain, and the areas by the attribute of its triangles.
fn areas(pslg: &Pslg) -> (f64, Vec<(f64, f64)>) {
    let mesh = triangulate(pslg, &DomainOptions::default()).unwrap_or_else(|error| panic!("{error}")).mesh;
    let mut by_attribute: Vec<(f64, f64)> = Vec::new();
    let mut total = 0.0;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|v| mesh.points[v as usize]);
        let area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
        total += area;
        let attribute = mesh.triangle_attributes.get(t).copied().unwrap_or_default();
        match by_attribute.iter_mut().find(|(known, _)| *known == attribute) {
            Some((_, sum)) => *sum += area,
            None => by_attribute.push((attribute, area)),
        }
    }
    by_attribute.sort_by(|a, b| a.0.total_cmp(&b.0));
    (total, by_attribute)
}

fn refused(format: DrawingFormat, text: &str) -> String {
    read(text.as_bytes(), format, "f", None, &DrawingOptions::default()).unwrap_err().to_string()
}

const NEIGHBOURS: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"use": 20, "name": "a"},
 "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},
{"type": "Feature", "properties": {"use": 10, "name": "b"},
 "geometry": {"type": "Polygon", "coordinates": [[[4,0],[9,0],[9,4],[4,4],[4,0]]]}},
{"type": "Feature", "properties": {"use": 20, "name": "c"},
 "geometry": {"type": "Polygon", "coordinates": [[[4,4],[9,4],[9,9],[4,9],[4,4]],[[5,5],[6,5],[6,6],[5,6],[5,5]]]}}]}"#;

#[test]
fn neighbours_share_one_segment_and_are_two_regions() {
    let found = drawn(DrawingFormat::GeoJson, NEIGHBOURS, &DrawingOptions::default().with_property("use"));
    assert_eq!((found.pslg.points.len(), found.pslg.segments.len()), (12, 14));
    let shared = |p: Point, q: Point| {
        found.pslg.segments.iter().filter(|ends| ends.map(|v| found.pslg.points[v as usize]) == [p, q]).count()
    };
    assert_eq!(shared(Point::new(4.0, 0.0), Point::new(4.0, 4.0)), 1);
    let (total, by_use) = areas(&found.pslg);
    assert_eq!((total, by_use), (16.0 + 20.0 + 24.0, vec![(10.0, 20.0), (20.0, 40.0)]));
    assert_eq!(found.pslg.holes.len(), 1);
    // Without a property each feature is a region.
    let (_, by_feature) = areas(&plain(DrawingFormat::GeoJson, NEIGHBOURS).pslg);
    assert_eq!(by_feature, [(1.0, 16.0), (2.0, 20.0), (3.0, 24.0)]);
}

#[test]
fn rings_nest_join_or_stand_each_for_itself() {
    // A square in a square, both counter-clockwise, and one that overlaps the outer one.
    let nested = "<svg xmlns='http://www.w3.org/2000/svg'><rect width='9' height='9'/>\
                  <rect x='3' y='3' width='3' height='3' fill='red'/></svg>";
    let by = |text, rings| areas(&drawn(DrawingFormat::Svg, text, &DrawingOptions::default().with_rings(rings)).pslg);
    assert_eq!(by(nested, Rings::EvenOdd).0, 72.0);
    assert_eq!(by(nested, Rings::NonZero).0, 81.0);
    assert_eq!(by(nested, Rings::Each), (81.0, vec![(1.0, 72.0), (2.0, 9.0)]));
    let crossing = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0h4v4h-4z M2 2h4v4h-4z'/></svg>";
    let split = |rings| {
        let found = drawn(DrawingFormat::Svg, crossing, &DrawingOptions::default().with_rings(rings)).pslg;
        let options = DomainOptions { crossings: trimalla::constrained::Crossings::Split, ..DomainOptions::default() };
        triangulate(&found, &options).unwrap().mesh.triangles.len()
    };
    assert_eq!(split(Rings::NonZero), 10, "two outlines that overlap are joined");
    assert_eq!(split(Rings::Each), 10, "a path fills what its rings wind around");
}

/// Pairs of codes and values as lines.
fn dxf(entities: &str) -> String {
    let body: String = entities.split_whitespace().map(|word| format!("{word}\n")).collect();
    format!("0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n")
}

#[test]
fn lines_and_arcs_of_a_dxf_close_though_their_ends_are_computed() {
    let slot = dxf("0 LINE 8 A 10 0.1 20 0.3 11 10.1 21 0.3  0 LINE 8 A 10 0.1 20 5.3 11 10.1 21 5.3 \
                    0 ARC 8 A 10 10.1 20 2.8 40 2.5 50 270 51 90  0 ARC 8 A 10 0.1 20 2.8 40 2.5 50 90 51 270 \
                    0 CIRCLE 8 B 10 5 20 2.8 40 1");
    let found = drawn(DrawingFormat::Dxf, &slot, &DrawingOptions::default().with_tolerance(1e-4));
    let (total, _) = areas(&found.pslg);
    let exact = 50.0 + (2.5 * 2.5 - 1.0) * std::f64::consts::PI;
    assert!((total - exact).abs() < 1e-2 && total < exact, "{total} {exact}");
    assert!(found.told.iter().any(|line| line.contains("2 curves") || line.contains("3 curves")), "{:?}", found.told);
    // The circle is a region with its own rule, and a hole by default.
    assert_eq!(found.pslg.holes.len(), 1);
    let each = drawn(DrawingFormat::Dxf, &slot, &DrawingOptions::default().with_rings(Rings::Each));
    assert_eq!(each.pslg.regions.len(), 2);
}

#[test]
fn rooms_inside_a_floor_plan_of_lines_stay() {
    let plan = dxf("0 LINE 10 0 20 0 11 9 21 0  0 LINE 10 9 20 0 11 9 21 9  0 LINE 10 9 20 9 11 0 21 9 \
                    0 LINE 10 0 20 9 11 0 21 0  0 LINE 10 4 20 0 11 4 21 9  0 LINE 10 0 20 4 11 4 21 4 \
                    0 CIRCLE 10 7 20 7 40 1");
    let (total, _) = areas(&plain(DrawingFormat::Dxf, &plan).pslg);
    assert!(total < 81.0 - 3.0 && total > 81.0 - std::f64::consts::PI - 1e-9, "the column is a hole: {total}");
}

#[test]
fn blocks_are_placed_scaled_turned_and_in_rows() {
    let text = "0 SECTION 2 BLOCKS 0 BLOCK 2 SQUARE 10 1 20 1 0 LWPOLYLINE 8 0 70 1 10 1 20 1 10 2 20 1 10 2 20 2 10 1 20 2 \
                0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 8 C 2 SQUARE 10 0 20 0 41 2 42 3 50 90 70 3 44 10 \
                0 INSERT 8 D 2 MISSING 10 0 20 0 0 ENDSEC 0 EOF";
    let lines: String = text.split_whitespace().map(|word| format!("{word}\n")).collect();
    let found = plain(DrawingFormat::Dxf, &lines);
    assert_eq!(areas(&found.pslg).0, 18.0);
    // Three columns along the turned x axis.
    let highest = found.pslg.points.iter().map(|p| p.y).fold(0.0, f64::max);
    let leftmost = found.pslg.points.iter().map(|p| p.x).fold(0.0, f64::min);
    assert_eq!((highest, leftmost), (22.0, -3.0));
    assert!(
        found.notes[0].to_string().contains("1 inserts of blocks that the file does not have skipped"),
        "{:?}",
        found.notes
    );
}

#[test]
fn shapes_of_svg_have_their_size() {
    let area = |shape: &str| {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg'>{shape}</svg>");
        areas(&drawn(DrawingFormat::Svg, &text, &DrawingOptions::default().with_tolerance(1e-6)).pslg).0
    };
    let pi = std::f64::consts::PI;
    let cases = [
        ("<circle cx='3' cy='4' r='2'/>", 4.0 * pi),
        ("<ellipse rx='2' ry='1' transform='rotate(30) scale(2)'/>", 8.0 * pi),
        ("<rect width='10' height='6' rx='2'/>", 60.0 - (4.0 - pi) * 4.0),
        ("<path d='M0 0 A5 5 0 0 1 10 0 Z'/>", 12.5 * pi),
        ("<path d='m0,0 l4,0 0,4 h-4 z m1,1 v2 h2 v-2 z'/>", 12.0),
        ("<path d='M0 0 C0 4 4 4 4 0 z'/>", 2.4 * 4.0),
        ("<path d='M0 0 Q2 4 4 0 T8 0' style='fill:none;stroke:red'/><polygon points='20,0 24,0 24,3'/>", 6.0),
        ("<defs><rect id='a' width='2' height='2'/></defs><use href='#a'/><use href='#a' x='5'/>", 8.0),
        ("<style>.n{fill:none}</style><rect width='2' height='2' class='n' stroke='#000'/>", 4.0),
    ];
    for (shape, expected) in cases {
        let found = area(shape);
        assert!((found - expected).abs() < 1e-4 * expected, "{shape}: {found}, not {expected}");
    }
    let text = "<svg xmlns='http://www.w3.org/2000/svg'><text>a</text><rect y='1' width='2' height='2'/></svg>";
    let found = plain(DrawingFormat::Svg, text);
    assert_eq!(found.notes[0].to_string(), "f: 1 text elements skipped, in line 1");
    assert!(found.pslg.points.contains(&Point::new(0.0, -1.0)), "y is turned: {:?}", found.pslg.points);
}

#[test]
fn breaklines_in_a_cloud_have_the_hull_as_outline() {
    let mut text = "POINT Z (0 0 1)\nPOINT (9 0)\nPOINT (9 9)\nPOINT (0 9)\n".to_owned();
    text.push_str("LINESTRING Z (2 2 5, 5 6 7,\n 7 6 8)\nGEOMETRYCOLLECTION (POINT (1 5), MULTIPOINT ((3 1), 4 1))");
    let found = plain(DrawingFormat::Wkt, &text);
    assert_eq!(areas(&found.pslg).0, 81.0);
    assert_eq!(found.pslg.segments.len(), 2 + 4);
    assert_eq!(found.pslg.point_attributes[..2], [1.0, 0.0]);
    assert!(found.told.iter().any(|line| line.contains("convex hull")), "{:?}", found.told);
    // An outline that is open stays a fault.
    let open = plain(DrawingFormat::Wkt, "LINESTRING (0 0, 4 0, 4 4, 0 4)\nPOINT (1 1)");
    assert!(triangulate(&open.pslg, &DomainOptions::default()).is_err());
    // Lines that close are an outline.
    let closed = plain(DrawingFormat::Wkt, "LINESTRING (0 0, 4 0, 4 4, 0 4, 0 0)\nLINESTRING (1 1, 2 1, 2 2, 1 1)");
    assert_eq!(areas(&closed.pslg).0, 15.5);
}

#[test]
fn columns_are_found_by_name_and_separator() {
    let cases = [
        "x,y,z\n0,0,1\n4,0,2\n0,3,3\n",
        "id;easting;northing;note;height\r\n1;0;0;a;1\r\n2;4;0;b;2\r\n3;0;3;c;3\r\n",
        "# a comment\n0 0 1\n4 0 2\n\n0 3 3",
        "\u{feff}0\t0\t1\n4\t0\t2\n0\t3\t3\n",
        "\"lat\",\"lon\",\"alt\"\n0,0,1\n0,4,2\n3,0,3\n",
    ];
    for text in cases {
        let found = plain(DrawingFormat::Csv, text).pslg;
        assert_eq!(found.points, [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(Point::from), "{text}");
        assert_eq!(found.point_attributes, [1.0, 2.0, 3.0], "{text}");
    }
}

#[test]
fn binary_formats_are_read_from_their_bytes() {
    let mut las = vec![0_u8; 227];
    las[..4].copy_from_slice(b"LASF");
    las[96..100].copy_from_slice(&227_u32.to_le_bytes());
    las[105..107].copy_from_slice(&20_u16.to_le_bytes());
    las[107..111].copy_from_slice(&3_u32.to_le_bytes());
    for at in [131, 139, 147] {
        las[at..at + 8].copy_from_slice(&0.5_f64.to_le_bytes());
    }
    for point in [[0, 0, 2], [8, 0, 4], [0, 6, 6]] {
        point.iter().for_each(|raw: &i32| las.extend(raw.to_le_bytes()));
        las.extend([0; 8]);
    }
    let found = read(&las, DrawingFormat::Las, "f", None, &DrawingOptions::default()).unwrap().pslg;
    assert_eq!((areas(&found).0, &found.point_attributes[..]), (6.0, &[1.0, 2.0, 3.0][..]));
    let short = read(&las[..250], DrawingFormat::Las, "f", None, &DrawingOptions::default()).unwrap_err();
    assert_eq!(short.to_string(), "f: expected 3 points, as the header says, found 1");

    let shp = polygon_shapefile();
    let found = read(&shp, DrawingFormat::Shapefile, "f", None, &DrawingOptions::default()).unwrap().pslg;
    assert_eq!(areas(&found).0, 15.0);
    let error =
        read(&shp[..shp.len() - 9], DrawingFormat::Shapefile, "f", None, &DrawingOptions::default()).unwrap_err();
    assert_eq!(error.to_string(), "f: record 1: expected content within the file, found a length beyond its end");
    // From files, with bytes that no text has.
    let memory = Memory::default();
    memory.put("a.shp", &shp);
    memory.put("b", &las);
    let files = Files::Memory(memory);
    assert_eq!(files.read_pslg("a.shp").unwrap(), found);
    assert_eq!(files.read_pslg("b").unwrap().points.len(), 3);
}

/// A square of side 4 with a hole of side 1.
fn polygon_shapefile() -> Vec<u8> {
    let rings = [[[0, 0], [0, 4], [4, 4], [4, 0], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]];
    let mut content = 5_i32.to_le_bytes().to_vec();
    content.extend([0; 32]);
    for number in [2, 10, 0, 5] {
        content.extend(i32::to_le_bytes(number));
    }
    for coordinate in rings.iter().flatten().flatten() {
        content.extend(f64::from(*coordinate).to_le_bytes());
    }
    let mut file = 9994_i32.to_be_bytes().to_vec();
    file.resize(100, 0);
    file.extend(1_i32.to_be_bytes());
    file.extend((content.len() as i32 / 2).to_be_bytes());
    file.extend(content);
    file
}

#[test]
fn faults_name_line_and_column_or_feature() {
    let cases = [
        (
            DrawingFormat::GeoJson,
            "{\"type\": \"Polygon\",\n \"coordinates\": [[[0, x]]]}",
            "f:2:23: expected GeoJSON, found expected value",
        ),
        (
            DrawingFormat::GeoJson,
            "{\"type\":\"Blob\",\"coordinates\":[0,0]}",
            "f: feature 1: expected the type of a geometry, such as Polygon, found 'Blob'",
        ),
        (DrawingFormat::Wkt, "POINT (1 2)\nPOLYGON ((0 0, 1 a))", "f:2:18: expected a y coordinate, found 'a))'"),
        (
            DrawingFormat::Wkt,
            "LINESTRING (0 0, 1 1",
            "f:1:21: expected a height, ',' or ')', found the end of the file",
        ),
        (DrawingFormat::Csv, "x,y\n1,2\n3,b\n", "f:3:3: expected a y coordinate, found 'b'"),
        (DrawingFormat::Xyz, "1 2 3\n4 inf 6\n", "f:2:3: expected a y coordinate, found 'inf'"),
        (
            DrawingFormat::Dxf,
            "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nabc\n",
            "f:8:1: expected a number for code 10, found 'abc'",
        ),
        (DrawingFormat::Dxf, "hello\nworld\n", "f:1:1: expected a code, which is a whole number, found 'hello'"),
        (DrawingFormat::Svg, "<svg><rect", "f:1:1: expected XML, found the root node was opened but never closed"),
        (
            DrawingFormat::Svg,
            "<svg>\n <path d='M 0 0 L x'/></svg>",
            "f:2:2: expected path data as 'd' of the element 'path', found 'M 0 0 L x'",
        ),
        (
            DrawingFormat::Svg,
            "<svg><text>a</text></svg>",
            "f:1:1: expected points, lines or areas, found only 1 text elements",
        ),
    ];
    for (format, text, expected) in cases {
        assert_eq!(refused(format, text), expected, "{text}");
    }
    let deep = "GEOMETRYCOLLECTION(".repeat(100_000);
    assert!(refused(DrawingFormat::Wkt, &deep).contains("a collection that is less deep"));
    let deep = format!("{{\"type\":\"Polygon\",\"coordinates\":{}", "[".repeat(100_000));
    assert!(refused(DrawingFormat::GeoJson, &deep).contains("recursion limit"));
}

#[test]
fn layers_are_selected_by_name() {
    let options = DrawingOptions::default().with_layers(vec!["#ff0000".to_owned()]);
    let text = "<svg xmlns='http://www.w3.org/2000/svg'><rect width='9' height='9'/><rect width='2' height='2' fill='red'/></svg>";
    assert_eq!(areas(&drawn(DrawingFormat::Svg, text, &options).pslg).0, 4.0);
    let options = DrawingOptions::default().with_layers(vec!["blue".to_owned()]);
    let error = read(text.as_bytes(), DrawingFormat::Svg, "f", None, &options).unwrap_err().to_string();
    assert_eq!(error, "f:1:1: expected a layer named 'blue', found '#000000', '#ff0000'");
}

#[test]
fn maps_of_other_people_are_meshed() {
    let Some(folder) = crate::common::shared_data().map(|data| data.join("geo")) else {
        eprintln!("skipped: no shared data (set TRIMALLA_SHARED to its folder)");
        return;
    };
    for (name, least) in
        [("ne_110m_land.json", 100), ("ITA.geo.json", 10), ("AK.geo.json", 10), ("ne_110m_ocean.json", 100)]
    {
        let pslg = read_pslg(folder.join(name)).unwrap_or_else(|error| panic!("{error}"));
        let options = DomainOptions {
            rule: DomainRule::Seeds,
            crossings: trimalla::constrained::Crossings::Split,
            ..DomainOptions::default()
        };
        let made = triangulate(&pslg, &options).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(made.mesh.triangles.len() > least, "{name}");
    }
}

/// Found by random inputs: hundreds of digits in one message.
#[test]
fn huge_numbers_are_told_with_an_exponent() {
    let text = include_str!("../../../../data/issues/curve-with-huge-coordinates.svg");
    let error = refused(DrawingFormat::Svg, text);
    assert!(error.starts_with("f:1: a curve from (1e300, -1e300) needs more than 65536 lines"), "{error}");
    assert!(error.len() < 150, "{error}");
    let error = refused(DrawingFormat::Wkt, "LINESTRING (0 0, 5e-324 nan)");
    assert!(error.len() < 150, "{error}");
}

/// A block of one circle in 32,767 rows and columns would be a thousand million circles.
#[test]
fn blocks_are_placed_as_often_as_fits_into_memory() {
    let text = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n0\n20\n0\n0\nCIRCLE\n10\n0\n20\n0\n40\n1\n0\nENDBLK\n0\nENDSEC\n\
                0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nB\n70\n32767\n71\n32767\n44\n4\n45\n4\n0\nENDSEC\n0\nEOF\n";
    let error = refused(DrawingFormat::Dxf, text);
    assert!(error.contains("blocks with at most 2097152 pairs in all"), "{error}");
}
