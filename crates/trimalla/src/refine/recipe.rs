//! Recipes: one choice for each of the five steps, by key.

use std::fmt;
use std::str::FromStr;

use super::lepp::{Centroid, LeppRule};

/// A row of the registry: what a key stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The step, 1 to 5; 0 for a preset, and for what refinement starts from.
    pub step: u8,
    /// What it is a choice of, by the key in recipes: `initial`, `prepare`, `prepare-when`, …; `preset` for whole
    /// recipes.
    pub option: &'static str,
    /// The key, as scripts, the program and reports spell it.
    pub key: &'static str,
    /// One line on what it does.
    pub summary: &'static str,
    /// Where it comes from, a key of REFERENCES.md; empty for what is ours.
    pub source: &'static str,
}

macro_rules! step {
    ($(#[$doc:meta])* $name:ident, $step:literal, $option:literal, $default:ident, { $($(#[$vdoc:meta])* $variant:ident = $key:literal, $summary:literal, $source:literal;)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum $name { $($(#[$vdoc])* #[doc = concat!("`", $key, "`: ", $summary, ".")] $variant,)* }

        impl $name {
            /// Every choice.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)*];

            /// Its row in the registry.
            #[must_use]
            pub const fn row(self) -> Row {
                match self {
                    $(Self::$variant => Row { step: $step, option: $option, key: $key, summary: $summary, source: $source },)*
                }
            }

            /// Its key.
            #[must_use]
            pub const fn key(self) -> &'static str {
                self.row().key
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self::$default
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.key())
            }
        }

        impl FromStr for $name {
            type Err = UnknownKey;

            fn from_str(s: &str) -> Result<Self, UnknownKey> {
                Self::ALL.iter().copied().find(|c| c.key() == s).ok_or_else(|| UnknownKey {
                    key: s.to_owned(),
                    known: Self::ALL.iter().map(|c| c.key()).collect(),
                })
            }
        }
    };
}

/// A key that names nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("nothing is called '{key}'; known are {}", .known.join(", "))]
pub struct UnknownKey {
    /// The key.
    pub key: String,
    /// Keys that do name something.
    pub known: Vec<&'static str>,
}

step! {
    /// The triangulation that refinement starts from.
    Initial, 0, "initial", Constrained, {
        Constrained = "constrained", "constrained Delaunay: segments are edges; what is not Delaunay is flipped first", "Chew89a";
        Conforming = "conforming", "conforming Delaunay: segments inside are split until they are edges without being walls", "MeshSuite";
        Given = "given", "the triangulation as it stands, Delaunay or not", "Sanhueza";
    }
}

step! {
    /// What wide parts are filled with before the loop, where an area bound asks for many triangles.
    Fill, 0, "fill", Lattice, {
        None = "none", "nothing: the loop splits large triangles one after the other", "";
        Lattice = "lattice", "a lattice of equilateral triangles just below the area bound, clear of segments; up to 30 degrees", "FejesToth53";
    }
}

step! {
    /// Step 1: what is done to segments before points go in.
    Prepare, 1, "prepare", SplitEncroached, {
        None = "none", "segments are left as they are", "MeshSuite";
        SplitEncroached = "split-encroached", "segments with a vertex in their protecting region are split first", "Ruppert95";
    }
}

step! {
    /// Step 1: when segments are looked at.
    PrepareWhen, 1, "prepare-when", Always, {
        Always = "always", "before every insertion", "Ruppert95";
        Once = "once", "once, before the first insertion", "MeshSuite";
    }
}

step! {
    /// Step 2: which bad triangle is treated next.
    Select, 2, "select", ShortestEdge, {
        ShortestEdge = "shortest-edge", "the bad triangle with the shortest edge first", "Shewchuk02";
        SmallestAngle = "smallest-angle", "the bad triangle with the smallest angle first", "MeshSuite";
        SmallestCircumradius = "smallest-circumradius", "the bad triangle with the smallest circumcircle first", "MeshSuite";
        BoundaryShortestEdge = "boundary-shortest-edge", "triangles with a side on the boundary first, then by shortest edge", "MeshSuite";
        Manual = "manual", "the triangles that are picked, one after the other", "MeshSuite";
        First = "first", "the bad triangle that has waited longest first", "MeshSuite";
    }
}

