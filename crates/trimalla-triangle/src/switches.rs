//! Words of switches and what they ask for.
//!
//! Letters cluster behind one dash, or behind none; a number sticks to its letter: `-pq30a0.1`. Numbers are digits with
//! at most one point, as in Triangle.

use trimalla::delaunay::AlgorithmKey;
use trimalla::refine::Protect;

use crate::error::SwitchError;
use crate::table;

/// What words of switches ask for.
///
/// # Units
/// Angles in degrees, areas in squared coordinate units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Switches {
    /// `-p`: the input is a drawing with segments, holes and regions.
    pub drawing: bool,
    /// `-r`: the input is a mesh, which is refined.
    pub refine: bool,
    /// `-q`: the smallest angle, 20 where no number follows.
    pub min_angle_deg: Option<f64>,
    /// `-a` with a number: the largest area of triangles.
    pub max_area: Option<f64>,
    /// `-a` without a number: the areas of regions or, under `-r`, of triangles count.
    pub own_areas: bool,
    /// `-A`: triangles get the attributes of regions.
    pub attributes: bool,
    /// `-c`: the convex hull is the domain.
    pub hull: bool,
    /// `-D`: every triangle is Delaunay, not only constrained Delaunay.
    pub conforming: bool,
    /// `-s`: segments are split until they are edges.
    pub splits_segments: bool,
    /// `-j`: vertices of no triangle are left out.
    pub jettison: bool,
    /// `-e`: edges are listed.
    pub edges: bool,
    /// `-v`: the Voronoi diagram is listed.
    pub voronoi: bool,
    /// `-n`: the neighbours of triangles are listed.
    pub neighbours: bool,
    /// `-g`: an Object File Format file is written.
    pub off: bool,
    /// `-B`: no boundary markers.
    pub no_markers: bool,
    /// `-P`: no list of subsegments.
    pub no_segments: bool,
    /// `-N`: no list of vertices.
    pub no_vertices: bool,
    /// `-E`: no list of triangles.
    pub no_triangles: bool,
    /// `-I`: no iteration numbers in names of files.
    pub no_iteration: bool,
    /// `-O`: holes of the drawing are ignored.
    pub no_holes: bool,
    /// `-z`: items are numbered from 0, where nothing else decides.
    pub from_zero: bool,
    /// `-o2`: triangles have six nodes.
    pub six_nodes: bool,
    /// `-Y`, `-YY`: which segments may not be split.
    pub protect: Protect,
    /// `-S`: the most vertices that may be added, 0 where no number follows.
    pub most_added: Option<usize>,
    /// `-i`, `-F`: how points are triangulated first.
    pub algorithm: Option<AlgorithmKey>,
    /// `-C`: the mesh is checked.
    pub check: bool,
    /// `-Q`: nothing is printed but errors.
    pub quiet: bool,
    /// `-V`, as many as there are: how much is printed.
    pub verbosity: u8,
    /// `-h`: the switches are explained, nothing else is done.
    pub help: bool,
}

impl Switches {
    /// The smallest angle where `-q` has no number, in degrees.
    pub const DEFAULT_MIN_ANGLE_DEG: f64 = 20.0;

    /// Reads one word of switches, with or without a dash before it.
    ///
    /// # Errors
    /// [`SwitchError`] names the switch and says what to use instead.
    ///
    /// # Examples
    /// ```
    /// use trimalla_triangle::Switches;
    ///
    /// let switches = Switches::parse("-pq31.5a.1")?;
    /// assert_eq!((switches.drawing, switches.min_angle_deg, switches.max_area), (true, Some(31.5), Some(0.1)));
    /// let refused = Switches::parse("pu").unwrap_err().to_string();
    /// assert!(refused.starts_with("the switch -u is not supported"), "{refused}");
    /// # Ok::<(), trimalla_triangle::SwitchError>(())
    /// ```
    pub fn parse(word: &str) -> Result<Self, SwitchError> {
        let mut switches = Self::default();
        switches.add(word)?;
        switches.validate()?;
        Ok(switches)
    }

    /// Adds what another word asks for. Call [`validate`](Self::validate) after the last one.
    ///
    /// # Errors
    /// [`SwitchError::Unknown`], [`SwitchError::Unsupported`] and [`SwitchError::Number`].
    pub fn add(&mut self, word: &str) -> Result<(), SwitchError> {
        let mut rest = word.strip_prefix('-').unwrap_or(word);
        while let Some(letter) = rest.chars().next() {
            rest = &rest[letter.len_utf8()..];
            let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').len();
            let number = match letter {
                'q' | 'a' | 'S' | 'o' | 'u' => {
                    let (number, behind) = rest.split_at(digits);
                    rest = behind;
                    number
                }
                _ => "",
            };
            self.add_switch(letter, number, word)?;
        }
        Ok(())
    }

    /// Checks that no two switches exclude each other.
    ///
    /// # Errors
    /// [`SwitchError::Conflict`].
    pub fn validate(&self) -> Result<(), SwitchError> {
        if self.refine && self.no_iteration {
            return Err(SwitchError::Conflict('r', 'I', "the mesh that is read would be overwritten"));
        }
        Ok(())
    }

    /// Whether vertices are added for the shape or the size of triangles.
    #[must_use]
    pub fn asks_for_quality(&self) -> bool {
        self.min_angle_deg.is_some() || self.max_area.is_some() || self.own_areas
    }

