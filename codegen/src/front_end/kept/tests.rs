//! A kept expansion is the same code, and one that does not belong to its tokens, file or engine is not used.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

use proc_macro2::TokenStream;
use quote::quote;

use super::{Kept, MOST, surplus};
use crate::front_end::derive;

/// A robot with a warning: its axis is not of length 1.
const ROD: &str = r#"<robot name="rod"><link name="base"/>
    <link name="rod"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/></inertial></link>
    <joint name="hinge" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="0 2 0"/></joint></robot>"#;

/// A folder that is removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("homogen-kept-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        fs::write(folder.join("rod.urdf"), ROD).expect("a file");
        Self(folder)
    }

    fn expansions(&self) -> PathBuf {
        self.0.join("expansions")
    }

    /// The expansion of the robot, by an engine that keeps what it expands.
    fn expanded(&self, engine: &str, function: &str) -> String {
        let folder = self.expansions();
        let kept = Kept {
            folder: &folder,
            engine,
            parse: |text| text.parse().ok(),
        };
        derive(self.tokens(function), Some(&kept)).to_string()
    }

    fn tokens(&self, function: &str) -> TokenStream {
        let path = self.0.join("rod.urdf");
        let path = path.to_str().expect("UTF-8");
        let function: TokenStream = function.parse().expect("a name");
        quote! { #[robot(urdf = #path, generate(#function))] struct Rod; }
    }

    /// The kept files.
    fn files(&self) -> Vec<PathBuf> {
        let files = fs::read_dir(self.expansions());
        let files = files.into_iter().flatten().flatten();
        files.map(|file| file.path()).collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_kept_expansion_is_the_same_code_with_the_same_warnings() {
    let folder = Folder::new("same");
    let without = derive(folder.tokens("gravity"), None).to_string();
    assert!(without.contains("is normalised"), "{without}");
    let first = folder.expanded("1", "gravity");
    let [file] = &folder.files()[..] else {
        panic!("{:?}", folder.files());
    };
    let second = folder.expanded("1", "gravity");
    assert_eq!([&first, &second], [&without; 2]);
    // It is read, not expanded again.
    let text = fs::read_to_string(file).expect("kept");
    let other = text.replace("is normalised", "IS NORMALISED");
    fs::write(file, other).expect("written");
    let third = folder.expanded("1", "gravity");
    assert_eq!(third, without.replace("is normalised", "IS NORMALISED"));
}

#[test]
fn other_tokens_files_and_engines_are_expanded() {
    let folder = Folder::new("other");
    let first = folder.expanded("1", "gravity");
    assert_ne!(folder.expanded("1", "mass_matrix"), first);
    let heavier = ROD.replace(r#"value="2""#, r#"value="3""#);
    fs::write(folder.0.join("rod.urdf"), heavier).expect("a file");
    assert_ne!(folder.expanded("1", "gravity"), first);
    fs::write(folder.0.join("rod.urdf"), ROD).expect("a file");
    assert_eq!(folder.files().len(), 3);
    assert_eq!(folder.expanded("2", "gravity"), first);
    assert_eq!(folder.files().len(), 4);
}

#[test]
fn a_file_that_is_cut_short_is_replaced() {
    let folder = Folder::new("cut");
    let whole = folder.expanded("1", "gravity");
    let file = &folder.files()[0];
    let text = fs::read_to_string(file).expect("kept");
    for length in [0, 10, text.len() / 2, text.len() - 1] {
        fs::write(file, &text[..length]).expect("written");
        assert_eq!(folder.expanded("1", "gravity"), whole);
        assert_eq!(fs::read_to_string(file).expect("kept"), text);
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_no_mistake() {
    let folder = Folder::new("file");
    let without = derive(folder.tokens("gravity"), None).to_string();
    fs::write(folder.expansions(), "in its place").expect("written");
    assert_eq!(folder.expanded("1", "gravity"), without);
}

#[test]
fn tokens_in_groups_without_delimiters_are_not_kept() {
    let folder = Folder::new("groups");
    let path = folder.expansions();
    let kept = Kept {
        folder: &path,
        engine: "1",
        parse: |text| text.parse().ok(),
    };
    let name = proc_macro2::Group::new(proc_macro2::Delimiter::None, quote!(Rod));
    let inside = quote! { [#name] };
    assert!(kept.entry("derive", &quote!([Rod])).is_some());
    assert!(kept.entry("derive", &inside).is_none());
}

#[test]
fn the_oldest_expansions_beyond_the_most_bytes_are_removed() {
    let file = |age: u64, length: u64| {
        let modified = SystemTime::UNIX_EPOCH + Duration::from_secs(1000 - age);
        (modified, length, PathBuf::from(age.to_string()))
    };
    let removed = |files: &[(u64, u64)]| -> Vec<PathBuf> {
        let files = files.iter().map(|&(age, length)| file(age, length));
        surplus(files.collect()).collect()
    };
    assert!(removed(&[(2, MOST / 2), (1, MOST / 2)]).is_empty());
    let beyond = removed(&[(3, 1), (1, MOST / 2), (2, MOST / 2)]);
    assert_eq!(beyond, [PathBuf::from("3")]);
    assert_eq!(removed(&[(1, 2 * MOST), (2, 1)]), [PathBuf::from("2")]);
}
