//! A refinement to be run, and its outcome.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::domain::Warning;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::refine::{
    Beginning, Clock, Event, NamedOptions, Observer, Outlook, Overview, Progress, RefineOptions, StopReason,
};
use trimalla::{DomainOptions, Error, Improve, MeshOptions, Meshed, Sizing};

use super::foresight::Foresight;
use super::missed::MissedBounds;
use crate::numbers::{FileNumbers, PickError, Picks};

/// What is refined.
#[derive(Debug)]
pub enum TaskInput<'a> {
    /// A drawing, which is triangulated first.
    Drawing {
        /// The drawing.
        drawing: &'a Pslg,
        /// How it is read.
        domain: DomainOptions,
        /// What makes the mesh smaller afterwards.
        improve: Improve,
        /// The numbers of its file.
        numbers: FileNumbers<'a>,
    },
    /// A mesh, which is taken as it is.
    Mesh {
        /// The mesh.
        mesh: &'a IndexedMesh,
        /// The name of the mesh in messages.
        name: String,
        /// None, or for each triangle the largest area that triangles in it may have.
        areas: &'a [Option<f64>],
        /// The drawing that the mesh was made from, with the numbers of its file.
        drawing: Option<(&'a Pslg, FileNumbers<'a>)>,
    },
}

/// A refinement to be run.
#[derive(Debug)]
pub struct Task<'a> {
    /// What is refined.
    pub input: TaskInput<'a>,
    /// Recipe, criteria and limits, and how many runs may be made.
    pub options: RefineOptions,
    /// Sizes beside those of the options.
    pub sizing: Sizing,
    /// The triangles that the order `manual` treats.
    pub picks: Picks,
}

/// What came of a refinement; warnings are in the numbers of the input.
#[derive(Debug)]
pub struct Outcome {
    /// The mesh and its report.
    pub meshed: Meshed,
    /// Size and smallest angle before the first step; `None` if the refinement was cancelled before.
    pub before: Option<Overview>,
    /// Warnings about the input.
    pub warnings: Vec<String>,
    /// Warnings before the work.
    pub foreseen: Vec<String>,
    /// What the smallest input angle costs at worst, where some triangle pays for it and the argument for it holds.
    pub floor: Option<String>,
    /// The bounds that leftover triangles miss.
    pub missed: MissedBounds,
}

/// Why there is no outcome.
#[derive(Debug)]
pub enum TaskError {
    /// The input or an option is at fault.
    Library(Error),
    /// A triangle that was picked does not exist.
    Pick(PickError),
}

/// What a program is told while a task runs.
pub trait Watch: Observer {
    /// Takes a warning before the work, in the numbers of the file.
    fn warn(&mut self, _warning: &str) {}
}

impl Task<'_> {
    /// Runs the refinement.
    ///
    /// # Errors
    /// [`TaskError`]. A run that the watch cancelled is an outcome: the mesh so far.
    pub fn run(&self, watch: &mut dyn Watch) -> Result<Outcome, TaskError> {
        let mut run = Run { watch, picks: &self.picks, foresight: None, before: None, fault: None, picked: true };
        let made = match &self.input {
            TaskInput::Drawing { drawing, domain, improve, numbers } => {
                run.foresight = Some(Foresight::new(numbers, self.options));
                let options = MeshOptions { domain: *domain, refine: self.options, improve: *improve };
                trimalla::mesh_sized(drawing, &options, &self.sizing, &mut run)
            }
            TaskInput::Mesh { mesh, areas, drawing, .. } => {
                let drawing = drawing.as_ref().map(|(drawing, _)| *drawing);
                trimalla::refine_mesh_sized(mesh, areas, drawing, &self.options, &self.sizing, &mut run)
            }
        };
        let Run { foresight, before, fault, .. } = run;
        let meshed = made.map_err(TaskError::Library)?;
        if let Some(fault) = fault {
            return Err(TaskError::Pick(fault));
        }
        let mut warnings: Vec<String> = meshed.warnings.iter().map(|warning| self.input.describe(warning)).collect();
        warnings.extend(self.not_improved(&meshed));
        Ok(Outcome {
            before,
            warnings,
            foreseen: foresight.map(Foresight::into_warnings).unwrap_or_default(),
            floor: self.input.floor(&meshed, &self.options),
            missed: MissedBounds::of(&meshed.mesh, &meshed.report, &self.options.criteria),
            meshed,
        })
    }

    /// Why the mesh was not made smaller, where that was asked for.
    fn not_improved(&self, meshed: &Meshed) -> Option<String> {
        let TaskInput::Drawing { improve: Improve::Sift { .. }, .. } = self.input else { return None };
        let why = match meshed {
            Meshed { improved: Some(_), .. } => return None,
            Meshed { report, .. } if report.stop == StopReason::Cancelled => "the work was cancelled",
            Meshed { report, .. } if !report.leftovers.is_empty() => "some triangles miss their bounds",
            _ => "it has sizes of its own",
        };
        Some(format!("the mesh was not made smaller: {why}"))
    }
}