    fn add_switch(&mut self, letter: char, number: &str, word: &str) -> Result<(), SwitchError> {
        match letter {
            'p' => self.drawing = true,
            'r' => self.refine = true,
            'q' => self.min_angle_deg = Some(angle(number)?),
            'a' if number.is_empty() => self.own_areas = true,
            'a' => self.max_area = Some(area(number)?),
            'A' => self.attributes = true,
            'c' => self.hull = true,
            'D' => self.conforming = true,
            's' => self.splits_segments = true,
            'j' => self.jettison = true,
            'e' => self.edges = true,
            'v' => self.voronoi = true,
            'n' => self.neighbours = true,
            'g' => self.off = true,
            'B' => self.no_markers = true,
            'P' => self.no_segments = true,
            'N' => self.no_vertices = true,
            'E' => self.no_triangles = true,
            'I' => self.no_iteration = true,
            'O' => self.no_holes = true,
            'z' => self.from_zero = true,
            'o' => self.six_nodes = order(number)? == 2,
            'Y' if self.protect == Protect::None => self.protect = Protect::Boundary,
            'Y' => self.protect = Protect::All,
            'S' => self.most_added = Some(count(number)?),
            'i' => self.algorithm = Some(AlgorithmKey::Incremental),
            'F' => self.algorithm = Some(AlgorithmKey::Voronoi),
            'l' => self.algorithm = Some(AlgorithmKey::DivideAndConquer),
            'C' => self.check = true,
            'Q' => self.quiet = true,
            'V' => self.verbosity = self.verbosity.saturating_add(1),
            'h' => self.help = true,
            'X' => {} // Signs are exact, always.
            _ => return Err(refusal(letter, word)),
        }
        Ok(())
    }
}

/// Why a letter is not followed.
fn refusal(letter: char, word: &str) -> SwitchError {
    match table::instead_of(letter) {
        Some(instead) => SwitchError::Unsupported { letter, instead },
        None => SwitchError::Unknown { letter, word: word.to_owned() },
    }
}

fn angle(text: &str) -> Result<f64, SwitchError> {
    if text.is_empty() {
        return Ok(Switches::DEFAULT_MIN_ANGLE_DEG);
    }
    let expected = "an angle between 0 and 60 degrees";
    number('q', text, expected, |degrees| (0.0..=60.0).contains(&degrees))
}

fn area(text: &str) -> Result<f64, SwitchError> {
    number('a', text, "an area above zero", |area| area > 0.0 && area.is_finite())
}

fn order(text: &str) -> Result<u8, SwitchError> {
    let found = if text.is_empty() { "1" } else { text };
    match found {
        "1" => Ok(1),
        "2" => Ok(2),
        _ => Err(SwitchError::Number { letter: 'o', expected: "the order 1 or 2", found: found.to_owned() }),
    }
}

fn count(text: &str) -> Result<usize, SwitchError> {
    let wrong = || SwitchError::Number { letter: 'S', expected: "a number of vertices", found: text.to_owned() };
    if text.is_empty() { Ok(0) } else { text.parse().map_err(|_| wrong()) }
}

fn number(
    letter: char,
    text: &str,
    expected: &'static str,
    is_allowed: impl Fn(f64) -> bool,
) -> Result<f64, SwitchError> {
    let found = text.parse().ok().filter(|&number| is_allowed(number));
    found.ok_or_else(|| SwitchError::Number { letter, expected, found: text.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stick_to_their_letters() {
        let all = Switches::parse("-pq30a0.1ADenYQ").unwrap();
        let expected = Switches {
            drawing: true,
            min_angle_deg: Some(30.0),
            max_area: Some(0.1),
            attributes: true,
            conforming: true,
            edges: true,
            neighbours: true,
            protect: Protect::Boundary,
            quiet: true,
            ..Switches::default()
        };
        assert_eq!(all, expected);
        let two = Switches::parse("rpaa6.2").unwrap();
        assert_eq!((two.own_areas, two.max_area, two.min_angle_deg), (true, Some(6.2), None));
        let bare = Switches::parse("qS").unwrap();
        assert_eq!((bare.min_angle_deg, bare.most_added), (Some(20.0), Some(0)));
        assert_eq!(Switches::parse("S40YYo2VV").unwrap().most_added, Some(40));
        let mut words = Switches::default();
        words.add("-p").unwrap();
        words.add("q25").unwrap();
        words.add("-YY").unwrap();
        assert_eq!((words.min_angle_deg, words.protect), (Some(25.0), Protect::All));
    }

    #[test]
    fn what_cannot_be_followed_is_named() {
        let says = |word: &str| Switches::parse(word).unwrap_err().to_string();
        assert!(says("pu").contains("-u is not supported"));
        assert_eq!(says("-pK"), "there is no switch -K (in '-pK')");
        assert_eq!(says("pq61"), "-q takes an angle between 0 and 60 degrees, not '61'");
        assert_eq!(says("q1.2.3"), "-q takes an angle between 0 and 60 degrees, not '1.2.3'");
        assert_eq!(says("a0"), "-a takes an area above zero, not '0'");
        assert_eq!(says("o3"), "-o takes the order 1 or 2, not '3'");
        assert_eq!(says("S1.5"), "-S takes a number of vertices, not '1.5'");
        assert!(says("rI").contains("exclude each other"));
        assert_eq!(says("pé"), "there is no switch -é (in 'pé')");
    }

    #[test]
    fn every_row_of_the_table_is_read_or_refused() {
        for row in table::ROWS {
            let found = Switches::parse(&row.letter.to_string());
            let is_refused = matches!(found, Err(SwitchError::Unsupported { .. }));
            assert_eq!(is_refused, row.verdict == table::Verdict::Refused, "-{}: {found:?}", row.letter);
        }
    }
}
