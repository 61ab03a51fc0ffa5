//! Scripts that explain, and their scenes.

/// A part of a script that is shown at a time: a caption, and the commands that it is about.
///
/// ```text
/// # Two triangles share this edge.      the caption: comment lines, without '#', joined by blanks
/// Show 0 1 2                            the lines: up to the next comment line
/// Flip 0 2
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scene {
    /// The text of the comment before the commands; may be empty.
    pub caption: String,
    /// The number of the first of the lines, counted from 1; that of the comment where there are no lines.
    pub line_number: usize,
    /// Consecutive lines of the script; blank ones between them stand as they are. None where a comment stands alone,
    /// with a blank line or the end of the script behind it.
    pub lines: Vec<String>,
}

/// The scenes of a script. All its commands are in them, in order, and so is the text of all comments that stand on
/// lines of their own.
///
/// # Examples
/// ```
/// use trimalla_workbench::script;
///
/// let scenes = script::scenes("# A title.\n\n# Three points\n# and a triangle.\nV 0 0 0\nV 1 4 0\n\nV 2 0 3\nTriangulate\n");
/// assert_eq!((scenes[0].caption.as_str(), scenes[0].lines.len()), ("A title.", 0));
/// assert_eq!((scenes[1].caption.as_str(), scenes[1].line_number), ("Three points and a triangle.", 5));
/// assert_eq!(scenes[1].lines, ["V 0 0 0", "V 1 4 0", "", "V 2 0 3", "Triangulate"]);
/// ```
#[must_use]
pub fn scenes(text: &str) -> Vec<Scene> {
    let (mut scenes, mut scene) = (Vec::new(), Scene::default());
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if let Some(comment) = line.strip_prefix('#') {
            if !scene.lines.is_empty() {
                scenes.push(ended(std::mem::take(&mut scene)));
            }
            if scene.caption.is_empty() {
                scene.line_number = number;
            } else {
                scene.caption.push(' ');
            }
            scene.caption.push_str(comment.trim());
        } else if !line.is_empty() || !scene.lines.is_empty() {
            if scene.lines.is_empty() {
                scene.line_number = number;
            }
            scene.lines.push(line.to_owned());
        } else if !scene.caption.is_empty() {
            scenes.push(std::mem::take(&mut scene));
        }
    }
    if scene != Scene::default() {
        scenes.push(ended(scene));
    }
    scenes
}

/// A scene without blank lines at its end.
fn ended(mut scene: Scene) -> Scene {
    while scene.lines.last().is_some_and(String::is_empty) {
        scene.lines.pop();
    }
    scene
}

/// A script that explains something, scene by scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lesson {
    /// What it explains.
    pub title: &'static str,
    /// The script. It reads and writes no files.
    pub text: &'static str,
}

/// The lessons of `data/scripts/learn`.
pub const LEARN: &[Lesson] = &[
    Lesson { title: "Delaunay by flips", text: include_str!("../data/learn/01-flips.tri") },
    Lesson { title: "Incremental insertion", text: include_str!("../data/learn/02-incremental.tri") },
    Lesson { title: "Divide and conquer", text: include_str!("../data/learn/03-divide-and-conquer.tri") },
    Lesson { title: "A segment in two phases", text: include_str!("../data/learn/04-segment-in-two-phases.tri") },
    Lesson { title: "A longest-edge path", text: include_str!("../data/learn/05-longest-edge-path.tri") },
    Lesson { title: "Five places for a point", text: include_str!("../data/learn/06-five-places-for-a-point.tri") },
    Lesson { title: "Why 36 degrees is hard", text: include_str!("../data/learn/07-why-36-is-hard.tri") },
    Lesson { title: "Joining pairs", text: include_str!("../data/learn/08-pairs.tri") },
    Lesson { title: "Greedy", text: include_str!("../data/learn/09-greedy.tri") },
    Lesson { title: "Flips to the end", text: include_str!("../data/learn/10-flip.tri") },
    Lesson { title: "Lifting to a paraboloid", text: include_str!("../data/learn/11-lift.tri") },
    Lesson { title: "Monotone pieces", text: include_str!("../data/learn/12-monotone.tri") },
    Lesson { title: "Seidel's trapezoids", text: include_str!("../data/learn/13-seidel.tri") },
    Lesson { title: "Ears", text: include_str!("../data/learn/14-ears.tri") },
    Lesson { title: "The art gallery", text: include_str!("../data/learn/15-art-gallery.tri") },
];