impl Outcome {
    /// The options of the run that gave the mesh: those that were asked, or where several runs were made those of the
    /// best one, which makes the same mesh by itself.
    #[must_use]
    pub fn options_of(&self, asked: &NamedOptions) -> NamedOptions {
        let Some(attempted) = self.meshed.attempted else { return asked.clone() };
        let mut options = asked.clone();
        options.take_preset(attempted.preset);
        if attempted.is_lowered {
            options.min_angle_deg = Some(attempted.bound_deg);
        }
        options
    }
}

impl TaskInput<'_> {
    /// The drawing, if there is one.
    #[must_use]
    pub fn drawing(&self) -> Option<&Pslg> {
        match self {
            Self::Drawing { drawing, .. } => Some(drawing),
            Self::Mesh { drawing, .. } => drawing.as_ref().map(|(drawing, _)| *drawing),
        }
    }

    /// A warning in the words of the drawing where it is about that.
    fn describe(&self, warning: &Warning) -> String {
        match (self, warning) {
            (Self::Drawing { numbers, .. }, _)
            | (
                Self::Mesh { drawing: Some((_, numbers)), .. },
                Warning::IdleRegion { .. } | Warning::RegionTwice { .. },
            ) => numbers.warning(warning),
            (Self::Mesh { name, .. }, _) => format!("{name}: {warning}"),
        }
    }

    /// The angle floor in words.
    fn floor(&self, meshed: &Meshed, options: &RefineOptions) -> Option<String> {
        let Self::Drawing { numbers, .. } = self else { return None };
        let outlook = meshed.outlook.as_ref()?;
        let is_forced = meshed.report.complete() && !meshed.report.leftovers.is_empty();
        let (floor, input) = (outlook.angle_floor(options).filter(|_| is_forced)?, outlook.smallest_input_angle?);
        // Rounded down: what is said stays true.
        let floor = (100.0 * floor.degrees()).floor() / 100.0;
        Some(format!(
            "no mesh angle need be below {floor:.2} degrees: the floor for the smallest input angle {:.2} at vertex {}",
            input.angle.degrees(),
            numbers.number(input.vertex.index())
        ))
    }
}

/// Picks triangles, and passes on to the watch what the refinement tells.
struct Run<'a, 'n> {
    watch: &'a mut dyn Watch,
    picks: &'a Picks,
    /// None for a mesh, whose outlook is not asked for.
    foresight: Option<Foresight<'n>>,
    before: Option<Overview>,
    fault: Option<PickError>,
    /// Whether all triangles that were picked are there; without them nothing is refined.
    picked: bool,
}

impl Observer for Run<'_, '_> {
    fn wants_outlook(&self) -> bool {
        self.foresight.is_some()
    }

    fn outlook(&mut self, outlook: &Outlook) {
        let Some(foresight) = &mut self.foresight else { return };
        foresight.look(outlook);
        foresight.warnings().iter().for_each(|warning| self.watch.warn(warning));
    }

    fn begins(&mut self, begun: &mut dyn Beginning) {
        self.watch.begins(begun);
        self.before = Some(begun.overview());
        self.picked = self.picks.pick(begun).unwrap_or_else(|fault| {
            self.fault = Some(fault);
            false
        });
    }

    fn progress(&mut self, progress: Progress) -> bool {
        self.watch.progress(progress) && self.picked
    }

    fn clock(&self) -> Option<Clock> {
        self.watch.clock()
    }

    fn wants_events(&self) -> bool {
        self.watch.wants_events()
    }

    fn event(&mut self, event: &Event, cdt: &ConstrainedTriangulation) {
        self.watch.event(event, cdt);
    }
}
