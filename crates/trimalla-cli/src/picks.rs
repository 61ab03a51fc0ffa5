//! `--pick`: the triangles that step 2 `manual` treats, by their numbers.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use clap::Args;
use trimalla::half_edge::{FaceId, VertexId};
use trimalla::refine::{Beginning, Select, Value};

use crate::console::count;
use crate::exit::Failure;

/// Which triangles are picked.
#[derive(Debug, Args)]
pub(crate) struct PickOptions {
    /// Treat these triangles, one after the other, bad or not, and no others: step 2 is 'manual' then
    ///
    /// Numbers are those of the triangulation that refinement starts from: for 'refine' the mesh's, for 'mesh' those in
    /// the .ele file of 'triangulate' with the same options and, as its --algorithm, the same triangulator: another one
    /// numbers triangles otherwise. A triangle that is gone when its turn comes is passed over.
    #[arg(long, value_name = "N,...", value_delimiter = ',', help_heading = "Refinement")]
    pick: Vec<usize>,
}

impl PickOptions {
    /// The numbers picked.
    pub(crate) fn numbers(&self) -> &[usize] {
        &self.pick
    }

    /// Makes step 2 `manual` where triangles are picked; another order on the command line contradicts that.
    pub(crate) fn change(&self, select: &mut Select, asked: Option<&Value>) -> Result<(), Failure> {
        if self.pick.is_empty() {
            return Ok(());
        }
        match asked {
            Some(other) if *other != Value::Key(Select::Manual.key()) => {
                Err(Failure::wrong_use(format!("--pick goes with --select manual, not with --select {other}"))
                    .hint("leave --select out: --pick says it"))
            }
            _ => {
                *select = Select::Manual;
                Ok(())
            }
        }
    }

    /// The warning about a manual order without picks.
    pub(crate) fn warning(&self, select: Select) -> Option<String> {
        let is_idle = select == Select::Manual && self.pick.is_empty();
        is_idle
            .then(|| "step 2 is 'manual' and no triangle is picked: none is treated; name some with --pick".to_owned())
    }

    /// The picks, with the triangles of the mesh that they are numbers of, if that is not the start itself.
    pub(crate) fn of(&self, first_index: u32, triangles: Option<&[[u32; 3]]>) -> Result<Picks, Failure> {
        let first = first_index as usize;
        let named =
            triangles.map(|t| self.pick.iter().map(|n| number_in(*n, first, t.len()).map(|i| name(t[i]))).collect());
        let named: Option<Vec<_>> = named.transpose()?;
        Ok(Picks { numbers: self.pick.clone(), first, named, fault: Rc::default() })
    }
}

/// The picks of one run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Picks {
    numbers: Vec<usize>,
    first: usize,
    /// The triangles by their vertices, where they are those of a mesh that may have been flipped since.
    named: Option<Vec<[VertexId; 3]>>,
    fault: Rc<RefCell<Option<Failure>>>,
}

impl Picks {
    /// Picks the triangles; returns whether all exist, and keeps the failure if not.
    pub(crate) fn pick(&self, begun: &mut dyn Beginning) -> bool {
        let picked = self.faces(begun).map(|faces| faces.into_iter().all(|f| begun.pick(f)));
        picked.unwrap_or_else(|failure| {
            *self.fault.borrow_mut() = Some(failure);
            false
        })
    }

    /// The failure of [`pick`](Self::pick), if there was one.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        self.fault.borrow_mut().take().map_or(Ok(()), Err)
    }

    fn faces(&self, begun: &dyn Beginning) -> Result<Vec<FaceId>, Failure> {
        if self.numbers.is_empty() {
            return Ok(Vec::new());
        }
        let cdt = begun.triangulation();
        let start: Vec<FaceId> = cdt.real_faces().collect();
        let Some(named) = &self.named else {
            return self.numbers.iter().map(|&n| number_in(n, self.first, start.len()).map(|i| start[i])).collect();
        };
        let by_name: BTreeMap<_, _> = start.into_iter().map(|f| (sorted(cdt.face_vertices(f)), f)).collect();
        let face = |(number, name): (&usize, &[VertexId; 3])| {
            by_name.get(name).copied().ok_or_else(|| {
                Failure::wrong_use(format!(
                    "triangle {number} is no more when refinement begins: edges of it were flipped first"
                ))
                .hint("the mesh is not Delaunay; --initial given takes it as it is")
            })
        };
        self.numbers.iter().zip(named).map(face).collect()
    }
}

/// The index of the triangle with this number.
fn number_in(number: usize, first: usize, triangles: usize) -> Result<usize, Failure> {
    let index = number.checked_sub(first).filter(|&index| index < triangles);
    index.ok_or_else(|| {
        let there = format!("there are {} to start from, numbered from {first} on", count(triangles, "triangle"));
        Failure::wrong_use(format!("there is no triangle {number} to pick: {there}"))
    })
}

fn name(triangle: [u32; 3]) -> [VertexId; 3] {
    sorted(triangle.map(VertexId))
}

fn sorted(mut name: [VertexId; 3]) -> [VertexId; 3] {
    name.sort_unstable();
    name
}
