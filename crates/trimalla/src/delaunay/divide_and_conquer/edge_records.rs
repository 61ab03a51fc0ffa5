//! Edges in rings around their vertices: the smallest structure on which a triangulation can be cut and sewn.
//!
//! # Idea
//! An edge is a pair of *directed edges*, twins of each other, whose numbers differ in the lowest bit; so the twin
//! costs no memory and no look-up. A directed edge stores its origin and its two neighbours in the ring around the
//! origin. Faces are not stored: the left face of an edge is found by walking, because turning clockwise at the far
//! end stays on it.
//!
//! ```text
//!              c                          in the ring around a:   ccw(ab) = ac,   cw(ac) = ab
//!             / \                         on the left face:       next(ab) = cw(ba) = bc
//!            /   \                                                prev(ab) = twin of ccw(ab) = ca
//!           / <-. \
//!          /  __/  \
//!         a ------> b
//! ```
//!
//! # Invariants
//! * `cw(ccw(e)) == e`, and all edges of a ring have one origin.
//! * A record that is not in use is `Record::DEAD`; twins live and die together.
//! * Dead pairs wait on a stack and are reused last-in first-out, before the records grow.

use std::iter::successors;

/// A directed edge: an index into the records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge(u32);

impl Edge {
    /// The edge in the other direction.
    #[inline]
    pub(crate) const fn twin(self) -> Self {
        Self(self.0 ^ 1)
    }

    /// Its place in an array with one entry a directed edge.
    #[inline]
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }
}

/// What is stored of a directed edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Record {
    origin: u32,
    ccw: Edge,
    cw: Edge,
}

impl Record {
    /// The value of every record that is not in use.
    const DEAD: Self = Self { origin: u32::MAX, ccw: Edge(u32::MAX), cw: Edge(u32::MAX) };

    /// The record of an edge `e` that is alone around its origin.
    const fn alone(origin: u32, e: Edge) -> Self {
        Self { origin, ccw: e, cw: e }
    }
}

/// The edges of a plane triangulation, all directions alive, without coordinates.
///
/// Every bounded face is a triangle. The outer face lies on the left of the edges of [`EdgeRecords::outer_face`].
#[derive(Clone, Debug, Default)]
pub(crate) struct EdgeRecords {
    records: Vec<Record>,
    /// The first of each dead pair, the last one dead on top.
    free: Vec<Edge>,
    /// An edge with the outer face on its left; none if there are no edges.
    outer: Option<Edge>,
}

/// Reading.
impl EdgeRecords {
    /// The vertex from which `e` leaves.
    #[inline]
    pub(crate) fn origin(&self, e: Edge) -> u32 {
        self.records[e.index()].origin
    }

    /// The vertex to which `e` leads.
    #[inline]
    pub(crate) fn dest(&self, e: Edge) -> u32 {
        self.origin(e.twin())
    }

    /// The next edge counter-clockwise around the origin.
    #[inline]
    pub(crate) fn ccw(&self, e: Edge) -> Edge {
        self.records[e.index()].ccw
    }

    /// The next edge clockwise around the origin.
    #[inline]
    pub(crate) fn cw(&self, e: Edge) -> Edge {
        self.records[e.index()].cw
    }

    /// The next edge of the left face.
    #[inline]
    pub(crate) fn next(&self, e: Edge) -> Edge {
        self.cw(e.twin())
    }

    /// How many records there are, dead ones included: the length of an array indexed by [`Edge::index`].
    pub(crate) fn slots(&self) -> usize {
        self.records.len()
    }

    /// How many directed edges there are.
    pub(crate) fn len(&self) -> usize {
        self.records.len() - 2 * self.free.len()
    }

