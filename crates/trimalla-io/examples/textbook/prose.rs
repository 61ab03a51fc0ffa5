//! The parts of the chapter, and the prose that stands in the files of the algorithms.

/// A part of the chapter.
pub(crate) struct Part {
    pub(crate) title: &'static str,
    pub(crate) text: &'static str,
    pub(crate) sections: &'static [Section],
}

/// A section: one file of the library, whose algorithms share it.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    /// The keys of the algorithms.
    pub(crate) keys: &'static [&'static str],
    /// Other commands that answer the question of the section, with what they do.
    pub(crate) commands: &'static [(&'static str, &'static str)],
    /// The names of its figures, with captions.
    pub(crate) figures: &'static [(&'static str, &'static str)],
    /// Below `crates/trimalla/src`.
    pub(crate) file: &'static str,
}

pub(crate) const BEGINNING: &str = "\
# Triangulations

Every way to triangulate points and polygons that the lecture notes [Triangulaciones] describe, and what has become of
them since. Each is a function of the library, a key of `trimalla triangulate --algorithm KEY`, a command of scripts
(`Triangulate KEY`, then `Watch` for its steps), and a page that plays it (`--player run.html`).

This page is written by `cargo run --release -p trimalla-io --example textbook`: the prose is that of the files, the
figures are drawn by trimalla. Keys in brackets are those of [REFERENCES.md](../../REFERENCES.md).

*Slips of the notes*: they count O(n²) for the first algorithm, where a test of a pair is one step; a start vertex has an
angle below 180 degrees, and a split vertex one above; their sweep goes along x and their stack along y; the least weight
is not \"not known to be polynomial\" but NP-hard since 2006. Chazelle's linear-time triangulation is not built: nobody
has been seen to use it, its constants are large, and Seidel's and the sweep take less time at every size that fits into
memory. Nor is the quasi-greedy triangulation, the \"best approximation\" of the notes: the section on the shortest edges
first says why.
";

