//! The queue of bad triangles, ordered by priority.
//!
//! ```text
//!    1 ── 2   7 ── 8       If step 2 allows, a large drawing is divided into patches along a Hilbert curve. Triangles of
//!         │   │    │       the current patch are in buckets of priority; those of every other patch are in a list. When
//!    4 ── 3   6   …        the current patch is empty, the queue continues with the next non-empty one along the curve,
//!    └──────── 5           cyclically.
//! ```
//!
//! Working in one patch at a time keeps its part of the mesh in the cache.

use crate::constrained::ConstrainedTriangulation;
use crate::delaunay::CurveCells;
use crate::geometry::{BoundingBox, Point};
use crate::half_edge::FaceId;

/// The patches of the drawing's bounding box: pieces of equal length of a Hilbert curve over a grid.
#[derive(Clone, Debug)]
pub(in crate::refine) struct Patches {
    cells: CurveCells,
    count: u32,
}

impl Patches {
    /// Vertices in a patch at the start, counting those that an area bound will need. Large enough that the patch
    /// boundaries, across which priority does not order triangles, hardly matter; small enough for the cache.
    const VERTICES: usize = 6000;

    /// The largest number of patches.
    const MOST: usize = 1 << 14;

    /// Patches for a number of vertices in a box.
    pub(in crate::refine) fn new(bounds: Option<BoundingBox>, vertices: usize) -> Self {
        let count = (vertices / Self::VERTICES).clamp(1, Self::MOST);
        Self { cells: CurveCells::around(bounds), count: count as u32 }
    }

    #[inline]
    fn of(&self, p: Point) -> usize {
        if self.count == 1 { 0 } else { ((u64::from(self.cells.key(p)) * u64::from(self.count)) >> 32) as usize }
    }
}

/// A face with the generation stamp of its slot. The ticket is void as soon as the slot gets a newer stamp, as it does
/// whenever its triangle changes. A triangle that is destroyed and created again gets a new ticket, in whichever slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::refine) struct Ticket {
    pub(in crate::refine) face: FaceId,
    stamp: u32,
}

/// A queued triangle with its bucket of priority.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    ticket: Ticket,
    bucket: u32,
}

/// The triangles of one bucket of priority, the newest last.
#[derive(Clone, Debug, Default)]
struct Bucket {
    tickets: Vec<Ticket>,
    /// Number of entries at the front that have been taken.
    taken: usize,
}

impl Bucket {
    /// Takes the newest triangle.
    #[inline]
    fn take_newest(&mut self) -> Option<Ticket> {
        if self.tickets.len() > self.taken { self.tickets.pop() } else { None }
    }

    /// Takes the oldest triangle. Frees the taken entries when they are more than half of the list.
    fn take_oldest(&mut self) -> Option<Ticket> {
        let ticket = self.tickets.get(self.taken).copied()?;
        self.taken += 1;
        if 2 * self.taken > self.tickets.len() {
            self.tickets.drain(..self.taken);
            self.taken = 0;
        }
        Some(ticket)
    }
}

/// 64 consecutive buckets. Most rows are never used, so a row allocates its buckets when it gets the first triangle.
#[derive(Clone, Debug, Default)]
struct BucketRow {
    /// One bit for each bucket: 0 if it is empty. The bit of an emptied bucket is cleared when the bucket is next
    /// visited.
    occupied: u64,
    buckets: Option<Box<[Bucket; Self::BUCKETS]>>,
}

impl BucketRow {
    const BUCKETS: usize = 64;

    /// The buckets; allocates them on first use.
    fn buckets_mut(&mut self) -> &mut [Bucket; Self::BUCKETS] {
        self.buckets.get_or_insert_with(|| Box::new(std::array::from_fn(|_| Bucket::default())))
    }

    /// Takes a triangle from the lowest non-empty bucket; returns the number of the bucket, too.
    #[inline]
    fn take(&mut self, oldest_first: bool) -> Option<(Ticket, u32)> {
        let buckets = self.buckets.as_mut()?;
        while self.occupied != 0 {
            let number = self.occupied.trailing_zeros();
            let list = &mut buckets[number as usize];
            let ticket = if oldest_first { list.take_oldest() } else { list.take_newest() };
            if let Some(ticket) = ticket {
                return Some((ticket, number));
            }
            self.occupied &= self.occupied - 1;
        }
        None
    }

    /// Undoes a [`take`](Self::take).
    fn put_back(&mut self, ticket: Ticket, bucket: usize, is_oldest: bool) {
        let list = &mut self.buckets_mut()[bucket];
        match (is_oldest, list.taken) {
            (false, _) => list.tickets.push(ticket),
            // The taken entries have been freed since.
            (true, 0) => list.tickets.insert(0, ticket),
            (true, _) => list.taken -= 1,
        }
        self.occupied |= 1 << bucket;
    }
}

