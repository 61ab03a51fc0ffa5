//! A refinement step by step, and back.

use std::sync::{Mutex, MutexGuard};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use trimalla::refine::{NoObserver, Start};
use trimalla::{Pslg, Refinement};

use crate::arrays::{drawing as drawing_in, give_mesh};
use crate::errors::Fault;
use crate::make::{give_report, words};
use crate::options::Options;

/// Steps between two looks after signals.
const SLICE: u64 = 256;

/// A refinement under way.
#[pyclass(module = "trimalla._native", name = "Refinement")]
pub(crate) struct Stepwise {
    refinement: Mutex<Refinement>,
    drawing: Pslg,
    warnings: Vec<String>,
}

impl Stepwise {
    fn lock(&self) -> PyResult<MutexGuard<'_, Refinement>> {
        self.refinement.try_lock().map_err(|_| PyRuntimeError::new_err("another thread works with this refinement"))
    }
}

#[pymethods]
impl Stepwise {
    #[new]
    fn new(
        py: Python<'_>,
        drawing: &Bound<'_, PyDict>,
        options: &Bound<'_, PyDict>,
        history_bytes: usize,
    ) -> PyResult<Self> {
        let drawing = drawing_in(drawing)?;
        let options = Options::of(options)?.mesh_options();
        let domain = options.domain;
        let made = py.detach(|| {
            let built = trimalla::domain::build(&drawing, domain.rule, domain.crossings, domain.algorithm);
            let (cdt, warnings) = built?;
            let mut refinement = Refinement::new(Start::from(cdt), options.refine)?;
            refinement.keep_history(history_bytes);
            refinement.prepare(&mut NoObserver);
            Ok::<_, Fault>((refinement, warnings))
        });
        let (refinement, warnings) = made?;
        Ok(Self { refinement: Mutex::new(refinement), drawing, warnings: words(&warnings) })
    }

    /// Makes one step: what happened, in a word.
    fn step(&self, py: Python<'_>) -> PyResult<String> {
        let mut refinement = self.lock()?;
        let refinement = &mut *refinement;
        Ok(py.detach(move || format!("{:?}", refinement.run_until(|_| true))))
    }

    /// Makes so many steps at most; how many were made. It can be interrupted.
    fn run(&self, py: Python<'_>, most: u64) -> PyResult<u64> {
        let first = self.lock()?.step_number();
        loop {
            py.check_signals()?;
            let is_over = {
                let mut refinement = self.lock()?;
                let refinement = &mut *refinement;
                py.detach(move || {
                    let until = refinement.step_number().saturating_add(SLICE).min(first.saturating_add(most));
                    if refinement.step_number() >= until {
                        return true;
                    }
                    refinement.run_until(|refinement| refinement.step_number() >= until).is_last()
                })
            };
            if is_over {
                return Ok(self.lock()?.step_number().saturating_sub(first));
            }
        }
    }

    /// Takes back one step; whether there was one.
    fn back(&self, py: Python<'_>) -> PyResult<bool> {
        let mut refinement = self.lock()?;
        let refinement = &mut *refinement;
        Ok(py.detach(move || refinement.back()))
    }

    #[getter]
    fn step_number(&self) -> PyResult<u64> {
        Ok(self.lock()?.step_number())
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// Vertices, triangles and the smallest angle now.
    #[getter]
    fn overview(&self) -> PyResult<(usize, usize, Option<f64>)> {
        let overview = self.lock()?.overview();
        Ok((overview.vertices, overview.triangles, overview.min_angle_deg))
    }

    /// The mesh now.
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let refinement = self.lock()?;
        let refinement = &*refinement;
        let mesh = py.detach(|| refinement.triangulation().to_indexed(&self.drawing));
        give_mesh(py, mesh)
    }

    /// The mesh and the report, as if the refinement ended here.
    fn finish<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
        let refinement = self.lock()?;
        let refinement = &*refinement;
        let (mesh, report) = py.detach(|| {
            let (cdt, report) = refinement.without_history().finish();
            (cdt.into_indexed(&self.drawing), report)
        });
        Ok((give_mesh(py, mesh)?, give_report(py, &report)?))
    }
}