    /// The directed edges, in the order of their records.
    pub(crate) fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        (0..).map(Edge).zip(&self.records).filter(|(_, record)| **record != Record::DEAD).map(|(e, _)| e)
    }

    /// The edges of the face on the left of `start`, from `start` on; counter-clockwise round a triangle.
    pub(crate) fn left_face(&self, start: Edge) -> impl Iterator<Item = Edge> + '_ {
        let rest = move |e: &Edge| Some(self.next(*e)).filter(|e| *e != start);
        successors(Some(start), rest).take(self.records.len())
    }

    /// The edges with the outer face on their left: clockwise round the hull, there and back along a collinear chain.
    pub(crate) fn outer_face(&self) -> impl Iterator<Item = Edge> + '_ {
        self.outer.into_iter().flat_map(|start| self.left_face(start))
    }

    #[cfg(test)]
    /// The vertices of each triangle, counter-clockwise; triangles in the order of the first record of each.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        let triangle = |ab| self.triangle_begun_by(ab);
        self.edges().filter_map(triangle).map(|face| face.map(|e| self.origin(e)))
    }

    #[cfg(test)]
    /// The edges of the triangle on the left of `ab`, if there is one and `ab` is the first of its records.
    ///
    /// The outer face has three edges too if the hull has three vertices: then one of them is the edge known as
    /// outer.
    fn triangle_begun_by(&self, ab: Edge) -> Option<[Edge; 3]> {
        let bc = self.next(ab);
        let ca = self.next(bc);
        let face = [ab, bc, ca];
        let closed = self.next(ca) == ab;
        let begun = ab.0 < bc.0 && ab.0 < ca.0;
        let bounded = !face.iter().any(|e| Some(*e) == self.outer);
        (closed && begun && bounded).then_some(face)
    }
}

/// Writing.
impl EdgeRecords {
    /// No edges yet, and room for all that `vertices` vertices can have at once.
    pub(super) fn with_capacity(vertices: usize) -> Self {
        Self { records: Vec::with_capacity(6 * vertices), free: Vec::new(), outer: None }
    }

    /// Stores an edge that has the outer face on its left.
    pub(super) fn set_outer(&mut self, e: Edge) {
        self.outer = Some(e);
    }

    /// Gives the vertices other names.
    pub(super) fn rename(&mut self, name: impl Fn(u32) -> u32) {
        for record in self.records.iter_mut().filter(|record| **record != Record::DEAD) {
            record.origin = name(record.origin);
        }
    }

    /// Adds an edge from `origin` to `dest`, both of which have no edges.
    pub(super) fn add(&mut self, origin: u32, dest: u32) -> Edge {
        let e = self.free.pop().unwrap_or_else(|| self.grow());
        self.records[e.index()] = Record::alone(origin, e);
        self.records[e.twin().index()] = Record::alone(dest, e.twin());
        e
    }

    /// Adds an edge from the origin of `ab` to `c`, which has no edges, right after `ab` counter-clockwise.
    pub(super) fn add_from(&mut self, ab: Edge, c: u32) -> Edge {
        let ac = self.add(self.origin(ab), c);
        self.put_after(ab, ac);
        ac
    }

    /// Adds the edge from the end of `ab` to the origin of `cd` through the left face of both.
    ///
    /// ```text
    ///      d                        d
    ///       \                        \
    ///        \                        \
    ///         c                        c
    ///         :     left               |  left of bc:  a → b → c → d
    ///         :     face       =>      |
    ///         b                        b      right of bc: the other part
    ///        /                        /
    ///       /                        /
    ///      a                        a
    /// ```
    /// The left face is cut in two; if `ab` and `cd` lie on outer faces of separate parts, the parts become one.
    pub(super) fn connect(&mut self, ab: Edge, cd: Edge) -> Edge {
        let at_b = self.next(ab);
        let bc = self.add(self.dest(ab), self.origin(cd));
        self.put_after(at_b, bc);
        self.put_after(cd, bc.twin());
        bc
    }

    /// Removes an edge; the faces on its two sides become one.
    ///
    /// ```text
    ///        d                      d
    ///       /|\                    / \
    ///      / | \                  /   \
    ///     a  |  c       =>       a     c
    ///      \ | /                  \   /
    ///       \|/                    \ /
    ///        b                      b
    /// ```
    pub(super) fn remove(&mut self, bd: Edge) {
        self.take_out(bd);
        self.take_out(bd.twin());
        self.free.push(bd);
    }

    /// Makes a pair of records; numbers stay in range because a plane graph of `MAX_POINTS` vertices has no more
    /// edges.
    fn grow(&mut self) -> Edge {
        let e = Edge(self.records.len() as u32);
        self.records.extend([Record::DEAD; 2]);
        e
    }

    /// Puts `e`, alone so far, into the ring of `place`, right after it counter-clockwise.
    fn put_after(&mut self, place: Edge, e: Edge) {
        let after = self.ccw(place);
        self.join(place, e);
        self.join(e, after);
    }

    /// Takes `e` out of its ring and lets its record die.
    fn take_out(&mut self, e: Edge) {
        self.join(self.cw(e), self.ccw(e));
        self.records[e.index()] = Record::DEAD;
    }

    /// Makes `b` the successor of `a`, counter-clockwise around their origin.
    fn join(&mut self, a: Edge, b: Edge) {
        self.records[a.index()].ccw = b;
        self.records[b.index()].cw = a;
    }
}
