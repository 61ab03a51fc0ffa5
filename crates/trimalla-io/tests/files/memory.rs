//! Files in memory: the same drawings and meshes as from the disk, with the same errors.

use std::io::Write as _;
use std::path::Path;

use trimalla_io::{Files, IoError, Memory, WriteOptions, read_mesh, read_pslg, write_mesh};

use super::common::{ELE, MESHSUITE, NODE, POLY, SOUP, scratch};

/// Samples in memory and on the disk.
fn samples(folder: &Path) -> Files {
    let memory = Memory::default();
    for (name, text) in [
        ("a.node", NODE),
        ("a.ele", ELE),
        ("p.poly", POLY),
        ("m.mesh", MESHSUITE),
        ("s.soup", SOUP),
        ("a.poly", "0\n0\n0\n"),
    ] {
        std::fs::write(folder.join(name), text).expect("written");
        memory.put(name, text);
    }
    Files::Memory(memory)
}

#[test]
fn what_is_read_from_memory_is_what_the_disk_gives() {
    let folder = scratch("memory-read");
    let files = samples(&folder);
    let text = |error: IoError| error.to_string().replace(&format!("{}/", folder.display()), "");
    let same = |a: String, b: String, name: &str| assert_eq!(a.replace('\\', "/"), b, "{name}");
    for name in
        ["a.node", "a.ele", "a", "a.poly", "p.poly", "p", "m.mesh", "s.soup", "nothing.poly", "nothing.ele", "b"]
    {
        let (disk, held) = (read_pslg(folder.join(name)), files.read_pslg(name));
        same(format!("{:?}", disk.map_err(text)), format!("{:?}", held.map_err(text)), name);
        let (disk, held) = (read_mesh(folder.join(name)), files.read_mesh(name));
        same(format!("{:?}", disk.map_err(text)), format!("{:?}", held.map_err(text)), name);
    }
}

#[test]
fn a_mesh_is_written_whole_or_not_at_all() {
    let folder = scratch("memory-written");
    let files = samples(&folder);
    let Files::Memory(memory) = &files else { panic!("they are in memory") };
    let mesh = files.read_mesh("a.ele").expect("a mesh");
    let before = memory.names();
    let mut outputs = files.outputs("b.ele");
    outputs.add_mesh("b.ele", &mesh, &WriteOptions::default()).expect("prepared");
    outputs.add_mesh("b.xyz", &mesh, &WriteOptions::default()).expect_err("no such format");
    outputs.begin("b.txt").expect_err("nothing is written piece by piece");
    outputs.begin_pictures("b").expect_err("there are no folders");
    assert_eq!(memory.names(), before, "nothing appears before it is complete");
    drop(outputs);
    assert_eq!(memory.names(), before);
    let mut outputs = files.outputs("b.ele");
    outputs.add_mesh("b.ele", &mesh, &WriteOptions::default()).expect("prepared");
    outputs.commit().expect("written");
    assert_eq!(memory.names().len(), before.len() + 3);
    write_mesh(folder.join("b.ele"), &mesh, &WriteOptions::default()).expect("written");
    for name in ["b.node", "b.ele", "b.poly"] {
        let held = memory.get(name).expect("a file");
        assert_eq!(&*held, std::fs::read(folder.join(name)).expect("a file"), "{name}");
    }
}

#[test]
fn a_draft_of_the_disk_is_no_output_in_memory() {
    let folder = scratch("memory-draft");
    let mut disk = trimalla_io::Outputs::default();
    let mut draft = disk.begin(folder.join("steps.txt")).expect("begun");
    writeln!(draft, "step 1").expect("written");
    let memory = Memory::default();
    Files::Memory(memory.clone()).outputs("steps.txt").end(draft).expect_err("it belongs to others");
    assert!(memory.names().is_empty());
    assert!(!folder.join("steps.txt").exists());
}

#[test]
fn names_in_memory_are_compared_without_dots() {
    let memory = Memory::default();
    memory.put("./folder/./a.txt", "text");
    assert_eq!(memory.get("folder/a.txt").as_deref(), Some(&b"text"[..]));
    let files = Files::Memory(memory.clone());
    assert!(files.is_there(Path::new("folder/a.txt")));
    assert!(files.is_same(Path::new("folder/a.txt"), Path::new("./folder/a.txt")));
    assert!(!files.is_same(Path::new("a.txt"), Path::new("folder/a.txt")));
    assert_eq!(files.read_bytes("folder/a.txt", 4).expect("a text"), b"text");
    assert!(matches!(files.read_bytes("folder/a.txt", 3), Err(IoError::Unreadable { .. })), "it is longer");
    memory.put("binary", [1, 0, 2]);
    assert!(matches!(files.read_bytes("binary", 9), Err(IoError::Unreadable { .. })), "it is no text");
    assert!(matches!(files.read_bytes("nowhere", 9), Err(IoError::Missing { .. })));
}
