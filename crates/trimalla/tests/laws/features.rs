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
        let (mesh, report) = mesh(&drawing, &options).expect("a mesh");
        assert!(mesh.points.len() > drawing.points.len() && !mesh.segment_markers.is_empty());
        comes_back(&drawing);
        comes_back::<IndexedMesh>(&mesh);
        comes_back::<Report>(&report);
        for &preset in Preset::ALL {
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
        for &preset in Preset::ALL {
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