/// Bad triangles by priority. Entries of destroyed triangles stay in the queue until they are popped, and are then
/// dropped.
///
/// Priorities are quantised to a 128th of an octave, one bucket for each value: push and pop take constant time. Within
/// a bucket the newest triangle is popped first: newest triangles lie close together in memory, and in measurements
/// this order makes smaller meshes than oldest first. A step 2 that asks for it gets the oldest first.
///
/// Each bad triangle has exactly one valid ticket, since a new ticket for a slot voids the previous one. So the order
/// does not depend on whether a re-created triangle gets its old slot back.
#[derive(Clone, Debug, Default)]
pub(in crate::refine) struct Queue {
    /// `None` if the whole drawing is one patch.
    patches: Option<Patches>,
    /// The current patch; its triangles are in the buckets.
    present: usize,
    /// For each patch, its triangles that are not in the buckets yet.
    elsewhere: Vec<Vec<Waiting>>,
    rows: Vec<BucketRow>,
    /// All rows below this one are empty.
    lowest: usize,
    len: usize,
    /// The newest stamp of each slot; 0 if the slot holds no bad triangle.
    stamps: Vec<u32>,
    last_stamp: u32,
    /// What has been overwritten since the record began, if one is kept.
    record: Option<Changes>,
}

/// Journal of a queue: what was overwritten, so that it can be restored.
///
/// Allocated memory and the bits of emptied buckets are not restored: neither affects the order.
#[derive(Clone, Debug, Default)]
pub(in crate::refine) struct Changes {
    present: usize,
    lowest: usize,
    len: usize,
    last_stamp: u32,
    list: Vec<Change>,
}

/// One change of a queue.
#[derive(Clone, Debug)]
enum Change {
    /// The previous stamp of a slot.
    Stamp { slot: u32, stamp: u32 },
    /// A triangle was added to a bucket.
    Added { bucket: u32 },
    /// A triangle was added to the list of another patch.
    AddedElsewhere { patch: u32 },
    /// The newest triangle was taken from a bucket.
    TakenNewest { bucket: u32, ticket: Ticket },
    /// The oldest triangle was taken from a bucket.
    TakenOldest { bucket: u32, ticket: Ticket },
    /// The list of a patch was emptied.
    Emptied { patch: u32, list: Box<[Waiting]> },
}

impl Changes {
    /// Approximate size in bytes.
    pub(in crate::refine) fn bytes(&self) -> usize {
        let emptied = |change: &Change| match change {
            Change::Emptied { list, .. } => size_of_val(&**list),
            _ => 0,
        };
        self.list.len() * size_of::<Change>() + self.list.iter().map(emptied).sum::<usize>()
    }
}

impl Queue {
    /// Mantissa bits that do not choose the bucket.
    const SHIFT: u32 = 45;
    /// Biased exponents below this one share the first bucket. Priorities are measured in units that fit the drawing.
    const LEAST: u64 = (1023 - 220) << 7;

    /// An empty queue that works patch by patch.
    pub(in crate::refine) fn by_patches(patches: Patches) -> Self {
        Self { elsewhere: vec![Vec::new(); patches.count as usize], patches: Some(patches), ..Self::default() }
    }

    /// The patch of a point.
    #[inline]
    pub(in crate::refine) fn patch_at(&self, place: Point) -> usize {
        self.patches.as_ref().map_or(0, |patches| patches.of(place))
    }

    /// Reserves memory for a number of triangles, spread over all patches, in a mesh with a number of face slots.
    pub(in crate::refine) fn reserve(&mut self, triangles: usize, slots: usize) {
        self.stamps.reserve(2 * slots);
        let each = triangles / self.elsewhere.len().max(1);
        self.elsewhere.iter_mut().for_each(|patch| patch.reserve(each + each / 4));
    }

    /// Adds a triangle of a patch. The priority must not be negative.
    #[inline]
    pub(in crate::refine) fn push(
        &mut self,
        cdt: &ConstrainedTriangulation,
        face: FaceId,
        patch: usize,
        priority: f64,
    ) {
        let bucket = Self::bucket_of(priority);
        // A tail call: no value has to be kept across it.
        if self.record.is_some() {
            self.note_and_push(cdt, face, patch, bucket)
        } else {
            self.add(cdt, face, patch, bucket)
        }
    }

    /// Adds a triangle and records the change.
    #[cold]
    #[inline(never)]
    fn note_and_push(&mut self, cdt: &ConstrainedTriangulation, face: FaceId, patch: usize, bucket: u32) {
        self.note_stamp(face);
        let is_here = patch == self.present;
        self.note(if is_here { Change::Added { bucket } } else { Change::AddedElsewhere { patch: patch as u32 } });
        self.add(cdt, face, patch, bucket);
    }

