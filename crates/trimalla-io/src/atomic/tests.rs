//! Groups whose process is gone. A directory is copied while a group is at work on it: nobody holds the lock of the
//! copy.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use super::moves::Move;
use super::*;

fn scratch(name: &str) -> PathBuf {
    let path = env::temp_dir().join(format!("trimalla-io-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path.canonicalize().unwrap()
}

/// Everything in a directory, and in the folders in it, by name.
fn contents(directory: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_name().unwrap().to_string_lossy().into_owned();
        if entry.is_dir() {
            found.extend(contents(&entry).into_iter().map(|(inner, text)| (format!("{name}/{inner}"), text)));
        } else {
            found.push((name, fs::read_to_string(entry).unwrap()));
        }
    }
    found.sort();
    found
}

/// Copies what a killed process would leave; files keep their times.
fn as_after_a_kill(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()) {
        let copy = to.join(entry.file_name().unwrap());
        if entry.is_dir() {
            as_after_a_kill(&entry, &copy);
            let modified = fs::metadata(&entry).unwrap().modified().unwrap();
            File::open(&copy).unwrap().set_modified(modified).unwrap();
        } else {
            fs::copy(&entry, &copy).unwrap();
            let modified = fs::metadata(&entry).unwrap().modified().unwrap();
            File::options().append(true).open(&copy).unwrap().set_modified(modified).unwrap();
        }
    }
}

/// The old files: two of three, and a folder with two pictures.
fn put_old(directory: &Path) {
    fs::write(directory.join("a"), "old a").unwrap();
    fs::write(directory.join("b"), "old b").unwrap();
    fs::create_dir(directory.join("f")).unwrap();
    for number in 1..3 {
        fs::write(directory.join(format!("f/{number:06}.svg")), "old picture").unwrap();
    }
}

/// A group that is complete and waits for its commit.
fn staged(directory: &Path) -> Group {
    let mut group = Group::default();
    for name in ["a", "b", "c"] {
        group.add(&directory.join(name), |out| write!(out, "new {name}")).unwrap();
    }
    let mut pictures = group.begin_pictures(&directory.join("f")).unwrap();
    pictures.add(1, "new picture").unwrap();
    group.end_pictures(pictures).unwrap();
    group
}

fn all_old(directory: &Path) -> Vec<(String, String)> {
    let _ = fs::remove_dir_all(directory);
    fs::create_dir(directory).unwrap();
    put_old(directory);
    contents(directory)
}

fn all_new(directory: &Path) -> Vec<(String, String)> {
    let _ = fs::remove_dir_all(directory);
    fs::create_dir(directory).unwrap();
    put_old(directory);
    staged(directory).commit().unwrap();
    contents(directory)
}

