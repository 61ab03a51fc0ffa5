//! What the features of the crate add. `cargo test -p trimalla --all-features --test laws features` runs all of it.

#[cfg(feature = "serde")]
mod serde {
    use trimalla::refine::{NamedOptions, Preset, Report, Select};
    use trimalla::{DomainOptions, IndexedMesh, MeshOptions, Pslg, RefineOptions, Region, mesh};

    fn comes_back<T: ::serde::Serialize + ::serde::de::DeserializeOwned + PartialEq + std::fmt::Debug>(value: &T) {
        let text = serde_json::to_string(value).expect("JSON");
        let again: T = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
        assert_eq!(&again, value, "{text}");
    }

    fn drawing() -> Pslg {
        let mut drawing = Pslg::of_ring([[0.0, 0.1 + 0.2], [7.0, 0.0], [7.0, 1.0 / 3.0], [0.0, 4.0]]);
        drawing.regions = vec![Region { seed: [3.0, 0.5].into(), attribute: 2.0, max_area: Some(0.3) }];
        drawing.segment_markers = vec![1, -2, 3, 4];
        drawing
    }

    #[test]
    fn drawings_meshes_and_reports_come_back() {
        let drawing = drawing();
        let options = MeshOptions { refine: RefineOptions::of(Preset::LeppCentroid), ..MeshOptions::default() };
        let trimalla::Meshed { mesh, report, .. } = mesh(&drawing, &options).expect("a mesh");
        assert!(mesh.points.len() > drawing.points.len() && !mesh.segment_markers.is_empty());
        comes_back(&drawing);
        comes_back::<IndexedMesh>(&mesh);
        comes_back::<Report>(&report);
        for preset in Preset::ALL {
            comes_back(&MeshOptions { refine: RefineOptions::of(preset).with_max_area(0.1), ..options });
        }
    }