    #[inline(always)] // For each bad triangle.
    fn add(&mut self, cdt: &ConstrainedTriangulation, face: FaceId, patch: usize, bucket: u32) {
        let waiting = Waiting { ticket: self.issue_unnoted(cdt, face), bucket };
        self.len += 1;
        if patch == self.present {
            self.put_into_bucket(waiting);
        } else {
            self.elsewhere[patch].push(waiting);
        }
    }

    #[inline]
    fn bucket_of(priority: f64) -> u32 {
        // Positive floating-point numbers have the order of their bits.
        let bits = if priority > 0.0 { priority.to_bits() } else { 0 };
        (bits >> Self::SHIFT).saturating_sub(Self::LEAST) as u32
    }

    #[inline]
    fn put_into_bucket(&mut self, Waiting { ticket, bucket }: Waiting) {
        let (row, number) = Self::place_of(bucket);
        self.lowest = self.lowest.min(row);
        let Some(BucketRow { occupied, buckets: Some(buckets) }) = self.rows.get_mut(row) else {
            return self.put_into_new_row(ticket, row, number);
        };
        *occupied |= 1 << number;
        buckets[number].tickets.push(ticket);
    }

    /// Adds a triangle to a bucket of a row that is not allocated yet.
    #[cold]
    #[inline(never)]
    fn put_into_new_row(&mut self, ticket: Ticket, row: usize, number: usize) {
        if row >= self.rows.len() {
            self.rows.resize_with(row + 1, BucketRow::default);
        }
        self.rows[row].buckets_mut()[number].tickets.push(ticket);
        self.rows[row].occupied |= 1 << number;
    }

    /// Moves on to the next non-empty patch, cyclically; returns whether there is one.
    fn take_next_patch(&mut self) -> bool {
        let count = self.elsewhere.len();
        let Some(next) = (1..=count).map(|i| (self.present + i) % count).find(|&p| !self.elsewhere[p].is_empty())
        else {
            return false;
        };
        self.present = next;
        let list = std::mem::take(&mut self.elsewhere[next]);
        if self.record.is_some() {
            self.note(Change::Emptied { patch: next as u32, list: list.clone().into() });
            let there = list.iter().filter(|waiting| self.is_newest(waiting.ticket)).map(|waiting| waiting.bucket);
            let added: Vec<Change> = there.map(|bucket| Change::Added { bucket }).collect();
            added.into_iter().for_each(|change| self.note(change));
        }
        for waiting in list {
            if self.is_newest(waiting.ticket) {
                self.put_into_bucket(waiting);
            } else {
                self.len -= 1;
            }
        }
        true
    }

    /// Issues a ticket for a face; earlier tickets for its slot become void.
    #[inline(always)] // For each bad triangle.
    pub(in crate::refine) fn issue(&mut self, cdt: &ConstrainedTriangulation, face: FaceId) -> Ticket {
        if self.record.is_some() {
            self.note_stamp(face);
        }
        self.issue_unnoted(cdt, face)
    }

    #[inline(always)] // For each bad triangle, twice.
    fn issue_unnoted(&mut self, cdt: &ConstrainedTriangulation, face: FaceId) -> Ticket {
        if face.index() >= self.stamps.len() {
            self.make_room_for(cdt.face_slots());
        }
        self.last_stamp = self.last_stamp.wrapping_add(1).max(1);
        self.stamps[face.index()] = self.last_stamp;
        Ticket { face, stamp: self.last_stamp }
    }

    /// Extends the stamps to this number of slots.
    #[inline]
    pub(in crate::refine) fn make_room_for(&mut self, slots: usize) {
        if slots > self.stamps.len() {
            self.stamps.resize(slots, 0);
        }
    }

    /// Whether the triangle that the ticket was issued for still exists.
    pub(in crate::refine) fn is_valid(&self, cdt: &ConstrainedTriangulation, ticket: Ticket) -> bool {
        self.is_newest(ticket) && cdt.is_real(ticket.face)
    }

    /// Whether the stamp is current. The face itself may be dead all the same.
    #[inline]
    fn is_newest(&self, ticket: Ticket) -> bool {
        self.stamps.get(ticket.face.index()) == Some(&ticket.stamp)
    }

    /// Voids the ticket of a slot, which holds no bad triangle now.
    pub(in crate::refine) fn invalidate(&mut self, face: FaceId) {
        if self.record.is_some() {
            self.note_stamp(face);
        }
        self.invalidate_unnoted(face);
    }

    /// [`invalidate`](Self::invalidate) for one of several faces whose stamps [were recorded](Self::note_stamps).
    #[inline(always)] // For each face around a new vertex.
    pub(in crate::refine) fn invalidate_unnoted(&mut self, face: FaceId) {
        if let Some(stamp) = self.stamps.get_mut(face.index()) {
            *stamp = 0;
        }
    }