step! {
    /// Step 3: the point proposed for a bad triangle.
    PlacePoint, 3, "point", OffCenter, {
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

step! {
    /// When a constrained second-longest edge of a terminal triangle is split instead.
    ConstrainedSecond, 3, "constrained-second", S2, {
        Always = "always", "whenever it is constrained", "Valenzuela09";
        Never = "never", "never: the terminal edge it is", "Rivara97";
        S1 = "s1", "where the terminal triangle has an angle below the bound", "RivaraCalderon10";
        S2 = "s2", "as s1, or where the new point would make a bad triangle with it", "RivaraCalderon10";
        S3 = "s3", "where the new point would make a bad triangle with it", "RivaraCalderon10";
    }
}

step! {
    /// Which terminal triangle gives the circumcenter or off-center.
    ///
    /// At 37 degrees the last one of the path ends where the larger one does not: circumcenters on 9 of 9 drawings (the
    /// larger one on 4) and on 14 of 20 sets of 50 random points (3). Up to 36 degrees both end, and the last one needs
    /// 1 to 27 % more vertices.
    Terminal, 3, "terminal", Last, {
        Larger = "larger", "the one with the larger circumcircle: fewer vertices up to 36 degrees, hardly ever an end at 37", "MeshSuite";
        Last = "last", "the last one of the path: ends at 37 degrees, too", "MeshSuite";
    }
}

step! {
    /// Step 4: how the point goes in.
    Insert, 4, "insert", Cavity, {
        Flip = "flip", "the face or edge is split, then Lawson's flips", "Lawson77";
        Cavity = "cavity", "faces whose circle holds the point go, a fan takes their place", "Bowyer81";
        FlipOrCentroid = "flip-or-centroid", "a terminal edge that fails the circle test is flipped, else the pair is parted into four", "Sanhueza";
        Partition = "partition", "the face or edge is split, and nothing else", "Rivara97";
    }
}

step! {
    /// Step 5: what becomes of interior segments meanwhile.
    Recover, 5, "recover", WholeEdge, {
        None = "none", "segments inside are let go, and what is missing in the end is reported", "MeshSuite";
        BySplitting = "by-splitting", "segments inside are let go, and in the end split until they are chains of edges", "MeshSuite";
        Complete = "complete", "segments inside are let go, and in the end put in as whole edges", "MeshSuite";
        WholeEdge = "whole-edge", "segments are edges that nothing removes", "Vigo97";
    }
}

step! {
    /// The region of a subsegment in which a vertex encroaches upon it.
    Encroachment, 1, "encroachment", Lens, {
        Lens = "lens", "where the subsegment is seen at 180 degrees less twice the angle bound, or more", "Chew93";
        DiametralDisk = "disk", "the disk of which the subsegment is a diameter", "Ruppert95";
    }
}

/// One choice for each of the five steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Recipe {
    /// What to start from.
    pub initial: Initial,
    /// What wide parts are filled with before the loop.
    pub fill: Fill,
    /// Step 1.
    pub prepare: Prepare,
    /// Step 1: when.
    pub prepare_when: PrepareWhen,
    /// The region that protects subsegments, for steps 1 and 3.
    pub encroachment: Encroachment,
    /// Step 2.
    pub select: Select,
    /// Step 2: whether a triangle is treated again and again until it is gone.
    pub until_destroyed: bool,
    /// Step 3.
    pub point: PlacePoint,
    /// Step 3, LEPP: where paths end.
    pub lepp_rule: LeppRule,
    /// Step 3, `lepp-circumcenter` and `lepp-off-center`: of which triangle.
    pub terminal: Terminal,
    /// Step 3, `lepp-centroid`: which centroid.
    pub centroid: Centroid,
    /// Step 3, `lepp-midpoint` and `lepp-centroid`: what becomes of constrained second-longest edges.
    pub constrained_second: ConstrainedSecond,
    /// Step 4.
    pub insert: Insert,
    /// Step 5.
    pub recover: Recover,
}

step! {
    /// A recipe by name.
    Preset, 0, "preset", OffCenter, {
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

impl Preset {
    /// The recipe it stands for: the documents' own, but that off-centers and circumcenters go in by cavity where those
    /// say flips. The mesh is the same, vertex by vertex, and done sooner.
    #[must_use]
    pub fn recipe(self) -> Recipe {
        let lepp = Recipe {
            fill: Fill::None,
            prepare: Prepare::None,
            select: Select::First,
            until_destroyed: true,
            insert: Insert::Flip,
            ..Recipe::default()
        };
        let lepp_center = Recipe { prepare: Prepare::SplitEncroached, select: Select::SmallestAngle, ..lepp };
        match self {
            Self::OffCenter => Recipe::default(),
            Self::Circumcenter => Recipe { fill: Fill::None, point: PlacePoint::Circumcenter, ..Recipe::default() },
            Self::LeppBisection => Recipe {
                point: PlacePoint::LeppMidpoint,
                insert: Insert::Partition,
                constrained_second: ConstrainedSecond::Never,
                ..lepp
            },
            Self::LeppMidpoint => Recipe { point: PlacePoint::LeppMidpoint, ..lepp },
            Self::LeppCentroid => Recipe { point: PlacePoint::LeppCentroid, ..lepp },
            Self::LeppCircumcenter => Recipe { point: PlacePoint::LeppCircumcenter, ..lepp_center },
            Self::LeppOffCenter => Recipe { point: PlacePoint::LeppOffCenter, ..lepp_center },
            Self::Sanhueza => Recipe {
                initial: Initial::Given,
                point: PlacePoint::LeppCentroid,
                centroid: Centroid::Average,
                constrained_second: ConstrainedSecond::Never,
                insert: Insert::FlipOrCentroid,
                until_destroyed: false,
                ..lepp
            },
        }
    }
}

impl Recipe {
    /// Every choice of it: the [option](Row::option), and the key that is chosen.
    #[must_use]
    pub const fn choices(&self) -> [(&'static str, &'static str); 14] {
        let until_destroyed = if self.until_destroyed { "true" } else { "false" };
        [
            ("initial", self.initial.key()),
            ("fill", self.fill.key()),
            ("prepare", self.prepare.key()),
            ("prepare-when", self.prepare_when.key()),
            ("encroachment", self.encroachment.key()),
            ("select", self.select.key()),
            ("until-destroyed", until_destroyed),
            ("point", self.point.key()),
            ("lepp-stop", self.lepp_rule.key()),
            ("centroid", self.centroid.key()),
            ("constrained-second", self.constrained_second.key()),
            ("terminal", self.terminal.key()),
            ("insert", self.insert.key()),
            ("recover", self.recover.key()),
        ]
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { prepare, encroachment, select, point, insert, recover, .. } = self;
        let until = if self.until_destroyed { " until destroyed" } else { "" };
        write!(f, "{prepare} ({encroachment}), {select}{until}, {point}, {insert}, {recover}")
    }
}

/// Step 2: whether a triangle is treated until it is gone.
const UNTIL_DESTROYED: [Row; 2] = [
    Row {
        step: 2,
        option: "until-destroyed",
        key: "false",
        summary: "a triangle that is still there and bad waits its turn again",
        source: "Ruppert95",
    },
    Row {
        step: 2,
        option: "until-destroyed",
        key: "true",
        summary: "a triangle is treated again and again until it is gone",
        source: "MeshSuite",
    },
];

/// Every choice that a recipe has, with a row each: what `trimalla list` prints. Presets come first, then the steps in
/// order; the choices of one [option](Row::option) stand together.
#[must_use]
pub fn registry() -> Vec<Row> {
    let mut rows: Vec<Row> = Preset::ALL.iter().map(|c| c.row()).collect();
    rows.extend(Initial::ALL.iter().map(|c| c.row()));
    rows.extend(Fill::ALL.iter().map(|c| c.row()));
    rows.extend(Prepare::ALL.iter().map(|c| c.row()));
    rows.extend(PrepareWhen::ALL.iter().map(|c| c.row()));
    rows.extend(Encroachment::ALL.iter().map(|c| c.row()));
    rows.extend(Select::ALL.iter().map(|c| c.row()));
    rows.extend(UNTIL_DESTROYED);
    rows.extend(PlacePoint::ALL.iter().map(|c| c.row()));
    rows.extend(LeppRule::ALL.map(LeppRule::row));
    rows.extend(Centroid::ALL.map(Centroid::row));
    rows.extend(ConstrainedSecond::ALL.iter().map(|c| c.row()));
    rows.extend(Terminal::ALL.iter().map(|c| c.row()));
    rows.extend(Insert::ALL.iter().map(|c| c.row()));
    rows.extend(Recover::ALL.iter().map(|c| c.row()));
    rows
}
