//! Writes the chapter on triangulations: `docs/textbook/README.md` and its figures.
//!
//! `cargo run --release -p trimalla-io --example textbook`. The prose is that of the algorithms' own files, the figures
//! are drawn by trimalla, and the numbers are measured here; the same bytes come out on every machine.

mod figures;
mod prose;
mod table;

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use trimalla::Method;

use prose::Section;

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = root.join("docs/textbook");
    fs::create_dir_all(&folder)?;
    figures::write_all(&folder)?;
    let mut page = String::from(prose::BEGINNING);
    page += "\n## Which is best for what\n\n";
    page += &table::criteria()?;
    for part in prose::PARTS {
        let _ = write!(page, "\n## {}\n\n{}\n", part.title, part.text);
        for section in part.sections {
            page += &written(&root, section)?;
        }
    }
    fs::write(folder.join("README.md"), page)?;
    Ok(())
}

/// A section: its title, what the keys and commands do, its figures, and the prose of its file.
fn written(root: &std::path::Path, section: &Section) -> Result<String, Box<dyn Error>> {
    let mut text = format!("\n### {}\n\n", section.title);
    for key in section.keys {
        let row = key.parse::<Method>()?.row();
        let _ = writeln!(text, "- `trimalla triangulate --algorithm {key}`: {}.", row.summary);
    }
    for (command, what) in section.commands {
        let _ = writeln!(text, "- `trimalla {command}`: {what}.");
    }
    for (name, caption) in section.figures {
        let _ = writeln!(text, "\n![{caption}]({name}.svg)");
    }
    let source = fs::read_to_string(root.join("crates/trimalla/src").join(section.file))?;
    let _ = write!(text, "\n{}", prose::of_module(&source));
    let _ = writeln!(text, "\nIn the code: [{0}](../../crates/trimalla/src/{0}).", section.file);
    Ok(text)
}