    /// Records the stamps of some slots, if a record is kept.
    #[inline(always)] // For each new vertex.
    pub(in crate::refine) fn note_stamps(&mut self, faces: &[FaceId]) {
        if self.record.is_some() {
            faces.iter().for_each(|&face| self.note_stamp(face));
        }
    }

    #[cold]
    #[inline(never)]
    fn note_stamp(&mut self, face: FaceId) {
        let stamp = self.stamps.get(face.index()).copied().unwrap_or(0);
        self.note(Change::Stamp { slot: face.0, stamp });
    }

    #[cold]
    #[inline(never)]
    fn note(&mut self, change: Change) {
        if let Some(record) = &mut self.record {
            record.list.push(change);
        }
    }

    /// Begins a record of what is overwritten.
    pub(in crate::refine) fn begin_record(&mut self) {
        let (present, lowest, len, last_stamp) = (self.present, self.lowest, self.len, self.last_stamp);
        self.record = Some(Changes { present, lowest, len, last_stamp, list: Vec::new() });
    }

    /// Ends the record, and returns it.
    pub(in crate::refine) fn end_record(&mut self) -> Changes {
        let mut changes = self.record.take().unwrap_or_default();
        changes.list.shrink_to_fit();
        changes
    }

    /// Restores everything that was overwritten while the record was kept.
    pub(in crate::refine) fn take_back(&mut self, changes: Changes) {
        for change in changes.list.into_iter().rev() {
            match change {
                Change::Stamp { slot, stamp } => {
                    self.stamps.get_mut(slot as usize).into_iter().for_each(|s| *s = stamp)
                }
                Change::Added { bucket } => {
                    let (row, bucket) = Self::place_of(bucket);
                    self.rows[row].buckets_mut()[bucket].tickets.pop();
                }
                Change::AddedElsewhere { patch } => drop(self.elsewhere[patch as usize].pop()),
                Change::TakenNewest { bucket, ticket } => self.put_back(ticket, bucket, false),
                Change::TakenOldest { bucket, ticket } => self.put_back(ticket, bucket, true),
                Change::Emptied { patch, list } => self.elsewhere[patch as usize] = list.into(),
            }
        }
        (self.present, self.lowest) = (changes.present, changes.lowest);
        (self.len, self.last_stamp) = (changes.len, changes.last_stamp);
    }

    /// Records that a triangle was taken from a bucket.
    #[cold]
    #[inline(never)]
    fn note_taken(&mut self, ticket: Ticket, bucket: u32, is_oldest: bool) {
        self.note(if is_oldest {
            Change::TakenOldest { bucket, ticket }
        } else {
            Change::TakenNewest { bucket, ticket }
        });
    }

    fn put_back(&mut self, ticket: Ticket, bucket: u32, is_oldest: bool) {
        let (row, bucket) = Self::place_of(bucket);
        self.rows[row].put_back(ticket, bucket, is_oldest);
    }

    /// The row of a bucket, and its number there.
    const fn place_of(bucket: u32) -> (usize, usize) {
        (bucket as usize / BucketRow::BUCKETS, bucket as usize % BucketRow::BUCKETS)
    }

    /// Pops the triangle of lowest priority in the current patch, or in the next non-empty one. Drops entries of
    /// triangles that no longer exist.
    ///
    /// # Complexity
    /// Constant, amortised over the dropped entries.
    pub(in crate::refine) fn pop(&mut self, cdt: &ConstrainedTriangulation, oldest_first: bool) -> Option<FaceId> {
        loop {
            let here = self.pop_here(cdt, oldest_first);
            if here.is_some() || !self.take_next_patch() {
                return here;
            }
        }
    }

    fn pop_here(&mut self, cdt: &ConstrainedTriangulation, oldest_first: bool) -> Option<FaceId> {
        while let Some(row) = self.rows.get_mut(self.lowest) {
            let Some((ticket, bucket)) = row.take(oldest_first) else {
                self.lowest += 1;
                continue;
            };
            self.len -= 1;
            if self.record.is_some() {
                self.note_taken(ticket, (self.lowest * BucketRow::BUCKETS) as u32 + bucket, oldest_first);
            }
            if self.is_valid(cdt, ticket) {
                return Some(ticket.face);
            }
        }
        None
    }

    /// Approximate size in bytes.
    pub(in crate::refine) fn bytes(&self) -> usize {
        self.stamps.len() * size_of::<u32>() + self.len * size_of::<Waiting>()
    }

    /// Number of entries, those of destroyed triangles included.
    pub(in crate::refine) fn len(&self) -> usize {
        self.len
    }
}
