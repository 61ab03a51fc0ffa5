//! Small benchmarks of parts of the library: `cargo bench`.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{AlgorithmKey, Delaunay};
use trimalla::domain::{self, DomainRule};
use trimalla::drawing::IndexedMesh;
use trimalla::drawing::Pslg;
use trimalla::geometry::{Orientation, Point, in_circle, orient2d};
use trimalla::refine::{Preset, RefineOptions};
use trimalla::{MeshOptions, mesh};
use trimalla_bench::workloads::{uniform, workload};
use trimalla_io::node;

fn input(name: &str) -> Pslg {
    workload(name, Path::new("")).unwrap_or_else(|e| panic!("{e}"))
}

fn predicates(c: &mut Criterion) {
    for (name, points) in
        [("random", uniform(4000, 1)), ("grid", input("grid4k").points), ("grid of 0.1", input("grid0.1-4k").points)]
    {
        c.bench_function(&format!("orient2d, 1000 calls, {name}"), |b| {
            b.iter(|| {
                points[..3000]
                    .chunks_exact(3)
                    .filter(|p| orient2d(p[0], p[1], p[2]) == Orientation::CounterClockwise)
                    .count()
            });
        });
        // Four corners of a cell, or of a strip of cells.
        let side = 63;
        let quads: Vec<[Point; 4]> = (0..1000).map(|i| [i, i + 1, i + side + 1, i + side].map(|k| points[k])).collect();
        c.bench_function(&format!("in_circle, 1000 calls, {name}"), |b| {
            b.iter(|| {
                for &[p, q, r, s] in &quads {
                    black_box(in_circle(p, q, r, s));
                }
            });
        });
    }
}

fn points(c: &mut Criterion) {
    let inputs = ["u10k", "clus10k", "grid10k", "circ10k", "line10k"].map(|name| (name, input(name).points));
    for (name, points) in &inputs {
        c.bench_function(&format!("triangulate {name}"), |b| b.iter(|| Delaunay::new(points)));
    }
    c.bench_function("triangulate u10k, divide and conquer", |b| {
        b.iter(|| AlgorithmKey::DivideAndConquer.triangulate(&inputs[0].1, None));
    });
    let (t, more) = (Delaunay::new(&inputs[0].1).expect("finite points"), uniform(1000, 2));
    c.bench_function("locate 1000 points in u10k", |b| {
        b.iter(|| {
            for &p in &more {
                black_box(t.locate(p));
            }
        });
    });
    c.bench_function("insert 1000 points into u10k", |b| {
        b.iter_batched(
            || t.clone(),
            |mut t| {
                for &p in &more {
                    black_box(t.insert(p)).expect("a finite point");
                }
                t
            },
            BatchSize::LargeInput,
        );
    });
}

fn segments(c: &mut Criterion) {
    for name in ["w5a-10k", "w5b-10k", "w5c-10k", "channel10k"] {
        let drawing = input(name);
        let plain = ConstrainedDelaunay::from_delaunay(Delaunay::new(&drawing.points).expect("finite points"));
        c.bench_function(&format!("insert the segments of {name}"), |b| {
            b.iter_batched(
                || plain.clone(),
                |mut cdt| {
                    cdt.insert_segments(&drawing.segments, Crossings::Refuse).expect("no crossings");
                    cdt
                },
                BatchSize::LargeInput,
            );
        });
    }
    let polygon = input("poly10k");
    c.bench_function("polygon of 10k, outside carved", |b| {
        b.iter(|| domain::build(&polygon, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()));
    });
}

fn refinement(c: &mut Criterion) {
    for preset in [Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid] {
        for name in ["w6b-2k", "w6bs-2k"] {
            let drawing = input(name);
            let options = MeshOptions { refine: RefineOptions::of(preset), ..MeshOptions::default() };
            c.bench_function(&format!("refine {name} to 30 degrees, {}", preset.key()), |b| {
                b.iter(|| mesh(&drawing, &options))
            });
        }
    }
}

fn files(c: &mut Criterion) {
    let drawn = IndexedMesh { points: uniform(10_000, 3), ..IndexedMesh::default() };
    let mut text = Vec::new();
    node::write(&mut text, &drawn, 1).expect("memory does not fail");
    c.bench_function("print 10k points", |b| {
        b.iter(|| {
            let mut out = Vec::with_capacity(text.len());
            node::write(&mut out, &drawn, 1).map(|()| out.len())
        });
    });
    c.bench_function("parse 10k points", |b| b.iter(|| node::read(&text, "points.node")));
}

criterion_group! {
    name = parts;
    config = Criterion::default().sample_size(10).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_millis(800));
    targets = predicates, points, segments, refinement, files
}
criterion_main!(parts);
