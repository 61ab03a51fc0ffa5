//! The choices that have keys: presets, the steps of a recipe, protected segments.
//!
//! Each choice is declared once, with its key, a line on what it does, and its source. The [table of
//! options](super::table::OPTIONS) lists which option takes which choices.

use super::value::{Plain, Value};
use crate::by_key::Row;

macro_rules! choices {
    ($(#[$doc:meta])* $name:ident, $default:ident, { $($rows:tt)* }) => {
        keyed! { $(#[$doc])* $name, { $($rows)* } }

        impl Default for $name {
            fn default() -> Self {
                Self::$default
            }
        }

        impl Plain for $name {
            fn of(value: &Value) -> Option<Self> {
                match value {
                    Value::Key(key) => key.parse().ok(),
                    _ => None,
                }
            }

            fn value(&self) -> Value {
                Value::Key(self.key())
            }
        }
    };
}

/// Step 2: whether a triangle is treated until it is gone.
pub(super) const UNTIL_DESTROYED: &[Row] = &[
    Row { key: "false", summary: "a triangle that is still there and bad waits its turn again", source: "Ruppert95" },
    Row { key: "true", summary: "a triangle is treated again and again until it is gone", source: "MeshSuite" },
];

choices! {
    /// A recipe by name.
    #[doc(alias = "algorithm")]
    #[doc(alias = "algoritmo")]
    Preset, OffCenter, {
        OffCenter = "off-center", "off-centers, shortest edge first: few triangles, fast; the default", "Ungor09";
        Circumcenter = "circumcenter", "circumcenters, shortest edge first: Chew's and Ruppert's refinement", "Ruppert95";
        LeppBisection = "lepp-bisection", "terminal edges halved without flips: nested triangles", "Rivara97";
        LeppMidpoint = "lepp-midpoint", "middles of terminal edges, in any order", "Rivara97";
        LeppCentroid = "lepp-centroid", "centroids of terminal triangles, in any order", "RivaraCalderon10";
        LeppCircumcenter = "lepp-circumcenter", "circumcenters of terminal triangles, smallest angle first", "MeshSuite";
        LeppOffCenter = "lepp-off-center", "off-centers of terminal triangles, smallest angle first", "MeshSuite";
        Sanhueza = "sanhueza", "terminal edges flipped until Delaunay, centroids of terminal pairs, from any triangulation", "Sanhueza";
    }
}

choices! {
    /// The triangulation that refinement starts from.
    Initial, Constrained, {
        Constrained = "constrained", "constrained Delaunay: segments are edges; what is not Delaunay is flipped first", "Chew89a";
        Conforming = "conforming", "conforming Delaunay: segments inside are split until they are edges without being walls", "MeshSuite";
        Given = "given", "the triangulation as it stands, Delaunay or not", "Sanhueza";
    }
}

choices! {
    /// What wide parts are filled with before the loop, where an area bound asks for many triangles.
    Fill, Lattice, {
        None = "none", "nothing: the loop splits large triangles one after the other", "";
        Lattice = "lattice", "a lattice of equilateral triangles just below the area bound, clear of segments; up to 30 degrees", "FejesToth53";
    }
}

choices! {
    /// Step 1: what is done to segments before points are inserted.
    Prepare, SplitEncroached, {
        None = "none", "segments are left as they are", "MeshSuite";
        SplitEncroached = "split-encroached", "segments with a vertex in their protecting region are split first", "Ruppert95";
    }
}

choices! {
    /// Step 1: when segments are tested.
    PrepareWhen, Always, {
        Always = "always", "before every insertion", "Ruppert95";
        Once = "once", "once, before the first insertion", "MeshSuite";
    }
}

choices! {
    /// Step 2: which bad triangle is treated next.
    Select, ShortestEdge, {
        ShortestEdge = "shortest-edge", "the bad triangle with the shortest edge first", "Shewchuk02";
        SmallestAngle = "smallest-angle", "the bad triangle with the smallest angle first", "MeshSuite";
        SmallestCircumradius = "smallest-circumradius", "the bad triangle with the smallest circumcircle first", "MeshSuite";
        BoundaryShortestEdge = "boundary-shortest-edge", "triangles with a side on the boundary first, then by shortest edge", "MeshSuite";
        Manual = "manual", "the triangles that are picked, one after the other", "MeshSuite";
        First = "first", "the bad triangle that has waited longest first", "MeshSuite";
    }
}

choices! {
    /// Step 3: the point proposed for a bad triangle.
    #[doc(alias = "Steiner point")]
    #[doc(alias = "punto de Steiner")]
    PlacePoint, OffCenter, {
        OffCenter = "off-center", "the circumcenter, or nearer the shortest edge the point that makes its triangle just good", "Ungor09";
        OffCenterExact = "off-center-exact", "as off-center, but at 100 % of the way at which its angle is the bound, for 95 %", "Ungor09";
        Circumcenter = "circumcenter", "the center of the circumcircle", "Ruppert95";
        Incenter = "incenter", "the center of the inscribed circle, which halves every angle: for area bounds", "MeshSuite";
        LeppMidpoint = "lepp-midpoint", "the middle of the path's terminal edge", "Rivara97";
        LeppCentroid = "lepp-centroid", "the centroid of the path's two terminal triangles", "RivaraCalderon10";
        LeppCircumcenter = "lepp-circumcenter", "the circumcenter of a terminal triangle: see terminal", "MeshSuite";
        LeppOffCenter = "lepp-off-center", "the off-center of a terminal triangle: see terminal", "MeshSuite";
    }
}

choices! {
    /// Where a longest-edge propagation path ends besides at a mutual longest edge.
    LeppRule, StopAtConstraints, {
        StopAtConstraints = "constraints", "at any constrained edge: no point beyond it can improve this side", "";
        StopAtBoundary = "boundary", "at the boundary alone, as in the documents", "Valenzuela09";
    }
}

choices! {
    /// Which centroid of the quadrilateral of two terminal triangles: that of its area reproduces the published counts.
    Centroid, Area, {
        Area = "area", "of the area of the two triangles", "Valenzuela09";
        Average = "average", "the average of their four corners", "MeshSuite";
    }
}

choices! {
    /// When a constrained second-longest edge of a terminal triangle is split instead.
    ConstrainedSecond, S2, {
        Always = "always", "whenever it is constrained", "Valenzuela09";
        Never = "never", "never: the terminal edge it is", "Rivara97";
        S1 = "s1", "where the terminal triangle has an angle below the bound", "RivaraCalderon10";
        S2 = "s2", "as s1, or where the new point would make a bad triangle with it", "RivaraCalderon10";
        S3 = "s3", "where the new point would make a bad triangle with it", "RivaraCalderon10";
    }
}

choices! {
    /// Which terminal triangle gives the circumcenter or off-center.
    ///
    /// At 37 degrees the last one of the path ends where the larger one does not: circumcenters on 9 of 9 drawings (the
    /// larger one on 4) and on 14 of 20 sets of 50 random points (3). Up to 36 degrees both end, and the last one needs
    /// 1 to 27 % more vertices.
    Terminal, Last, {
        Larger = "larger", "the one with the larger circumcircle: fewer vertices up to 36 degrees, hardly ever an end at 37", "MeshSuite";
        Last = "last", "the last one of the path: ends at 37 degrees, too", "MeshSuite";
    }
}

choices! {
    /// Step 4: how the point is inserted.
    Insert, Cavity, {
        Flip = "flip", "the face or edge is split, then Lawson's flips", "Lawson77";
        Cavity = "cavity", "faces whose circle holds the point go, a fan takes their place", "Bowyer81";
        FlipOrCentroid = "flip-or-centroid", "a terminal edge that fails the circle test is flipped, else the pair is parted into four", "Sanhueza";
        Partition = "partition", "the face or edge is split, and nothing else", "Rivara97";
    }
}

choices! {
    /// Step 5: what becomes of segments inside the domain while points are inserted.
    Recover, WholeEdge, {
        None = "none", "segments inside are released, and what is missing in the end is reported", "MeshSuite";
        BySplitting = "by-splitting", "segments inside are released, and in the end split until they are chains of edges", "MeshSuite";
        Complete = "complete", "segments inside are released, and in the end put in as whole edges", "MeshSuite";
        WholeEdge = "whole-edge", "segments are edges that nothing removes", "Vigo97";
    }
}

choices! {
    /// The region of a subsegment in which a vertex encroaches upon it.
    #[doc(alias = "encroached")]
    Encroachment, Lens, {
        Lens = "lens", "where the subsegment is seen at 180 degrees less twice the angle bound, or more", "Chew93";
        DiametralDisk = "disk", "the disk of which the subsegment is a diameter", "Ruppert95";
    }
}

choices! {
    /// Which segments may not be split.
    ///
    /// With protected segments the guarantee does not hold: triangles beside them may stay bad; the report then lists
    /// them with the reason `protected segment`.
    Protect, None, {
        None = "none", "all segments may be split", "";
        Boundary = "boundary", "those on the boundary of the domain stay whole", "";
        All = "all", "all segments stay whole", "";
    }
}