    #[test]
    fn what_is_left_out_is_empty_or_at_its_default() {
        let drawing: Pslg = serde_json::from_str(r#"{ "points": [{ "x": 1, "y": 2 }] }"#).expect("a drawing");
        assert_eq!(drawing, Pslg { points: vec![[1.0, 2.0].into()], ..Pslg::default() });
        let options: DomainOptions = serde_json::from_str(r#"{ "crossings": "split" }"#).expect("options");
        assert_eq!(options, DomainOptions { crossings: trimalla::Crossings::Split, ..DomainOptions::default() });
        assert_eq!(serde_json::from_str::<RefineOptions>("{}").expect("options"), RefineOptions::default());
    }

    #[test]
    fn named_options_are_shaped_as_recipe_files() {
        for preset in Preset::ALL {
            let of_preset = NamedOptions::of(preset);
            comes_back(&of_preset);
            comes_back(&NamedOptions { max_area: Some(0.1 + 0.2), ..of_preset.with_default_bounds() });
        }
        let text = r#"{ "select": "first", "name": "mine", "criteria": { "min-angle": 33 }, "preset": "sanhueza" }"#;
        let options: NamedOptions = serde_json::from_str(text).expect("options");
        let mut expected = NamedOptions { name: Some("mine".to_owned()), ..NamedOptions::of(Preset::Sanhueza) };
        expected.recipe.select = Select::First;
        assert_eq!(options, NamedOptions { min_angle_deg: Some(33.0), ..expected });
        let value = serde_json::to_value(&options).expect("JSON");
        assert_eq!((&value["until-destroyed"], &value["criteria"]["min-angle"]), (&false.into(), &33.0.into()));
        assert!(value.get("limits").is_none(), "{value}");
    }

    #[test]
    fn keys_and_values_that_are_not_known_are_refused_with_those_that_are() {
        let cases = [
            (r#"{ "selekt": "first" }"#, "no option is called 'selekt'; known are name, preset, initial, "),
            (r#"{ "select": "worst" }"#, "expected one of shortest-edge, smallest-angle, "),
            (r#"{ "until-destroyed": "yes" }"#, "expected true or false"),
            (r#"{ "criteria": { "min-angle": 61 } }"#, "expected an angle from 0 to 60 degrees"),
            (r#"{ "criteria": { "criteria": {} } }"#, "known are min-angle, max-area, max-aspect-ratio"),
            (r#"{ "criteria": 3 }"#, "expected a table of options"),
            (r#"{ "limits": { "max-vertices": -1 } }"#, "expected a number of vertices"),
            (r#"{ "limits": { "max-vertices": 1.5 } }"#, "expected a number of vertices"),
        ];
        for (text, expected) in cases {
            let error = serde_json::from_str::<NamedOptions>(text).expect_err(text).to_string();
            assert!(error.contains(expected), "{text}: {error}");
        }
        let error = serde_json::from_str::<Preset>("\"best\"").expect_err("no preset").to_string();
        assert!(error.contains("expected one of off-center, circumcenter, "), "{error}");
    }
}

#[cfg(feature = "mint")]
mod mint {
    use mint::{IntoMint, Point2, Vector2};
    use trimalla::Point;
    use trimalla::geometry::Vector;

    #[test]
    fn points_and_vectors_keep_their_bits() {
        fn widened(point: impl Into<Point>) -> Point {
            point.into()
        }
        let [x, y] = [0.1 + 0.2, -0.0];
        let point: Point2<f64> = Point::new(x, y).into();
        assert_eq!((point.x.to_bits(), point.y.to_bits()), (x.to_bits(), y.to_bits()));
        assert_eq!(Point::from(point), Point::new(x, y));
        assert_eq!(widened(Point2 { x: 0.5_f32, y: f32::MAX }), Point::new(0.5, f64::from(f32::MAX)));
        let vector: <Vector as IntoMint>::MintType = Vector::new(x, y).into();
        assert_eq!(Vector::from(vector), Vector::new(x, y));
        assert_eq!(Vector::from(Vector2 { x: 1.0_f32, y: 2.0 }), Vector::new(1.0, 2.0));
    }
}

#[cfg(feature = "geo-types")]
mod geo_types {
    use geo_types::{Coord, LineString, MultiPolygon, Point as GeoPoint, line_string, polygon};
    use trimalla::{IndexedMesh, Point, Pslg};

    #[test]
    fn points_go_both_ways() {
        let point = Point::new(0.1 + 0.2, -3.0);
        assert_eq!(Point::from(GeoPoint::from(point)), point);
        assert_eq!(Point::from(Coord::from(point)), point);
    }

    #[test]
    fn lines_are_rings_where_they_are_closed() {
        let open = line_string![(x: 0.0, y: 0.0), (x: 1.0, y: 0.0), (x: 0.0, y: 1.0)];
        assert_eq!(Pslg::from(&open).segments, [[0, 1], [1, 2]]);
        let mut closed = open.clone();
        closed.close();
        let ring = Pslg::from(&closed);
        assert_eq!((ring.points.len(), &ring.segments[..]), (3, &[[0, 1], [1, 2], [2, 0]][..]));
        for few in 0..2 {
            assert_eq!(Pslg::from(&LineString::new(open.0[..few].to_vec())).segments.len(), 0, "{few} points");
        }
        assert_eq!(Pslg::from(&LineString::new(open.0[..2].to_vec())).segments, [[0, 1]]);
    }

    #[test]
    fn polygons_are_their_rings_and_meshes_triangles() {
        let frame = polygon!(
            exterior: [(x: 0.0, y: 0.0), (x: 9.0, y: 0.0), (x: 0.0, y: 9.0)],
            interiors: [[(x: 1.0, y: 1.0), (x: 2.0, y: 1.0), (x: 1.0, y: 2.0)]],
        );
        let drawing = Pslg::from(&frame);
        assert_eq!((drawing.points.len(), &drawing.segments[3..]), (6, &[[3, 4], [4, 5], [5, 3]][..]));
        let twice = Pslg::from(&MultiPolygon::new(vec![frame.clone(), frame]));
        assert_eq!((twice.points.len(), twice.segments.len()), (12, 12));
        let triangles = vec![[0, 1, 2], [0, 1, 9], [3, 4, 5]];
        let mesh = IndexedMesh { points: drawing.points, triangles, ..IndexedMesh::default() };
        let triangles: Vec<_> = mesh.geo_triangles().collect();
        assert_eq!(triangles.len(), 2);
        assert_eq!(triangles[1].to_array(), [3, 4, 5].map(|v| Coord::from(mesh.points[v])));
    }
}
