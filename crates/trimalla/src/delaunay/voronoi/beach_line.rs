//! The beach line: its arcs in order, in a balanced tree.
//!
//! A treap: in order from the lowest arc to the highest, and a heap by priorities that look random, so that its
//! expected depth is logarithmic. The arcs are a doubly linked list besides.

/// Names no arc.
pub(super) const NONE: u32 = u32::MAX;

/// An arc, and the breakpoint between it and the next one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    /// The site whose parabola it is a part of.
    pub(super) site: u32,
    /// The arc below.
    pub(super) prev: u32,
    /// The arc above.
    pub(super) next: u32,
    /// Changes when the arc's neighbours do: circle events of the past are void.
    pub(super) stamp: u32,
    /// The triangle at whose center the edge began that the breakpoint to the next arc draws, if at one.
    pub(super) begun: u32,
    parent: u32,
    children: [u32; 2],
    priority: u32,
}

/// The arcs.
#[derive(Debug, Default)]
pub(super) struct BeachLine {
    arcs: Vec<Arc>,
    free: Vec<u32>,
    root: Option<u32>,
    made: u32,
}

const BELOW: usize = 0;
const ABOVE: usize = 1;

impl BeachLine {
    /// A beach line of one arc.
    pub(super) fn of(site: u32) -> Self {
        let mut line = Self::default();
        let arc = line.take(site);
        line.root = Some(arc);
        line
    }

    /// An arc by its number.
    pub(super) fn arc(&self, arc: u32) -> &Arc {
        &self.arcs[arc as usize]
    }

    /// An arc to be changed.
    pub(super) fn arc_mut(&mut self, arc: u32) -> &mut Arc {
        &mut self.arcs[arc as usize]
    }

    /// The site of an arc's neighbour; `None` at the ends.
    pub(super) fn site(&self, arc: u32) -> Option<u32> {
        self.arcs.get(arc as usize).map(|a| a.site)
    }

    /// The arc where a point lies.
    ///
    /// `is_below` tells whether the point is below the breakpoint between the arcs of two sites, the lower one first.
    ///
    /// # Complexity
    /// O(log n) expected.
    pub(super) fn find(&self, is_below: impl Fn(u32, u32) -> bool) -> u32 {
        let mut at = self.root.unwrap_or(0);
        loop {
            let arc = self.arc(at);
            let is_under_it = self.site(arc.prev).is_some_and(|before| is_below(before, arc.site));
            let side = if is_under_it {
                BELOW
            } else if self.site(arc.next).is_some_and(|after| !is_below(arc.site, after)) {
                ABOVE
            } else {
                return at;
            };
            match arc.children[side] {
                NONE => return at,
                child => at = child,
            }
        }
    }

    /// Puts a new arc above an arc; returns it.
    pub(super) fn insert_above(&mut self, arc: u32, site: u32) -> u32 {
        let new = self.take(site);
        let next = self.arc(arc).next;
        (self.arc_mut(new).prev, self.arc_mut(new).next) = (arc, next);
        self.arc_mut(arc).next = new;
        if next != NONE {
            self.arc_mut(next).prev = new;
        }
        // Where the arc has something above it in the tree, the next arc has nothing below it.
        let (parent, side) = if self.arc(arc).children[ABOVE] == NONE { (arc, ABOVE) } else { (next, BELOW) };
        self.arc_mut(parent).children[side] = new;
        self.arc_mut(new).parent = parent;
        while self.arc(new).parent != NONE && self.arc(self.arc(new).parent).priority < self.arc(new).priority {
            self.rotate_up(new);
        }
        new
    }

    /// Takes an arc out; its neighbours adjoin then.
    pub(super) fn remove(&mut self, arc: u32) {
        loop {
            let [below, above] = self.arc(arc).children;
            let child = match (below, above) {
                (NONE, NONE) => break,
                (NONE, child) | (child, NONE) => child,
                _ if self.arc(below).priority > self.arc(above).priority => below,
                _ => above,
            };
            self.rotate_up(child);
        }
        self.replace_child(self.arc(arc).parent, arc, NONE);
        let Arc { prev, next, .. } = *self.arc(arc);
        if prev != NONE {
            self.arc_mut(prev).next = next;
        }
        if next != NONE {
            self.arc_mut(next).prev = prev;
        }
        self.arc_mut(arc).stamp += 1;
        self.free.push(arc);
    }

    /// The sites of the arcs, from the lowest one on.
    pub(super) fn sites(&self) -> Vec<u32> {
        let mut at = self.root.unwrap_or(NONE);
        while at != NONE && self.arc(at).prev != NONE {
            at = self.arc(at).prev;
        }
        let mut sites = Vec::new();
        while at != NONE {
            sites.push(self.arc(at).site);
            at = self.arc(at).next;
        }
        sites
    }

    /// A slot for an arc.
    fn take(&mut self, site: u32) -> u32 {
        self.made = self.made.wrapping_add(1);
        let mut priority = self.made.wrapping_mul(0x9e37_79b9);
        priority = (priority ^ priority >> 15).wrapping_mul(0x85eb_ca77);
        priority ^= priority >> 13;
        let (children, begun) = ([NONE; 2], NONE);
        let mut arc = Arc { site, prev: NONE, next: NONE, stamp: 0, begun, parent: NONE, children, priority };
        match self.free.pop() {
            Some(slot) => {
                arc.stamp = self.arc(slot).stamp;
                *self.arc_mut(slot) = arc;
                slot
            }
            None => {
                self.arcs.push(arc);
                self.arcs.len() as u32 - 1
            }
        }
    }

    /// ```text
    ///        parent              child
    ///        /    \              /   \
    ///     child    C    <──>    A   parent       the order A, child, B, parent, C stays
    ///     /   \                     /    \
    ///    A     B                   B      C
    /// ```
    fn rotate_up(&mut self, child: u32) {
        let parent = self.arc(child).parent;
        let side = usize::from(self.arc(parent).children[ABOVE] == child);
        let between = self.arc(child).children[1 - side];
        self.replace_child(self.arc(parent).parent, parent, child);
        self.arc_mut(parent).children[side] = between;
        if between != NONE {
            self.arc_mut(between).parent = parent;
        }
        self.arc_mut(child).children[1 - side] = parent;
        self.arc_mut(parent).parent = child;
    }

    fn replace_child(&mut self, parent: u32, old: u32, new: u32) {
        if parent == NONE {
            self.root = (new != NONE).then_some(new);
        } else {
            let side = usize::from(self.arc(parent).children[ABOVE] == old);
            self.arc_mut(parent).children[side] = new;
        }
        if new != NONE {
            self.arc_mut(new).parent = parent;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Arcs inserted and removed at random places, beside a plain list.
    #[test]
    fn arcs_stay_in_order() {
        let mut line = BeachLine::of(0);
        let mut list = vec![0_u32];
        let mut arcs = vec![0_u32];
        let mut random = 1_u64;
        for site in 1..3000 {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let i = (random >> 33) as usize % list.len();
            if (random >> 20) % 3 == 0 && list.len() > 1 {
                line.remove(arcs.remove(i));
                list.remove(i);
            } else {
                arcs.insert(i + 1, line.insert_above(arcs[i], site));
                list.insert(i + 1, site);
            }
            if site % 50 == 0 {
                assert_eq!(line.sites(), list);
            }
        }
        // Each arc is found by its place in the list.
        for (i, &arc) in arcs.iter().enumerate() {
            let place = |site: u32| list.iter().position(|&s| s == site).unwrap();
            assert_eq!(line.find(|_, above| i < place(above)), arc);
        }
    }
}