pub(crate) const PARTS: &[Part] = &[
    Part {
        title: "Points: the Delaunay triangulation",
        text: "Five ways to the same triangles. Ties between cocircular points go by one rule, so that the result is unique.",
        sections: &[
            Section {
                title: "One point after the other",
                keys: &["incremental"],
                commands: &[],
                figures: &[("incremental", "24 points, triangulated")],
                file: "delaunay/incremental.rs",
            },
            Section {
                title: "Halves merged",
                keys: &["divide-and-conquer"],
                commands: &[],
                figures: &[],
                file: "delaunay/divide_and_conquer/mod.rs",
            },
            Section { title: "Flips", keys: &["flip"], commands: &[], figures: &[], file: "delaunay/flip.rs" },
            Section {
                title: "Lifted to a paraboloid",
                keys: &["lift"],
                commands: &[],
                figures: &[],
                file: "delaunay/lift.rs",
            },
            Section {
                title: "The Voronoi diagram first",
                keys: &["voronoi"],
                commands: &[],
                figures: &[("diagram", "the Voronoi diagram of the points, clipped to a box")],
                file: "delaunay/voronoi/mod.rs",
            },
        ],
    },
    Part {
        title: "Points: greedy, locally optimal, optimal",
        text: "Other criteria than the circle test. They also take a domain: its boundary and its segments are kept.",
        sections: &[
            Section {
                title: "Pairs in any order",
                keys: &["pairs"],
                commands: &[],
                figures: &[("pairs", "pairs joined in the order of their indices")],
                file: "optimal/pairs.rs",
            },
            Section {
                title: "The shortest edges first",
                keys: &["greedy", "greedy-naive"],
                commands: &[],
                figures: &[("greedy", "the shortest edges first")],
                file: "optimal/greedy/mod.rs",
            },
            Section {
                title: "Flips by other criteria",
                keys: &["flip-max-min-angle", "flip-min-max-angle", "flip-shortest-diagonal"],
                commands: &[],
                figures: &[("flip-shortest-diagonal", "no other diagonal is shorter")],
                file: "optimal/flips.rs",
            },
            Section {
                title: "Edge insertion",
                keys: &["min-max-angle", "max-min-height", "min-max-slope"],
                commands: &[],
                figures: &[
                    ("min-max-angle", "the largest angle is as small as possible"),
                    ("min-max-slope", "the steepest triangle is as flat as possible"),
                ],
                file: "optimal/edge_insertion/mod.rs",
            },
            Section {
                title: "The longest edge as short as possible",
                keys: &["min-max-length", "min-max-length-by-tree"],
                commands: &[],
                figures: &[("min-max-length", "the longest edge is as short as possible")],
                file: "optimal/min_max_length/mod.rs",
            },
            Section {
                title: "Least weight",
                keys: &["min-weight"],
                commands: &[],
                figures: &[("min-weight", "the sum of all lengths is as small as possible")],
                file: "optimal/min_weight/mod.rs",
            },
            Section {
                title: "Least weight of a polygon",
                keys: &["min-weight-polygon"],
                commands: &[],
                figures: &[("min-weight-polygon", "the outline, with the least sum of lengths")],
                file: "optimal/min_weight_polygon/mod.rs",
            },
        ],
    },
    Part {
        title: "Polygons",
        text: "The corners of a polygon are triangulated, and nothing is added. Holes are taken by all but `diagonals`.",
        sections: &[
            Section {
                title: "Diagonals",
                keys: &["diagonals"],
                commands: &[],
                figures: &[("diagonals", "the outline, divided by diagonals")],
                file: "polygon/diagonals.rs",
            },
            Section {
                title: "Visible pairs",
                keys: &["visible-pairs"],
                commands: &[],
                figures: &[("visible-pairs", "vertices that see each other, joined")],
                file: "polygon/visible_pairs.rs",
            },
            Section {
                title: "Ears",
                keys: &["ears"],
                commands: &[],
                figures: &[("ears", "ears cut off one after the other")],
                file: "polygon/ears.rs",
            },
            Section {
                title: "Monotone pieces",
                keys: &["monotone"],
                commands: &[],
                figures: &[("pieces", "the monotone pieces"), ("monotone", "the pieces, triangulated")],
                file: "polygon/monotone.rs",
            },
            Section {
                title: "Seidel's trapezoids",
                keys: &["seidel"],
                commands: &[],
                figures: &[("trapezoids", "the trapezoids"), ("seidel", "their triangles")],
                file: "polygon/seidel/mod.rs",
            },
            Section {
                title: "Constrained Delaunay",
                keys: &["constrained-delaunay"],
                commands: &[],
                figures: &[("constrained-delaunay", "no vertex that a triangle sees lies in its circle")],
                file: "polygon/constrained_delaunay.rs",
            },
            Section {
                title: "The art gallery",
                keys: &["art-gallery"],
                commands: &[(
                    "guards plan.poly -o guards.svg",
                    "places the guards, proves that they see everything, and lists them",
                )],
                figures: &[("art-gallery", "three colours, and a guard at each corner of the rarest one")],
                file: "polygon/gallery.rs",
            },
            Section {
                title: "Visibility",
                keys: &[],
                commands: &[
                    ("visible plan.poly --from 40,40 -o seen.svg", "the visibility polygon of a point"),
                    ("visible plan.poly --from 40,40 --to 100,30", "whether two points see each other"),
                ],
                figures: &[("visibility", "what a point sees")],
                file: "polygon/visibility.rs",
            },
        ],
    },
    Part {
        title: "What is built on them",
        text: "The dual, and values between vertices.",
        sections: &[
            Section {
                title: "The Voronoi diagram",
                keys: &[],
                commands: &[("voronoi points.node --clip domain -o cells.svg", "the cells, clipped to the domain")],
                figures: &[("diagram", "the cells, clipped to a box")],
                file: "dual/mod.rs",
            },
            Section {
                title: "Heights between points, and contour lines",
                keys: &[],
                commands: &[
                    ("interpolate terrain.node places.node -o heights.csv", "heights at places"),
                    ("contour terrain.node --step 10 -o lines.svg", "lines of equal height"),
                ],
                figures: &[("contours", "contour lines of the heights of the points")],
                file: "interpolate/mod.rs",
            },
        ],
    },
];

/// The text at the head of a module, for a page: headings three levels down, links of code taken out.
pub(crate) fn of_module(source: &str) -> String {
    let mut text = String::new();
    let mut is_fenced = false;
    for line in source.lines().map_while(|line| line.strip_prefix("//!")) {
        let line = line.strip_prefix(' ').unwrap_or(line);
        if line.starts_with("```") {
            is_fenced = !is_fenced;
        } else if !is_fenced && line.starts_with("# ") {
            text += "###";
        }
        text += &if is_fenced { line.to_owned() } else { without_links(line) };
        text.push('\n');
    }
    text
}

/// A line in which code that is a link is code alone.
fn without_links(line: &str) -> String {
    let mut rest = line;
    let mut text = String::new();
    while let Some((before, after)) = rest.split_once("[`") {
        text += before;
        let Some((code, behind)) = after.split_once("`]") else {
            text += "[`";
            rest = after;
            continue;
        };
        text += &format!("`{code}`");
        rest = behind.strip_prefix('(').and_then(|target| target.split_once(')')).map_or(behind, |(_, rest)| rest);
    }
    text + rest
}