/// Kills a group after each of its steps and looks at what [`recover`] makes of it.
#[test]
fn a_group_killed_anywhere_is_old_or_new_after_recovery() {
    let root = scratch("killed");
    let (old, new) = (all_old(&root.join("old")), all_new(&root.join("new")));
    assert_eq!(new.iter().map(|(name, _)| &name[..]).collect::<Vec<_>>(), ["a", "b", "c", "f/000001.svg"]);
    let live = root.join("live");
    let check = |name: &str, expected: &[(String, String)]| {
        let copy = root.join(name);
        as_after_a_kill(&live, &copy);
        let found = recover(&copy);
        assert_eq!(contents(&copy), expected, "{name}: {found:?}");
        assert!(!found.removed.is_empty() || !found.completed.is_empty(), "{name}");
        assert_eq!(recover(&copy), Recovered::default(), "{name}: nothing is left for a second time");
    };
    for renamed in 0..=4 {
        all_old(&live);
        let group = staged(&live);
        check(&format!("before-record-{renamed}"), &old);
        group.record().unwrap();
        carry_out(&group.moves[..renamed]).unwrap();
        check(&format!("after-{renamed}"), &new);
        assert_eq!(recover(&live), Recovered::default(), "this process lives");
    }
    // The old folder is aside and the new one not there yet.
    all_old(&live);
    let group = staged(&live);
    group.record().unwrap();
    fs::rename(live.join("f"), group.moves[3].temporary().with_extension("old")).unwrap();
    check("halfway", &new);
    // A temporary file without a lock file.
    fs::write(live.join(".trimalla-1-1-1.tmp"), "half").unwrap();
    fs::write(live.join(".trimalla-rc"), "the user's").unwrap();
    let found = recover(&live);
    assert_eq!(found.removed, [live.join(".trimalla-1-1-1.tmp")]);
    assert!(live.join(".trimalla-rc").exists());
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn a_record_without_its_end_is_none() {
    let root = scratch("torn");
    let (old, live) = (all_old(&root.join("old")), root.join("live"));
    all_old(&live);
    let group = staged(&live);
    group.record().unwrap();
    let lock = group.claims[0].path();
    let record = fs::read(&lock).unwrap();
    for length in [0, 1, record.len() / 2, record.len() - 1] {
        let copy = root.join(format!("copy-{length}"));
        as_after_a_kill(&live, &copy);
        fs::write(copy.join(lock.file_name().unwrap()), &record[..length]).unwrap();
        recover(&copy);
        assert_eq!(contents(&copy), old);
    }
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn what_was_changed_after_the_kill_stays() {
    let root = scratch("changed");
    let (live, copy) = (root.join("live"), root.join("copy"));
    all_old(&live);
    let group = staged(&live);
    group.record().unwrap();
    carry_out(&group.moves[..1]).unwrap();
    as_after_a_kill(&live, &copy);
    fs::write(copy.join("b"), "the user's own").unwrap();
    let found = recover(&copy);
    assert!(found.completed.is_empty(), "{found:?}");
    let names: Vec<_> = contents(&copy);
    let expected =
        [("a", "new a"), ("b", "the user's own"), ("f/000001.svg", "old picture"), ("f/000002.svg", "old picture")];
    assert_eq!(names, expected.map(|(name, text)| (name.to_owned(), text.to_owned())));
    fs::remove_dir_all(root).unwrap();
}

/// Two directories: the record is in the first, and recovery of either settles both.
#[test]
fn a_group_in_two_directories_is_settled_from_either() {
    let root = scratch("two");
    for (case, first) in [("from-head", "one"), ("from-member", "two")] {
        let live = root.join(case);
        for name in ["one", "two"] {
            fs::create_dir_all(live.join(name)).unwrap();
            fs::write(live.join(name).join("a"), "old").unwrap();
        }
        let mut group = Group::default();
        for name in ["one", "two"] {
            group.add(&live.join(name).join("a"), |out| write!(out, "new")).unwrap();
        }
        group.record().unwrap();
        carry_out(&group.moves[..1]).unwrap();
        // Locks go with their files: the group's own are put aside and copies in their places.
        for claim in &group.claims {
            let record = fs::read(claim.path()).unwrap();
            fs::remove_file(claim.path()).unwrap();
            fs::write(claim.path(), record).unwrap();
        }
        let found = recover(live.join(first));
        assert_eq!(found.completed.len(), 2, "{found:?}");
        for name in ["one", "two"] {
            assert_eq!(contents(&live.join(name)), [("a".to_owned(), "new".to_owned())], "{case}");
        }
    }
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn a_rename_that_fails_undoes_those_before_it() {
    let root = scratch("undo");
    let (old, live) = (all_old(&root.join("old")), root.join("live"));
    all_old(&live);
    let group = staged(&live);
    fs::create_dir(live.join("c")).unwrap(); // In the way of the third file.
    fs::write(live.join("c/inner"), "kept").unwrap();
    let error = group.commit().unwrap_err();
    assert!(error.to_string().contains("c: "), "{error}");
    fs::remove_dir_all(live.join("c")).unwrap();
    assert_eq!(contents(&live), old);
    // A picture of the user's own appears in the folder meanwhile.
    let group = staged(&live);
    fs::write(live.join("f/holiday.jpg"), "beach").unwrap();
    assert!(group.commit().unwrap_err().to_string().contains("holiday.jpg"));
    fs::remove_file(live.join("f/holiday.jpg")).unwrap();
    assert_eq!(contents(&live), old);
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn moves_are_named_whatever_their_paths() {
    let root = scratch("names");
    let names = ["with space", "with\nnewline", "..dots"];
    let mut group = Group::default();
    for name in names {
        group.add(&root.join(name), |out| write!(out, "x")).unwrap();
    }
    group.record().unwrap();
    let bytes = fs::read(group.claims[0].path()).unwrap();
    let record::Record::Head { others, moves } = record::Record::parse(&bytes, &root) else { panic!("no record") };
    assert!(others.is_empty());
    let targets: Vec<_> = moves.iter().map(Move::target).collect();
    assert_eq!(targets, names.map(|name| root.join(name)));
    drop(moves);
    drop(group);
    assert!(contents(&root).is_empty());
    fs::remove_dir_all(root).unwrap();
}
