//! User data for the elements of a mesh.

use std::marker::PhantomData;

/// A value for every vertex, half-edge, edge or face, kept beside the mesh.
///
/// Reads beyond the stored length give the default, so a table needs no care while the mesh grows.
#[derive(Clone, Debug, PartialEq)]
pub struct SideTable<Id, T> {
    values: Vec<T>,
    default: T,
    id: PhantomData<fn(Id)>,
}

/// Ids that can index a [`SideTable`].
pub trait TableIndex: Copy {
    /// The position of the element.
    fn position(self) -> usize;
}

impl TableIndex for super::VertexId {
    fn position(self) -> usize {
        self.index()
    }
}

impl TableIndex for super::HalfEdgeId {
    fn position(self) -> usize {
        self.index()
    }
}

/// A table of edges is as long as one of half-edges.
impl TableIndex for super::EdgeId {
    fn position(self) -> usize {
        self.index()
    }
}

impl TableIndex for super::FaceId {
    fn position(self) -> usize {
        self.index()
    }
}

impl<Id: TableIndex, T: Clone> SideTable<Id, T> {
    /// A table in which every element has the value `default`.
    pub fn new(default: T) -> Self {
        Self { values: Vec::new(), default, id: PhantomData }
    }

    /// The value of an element.
    pub fn get(&self, id: Id) -> &T {
        self.values.get(id.position()).unwrap_or(&self.default)
    }

    /// Sets the value of an element and returns the one it had.
    pub fn set(&mut self, id: Id, value: T) -> T {
        let i = id.position();
        if i >= self.values.len() {
            self.values.resize(i + 1, self.default.clone());
        }
        std::mem::replace(&mut self.values[i], value)
    }

    /// Follows a renumbering, as `compact` returns it: the value of `old` goes to `map[old]`.
    #[must_use]
    pub fn follow(&self, map: &[Option<Id>]) -> Self {
        let mut moved = Self::new(self.default.clone());
        for (value, new) in self.values.iter().zip(map) {
            if let Some(new) = new {
                moved.set(*new, value.clone());
            }
        }
        moved
    }
}
