//! The indices by which the user names vertices.

use std::collections::{BTreeMap, BTreeSet};

use trimalla::half_edge::VertexId;

/// Which vertex each index names. A vertex may have several names, where one was given twice.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Names {
    by_name: BTreeMap<u32, VertexId>,
    /// The lowest name of each vertex.
    of_vertex: Vec<Option<u32>>,
    /// The names that are not the lowest of their vertex.
    others: BTreeSet<(VertexId, u32)>,
}

impl Names {
    /// The vertices `0..count`, each by its own number.
    pub(crate) fn of_count(count: usize) -> Self {
        let all = || (0..count).map(VertexId::from_index);
        Self {
            by_name: all().map(|v| (v.0, v)).collect(),
            of_vertex: all().map(|v| Some(v.0)).collect(),
            others: BTreeSet::new(),
        }
    }

    /// The vertex of that name.
    pub(crate) fn vertex(&self, name: u32) -> Option<VertexId> {
        self.by_name.get(&name).copied()
    }

    /// The name of a vertex.
    pub(crate) fn name(&self, v: VertexId) -> Option<u32> {
        self.of_vertex.get(v.index()).copied().flatten()
    }

    /// The lowest name above all that are used.
    pub(crate) fn next(&self) -> u32 {
        self.by_name.last_key_value().map_or(0, |(&name, _)| name + 1)
    }

    /// Names a vertex.
    pub(crate) fn add(&mut self, name: u32, v: VertexId) {
        self.remove(name);
        self.by_name.insert(name, v);
        if v.index() >= self.of_vertex.len() {
            self.of_vertex.resize(v.index() + 1, None);
        }
        match &mut self.of_vertex[v.index()] {
            // The lowest name is the first, in whatever order they come back.
            Some(first) => {
                let other = name.max(*first);
                *first = name.min(*first);
                self.others.insert((v, other));
            }
            first => *first = Some(name),
        }
    }

    /// Takes a name away; the vertex that had it.
    pub(crate) fn remove(&mut self, name: u32) -> Option<VertexId> {
        let v = self.by_name.remove(&name)?;
        if self.of_vertex[v.index()] != Some(name) {
            self.others.remove(&(v, name));
        } else {
            let next = self.others_of(v).next();
            self.of_vertex[v.index()] = next;
            next.map(|next| self.others.remove(&(v, next)));
        }
        while self.of_vertex.last() == Some(&None) {
            self.of_vertex.pop();
        }
        Some(v)
    }

    /// The names of a vertex but for the lowest, ascending.
    fn others_of(&self, v: VertexId) -> impl Iterator<Item = u32> + '_ {
        self.others.range((v, 0)..=(v, u32::MAX)).map(|&(_, name)| name)
    }

    /// The names of a vertex, ascending.
    pub(crate) fn names_of(&self, v: VertexId) -> impl Iterator<Item = u32> + '_ {
        self.name(v).into_iter().chain(self.others_of(v))
    }

    /// The vertices from this number on have no names.
    pub(crate) fn slots(&self) -> usize {
        self.of_vertex.len()
    }

    /// All names with their vertices, ascending.
    pub(crate) fn all(&self) -> impl Iterator<Item = (u32, VertexId)> + '_ {
        self.by_name.iter().map(|(&name, &v)| (name, v))
    }
}
