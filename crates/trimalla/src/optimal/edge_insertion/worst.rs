//! Which triangle is the worst.

use super::criteria::Criterion;

/// The costs of all triangles, and a tournament between them.
///
/// ```text
///            3            each node names the worse triangle of its two children; of equal ones the lower one
///          ╱   ╲
///        1       3
///       ╱ ╲     ╱ ╲
///      0   1   2   3
/// ```
pub(super) struct Worst<C: Criterion> {
    /// `None` for triangles that are known to stay.
    costs: Vec<Option<C::Cost>>,
    /// Node `i` has the children `2 i` and `2 i + 1`; the leaves are the upper half.
    nodes: Vec<u32>,
}

impl<C: Criterion> Worst<C> {
    /// # Complexity
    /// Linear.
    pub(super) fn new(criterion: &C, triangles: &[[u32; 3]]) -> Self {
        let n = triangles.len();
        let costs = triangles.iter().map(|&t| Some(criterion.cost(t))).collect();
        let mut worst = Self { costs, nodes: (0..2 * n as u32).map(|i| i.saturating_sub(n as u32)).collect() };
        for node in (1..n).rev() {
            worst.play(criterion, node);
        }
        worst
    }

    /// The worst triangle that is not known to stay, and its cost.
    pub(super) fn get(&self) -> Option<(u32, &C::Cost)> {
        let slot = *self.nodes.get(1)?;
        self.costs[slot as usize].as_ref().map(|cost| (slot, cost))
    }

    /// A triangle stays.
    ///
    /// # Complexity
    /// O(log n).
    pub(super) fn retire(&mut self, criterion: &C, slot: u32) {
        self.set(criterion, slot, None);
    }

    /// A slot has another triangle.
    ///
    /// # Complexity
    /// O(log n).
    pub(super) fn update(&mut self, criterion: &C, slot: u32, t: [u32; 3]) {
        self.set(criterion, slot, Some(criterion.cost(t)));
    }

    fn set(&mut self, criterion: &C, slot: u32, cost: Option<C::Cost>) {
        self.costs[slot as usize] = cost;
        let mut node = (slot as usize + self.costs.len()) / 2;
        while node > 0 {
            self.play(criterion, node);
            node /= 2;
        }
    }

    fn play(&mut self, criterion: &C, node: usize) {
        let [a, b] = [self.nodes[2 * node], self.nodes[2 * node + 1]];
        let a_wins = match [a, b].map(|slot| &self.costs[slot as usize]) {
            [Some(one), Some(two)] => criterion.compare(one, two).then(b.cmp(&a)).is_gt(),
            [one, _] => one.is_some(),
        };
        self.nodes[node] = if a_wins { a } else { b };
    }
}
