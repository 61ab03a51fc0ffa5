//! Triangulations from meshes and drawings, and heights of their points.

use std::path::PathBuf;

use clap::Args;
use trimalla::delaunay::AlgorithmKey;
use trimalla::drawing::IndexedMesh;
use trimalla::triangulation::Triangulation;
use trimalla_workbench::numbers::count;

use crate::args::ReadingOptions;
use crate::drawing_faults;
use crate::exit::{Failure, Status};
use crate::input::{Input, is_mesh, read_drawing, read_mesh};

/// A mesh, or a drawing that is triangulated.
#[derive(Debug, Args)]
pub(crate) struct SourceOptions {
    /// A mesh (.ele, or its stem) or a drawing (.poly, .node, a stem, '-' for standard input, or one of another program
    /// such as .geojson, .dxf, .csv or .las), which is triangulated
    pub(crate) input: PathBuf,

    #[command(flatten)]
    reading: ReadingOptions,
}

impl SourceOptions {
    /// Reads the points alone, as a mesh without triangles where the source is a drawing.
    pub(crate) fn read_points(&self) -> Result<Input<IndexedMesh>, Failure> {
        if is_mesh(&self.input) {
            return read_mesh(&self.input);
        }
        let mut drawing = read_drawing(&self.input, &self.reading.import)?;
        let points = std::mem::take(&mut drawing.value.points);
        Ok(drawing.with_value(IndexedMesh { input_points: points.len(), points, ..IndexedMesh::default() }))
    }

    /// Reads the mesh, or triangulates the drawing; what is unusual in it is among the notes.
    pub(crate) fn read_triangles(&self) -> Result<Input<IndexedMesh>, Failure> {
        if is_mesh(&self.input) {
            return read_mesh(&self.input);
        }
        let drawing = read_drawing(&self.input, &self.reading.import)?;
        let options = self.reading.domain_options(AlgorithmKey::default());
        let names = drawing.numbers();
        let made = trimalla::triangulate(&drawing.value, &options);
        let made = made.map_err(|error| drawing_faults::failure(&names, &error))?;
        let warnings: Vec<String> = made.warnings.iter().map(|w| names.warning(w)).collect();
        let mut input = drawing.with_value(made.mesh);
        input.notes.extend(warnings);
        Ok(input)
    }
}

/// The triangulation of a mesh that was read.
pub(crate) fn triangulation(mesh: &Input<IndexedMesh>) -> Result<Triangulation, Failure> {
    Triangulation::from_indexed(&mesh.value).map_err(|faults| {
        let first = faults.iter().take(10).map(|fault| format!("{}: {fault}", mesh.name())).collect();
        Failure::of_many(Status::BadInput, first)
            .hint(format!("'trimalla check' lists {}", count(faults.len(), "fault")))
    })
}

/// The heights of points: the attribute with that number, counted from 1.
pub(crate) fn heights(mesh: &Input<IndexedMesh>, attribute: usize) -> Result<Vec<f64>, Failure> {
    let IndexedMesh { points, attributes_per_point: width, point_attributes, .. } = &mesh.value;
    let has_column = (1..=*width).contains(&attribute) && point_attributes.len() == points.len() * width;
    if !has_column && !points.is_empty() {
        let message = format!("{} has {} a point, no attribute {attribute}", mesh.name(), count(*width, "attribute"));
        return Err(Failure::bad_input(message).hint("heights are an attribute of the points: a column after x and y"));
    }
    Ok(point_attributes.iter().skip(attribute.wrapping_sub(1)).step_by((*width).max(1)).copied().collect())
}
