//! Every switch of Triangle, and what it does here.

/// How a switch compares with Triangle's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It means the same.
    Same,
    /// It is read, and does something else in part.
    Differs,
    /// It is refused, with what to use instead.
    Refused,
}

/// A switch and what it does here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The letter.
    pub letter: char,
    /// The switch as one writes it, with what may follow.
    pub form: &'static str,
    /// What it does.
    pub summary: &'static str,
    /// Whether Triangle does the same.
    pub verdict: Verdict,
    /// Where it differs, or what to use instead; empty where it is the same.
    pub note: &'static str,
}

const fn same(letter: char, form: &'static str, summary: &'static str) -> Row {
    Row { letter, form, summary, verdict: Verdict::Same, note: "" }
}

const fn differs(letter: char, form: &'static str, summary: &'static str, note: &'static str) -> Row {
    Row { letter, form, summary, verdict: Verdict::Differs, note }
}

/// All switches, in the order of Triangle's instructions.
pub const ROWS: &[Row] = &[
    same('p', "-p", "read a drawing, FILE.poly: segments, holes, regions"),
    same('r', "-r", "refine a mesh, FILE.node and FILE.ele; with -p its subsegments from FILE.poly"),
    differs(
        'q',
        "-q, -q30",
        "no angle below 20 degrees, or the given bound",
        "always ends; new vertices lie elsewhere",
    ),
    differs(
        'a',
        "-a0.1, -a",
        "no triangle above this area; alone: areas of regions, or with -r of FILE.area",
        "wide parts are filled with a lattice",
    ),
    Row {
        letter: 'u',
        form: "-u",
        summary: "a test of the caller's own",
        verdict: Verdict::Refused,
        note: "it is compiled into Triangle; use Start::with_test of the Rust library, or an .area file with -ra",
    },
    same('A', "-A", "give triangles the attributes of the drawing's regions, 0 elsewhere"),
    same('c', "-c", "keep the convex hull, with its edges as segments"),
    same('D', "-D", "split segments until every triangle is Delaunay"),
    differs('j', "-j", "leave vertices of no triangle out of the output", "of equal vertices the first stays"),
    same('e', "-e", "write the edges, .edge"),
    same('v', "-v", "write the Voronoi diagram, .v.node and .v.edge"),
    same('n', "-n", "write the neighbours of triangles, .neigh"),
    same('g', "-g", "write an Object File Format file, .off"),
    same('B', "-B", "no boundary markers in files"),
    same('P', "-P", "no .poly file"),
    same('N', "-N", "no .node file"),
    same('E', "-E", "no .ele file"),
    same(
        'I',
        "-I",
        "no iteration numbers: FILE.ele instead of FILE.1.ele, and no .node and .poly that replace the input",
    ),
    same('O', "-O", "ignore the holes of the drawing"),
    differs('X', "-X", "nothing", "signs are exact, always"),
    same('z', "-z", "number from 0, in calls from C; a file's own numbers decide otherwise"),
    same('o', "-o2", "triangles with six nodes"),
    same('Y', "-Y, -YY", "split no segment on the boundary; none at all"),
    same('S', "-S100", "add at most so many vertices; alone: none"),
    same('i', "-i", "triangulate points by insertion: the result is the same"),
    same('F', "-F", "triangulate points by Fortune's sweep: the result is the same, and exact"),
    differs(
        'l',
        "-l",
        "triangulate points by divide and conquer: the result is the same",
        "cuts as that algorithm does",
    ),
    differs(
        's',
        "-s",
        "split segments instead of forcing them in",
        "with -q, -a or -D no difference; else until they are Delaunay edges",
    ),
    same('C', "-C", "check the mesh, and fail where it is at fault"),
    same('Q', "-Q", "print nothing but errors"),
    differs('V', "-V", "print more: angles, areas, times", "our statistics"),
    same('h', "-h", "explain the switches"),
];

/// What to use instead of a switch that is refused.
pub(crate) fn instead_of(letter: char) -> Option<&'static str> {
    ROWS.iter().find(|row| row.letter == letter && row.verdict == Verdict::Refused).map(|row| row.note)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The row as `docs/triangle.md` has it.
    fn line(row: &Row) -> String {
        let verdict = match row.verdict {
            Verdict::Same => "same",
            Verdict::Differs => "differs",
            Verdict::Refused => "refused",
        };
        format!("| `{}` | {} | {verdict} | {} |", row.form, row.summary, row.note).replace("|  |", "| |")
    }

    #[test]
    fn the_page_has_every_row() {
        let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/triangle.md");
        let page = std::fs::read_to_string(page).unwrap();
        let missing: Vec<_> = ROWS.iter().map(line).filter(|line| !page.lines().any(|found| found == line)).collect();
        assert!(missing.is_empty(), "docs/triangle.md lacks\n{}", missing.join("\n"));
    }
}
