//! The pages of the repository and of the crate's documentation: their links and pictures lead
//! somewhere in both.
//!
//! It compares; with `BRDF_REGENERATE=1` in the environment it writes the embedded pictures anew.

use std::fs;
use std::path::{Path, PathBuf};

const LINKS: &str = include_str!("../src/guide/links.md");
const GUIDE: &str = include_str!("../src/guide/mod.rs");
/// What the documentation contains as data, and its media type.
const PICTURES: [(&str, &str); 4] = [
    ("gallery.jpg", "image/jpeg"),
    ("history.jpg", "image/jpeg"),
    ("history-lobes.svg", "image/svg+xml"),
    ("measured-fits.svg", "image/svg+xml"),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The pages of the folder `docs`, without the ending of their names.
fn stems() -> Vec<String> {
    let entries = fs::read_dir(root().join("docs")).expect("a folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name().into_string());
    let names = names.map(|name| name.expect("a name in Unicode"));
    names.filter_map(|name| name.strip_suffix(".md").map(String::from)).collect()
}

/// The front page and those of the folder `docs`, with their text.
fn pages() -> Vec<(PathBuf, String)> {
    let docs = stems().into_iter().map(|stem| root().join(format!("docs/{stem}.md")));
    let paths = docs.chain([root().join("README.md")]);
    paths.map(|path| (path.clone(), fs::read_to_string(path).expect("a page"))).collect()
}

/// Labels and what they stand for: `[label]: target`.
fn definitions(text: &str) -> Vec<(&str, &str)> {
    let lines = text.lines().filter_map(|line| line.strip_prefix('[')?.split_once("]: "));
    lines.collect()
}

/// The labels in links and pictures: `[words][label]`.
fn uses(text: &str) -> Vec<&str> {
    let starts = text.match_indices("][").map(|(at, mark)| &text[at + mark.len()..]);
    starts.filter_map(|rest| Some(rest.split_once(']')?.0)).collect()
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let bits = (0..3).fold(0, |bits, i| bits << 8 | usize::from(*chunk.get(i).unwrap_or(&0)));
        for i in 0..4 {
            let digit = char::from(DIGITS[bits >> (18 - 6 * i) & 63]);
            text.push(if i <= chunk.len() { digit } else { '=' });
        }
    }
    text
}

#[test]
fn the_embedded_pictures_are_those_of_the_pages() {
    let lines = PICTURES.map(|(name, media)| {
        let bytes = fs::read(root().join("docs").join(name)).expect("a picture");
        format!("[{name}]: data:{media};base64,{}\n", base64(&bytes))
    });
    let path = root().join("src/guide/pictures.md");
    if std::env::var_os("BRDF_REGENERATE").is_some() {
        fs::write(&path, lines.concat()).expect("it can be written");
    } else {
        let text = fs::read_to_string(&path).expect("it is in the repository");
        assert!(text == lines.concat(), "out of date: run this test with BRDF_REGENERATE=1");
    }
}

/// In the repository a label leads to a file, in the documentation to a module or to data.
#[test]
fn labels_lead_somewhere_in_both() {
    let mut seen = 0;
    for (path, text) in pages() {
        for (label, target) in definitions(&text) {
            let at = format!("{}: {label}", path.display());
            let file = path.with_file_name(target);
            assert!(file.is_file(), "{at}");
            assert!(uses(&text).contains(&label), "{at} is never used");
            let name = file.file_name().and_then(|name| name.to_str()).expect(&at);
            match name.strip_suffix(".md") {
                Some(stem) => assert_eq!(label, stem, "{at}"),
                None => {
                    assert_eq!(label, name, "{at}");
                    assert!(PICTURES.iter().any(|picture| picture.0 == name), "{at}");
                }
            }
            seen += 1;
        }
        let defined = |used: &&str| definitions(&text).iter().any(|(label, _)| label == used);
        let unknown = uses(&text).into_iter().find(|used| !defined(used));
        assert_eq!(unknown, None, "{}", path.display());
    }
    assert!(seen > 10, "{seen}");
}

/// A relative link without a label would be dead in the documentation.
#[test]
fn inline_links_are_absolute() {
    for (path, text) in pages() {
        for (_, rest) in text.match_indices("](").map(|(at, _)| text.split_at(at + 2)) {
            let target = rest.split(')').next().unwrap_or_default();
            assert!(target.starts_with("https://"), "{}: {target}", path.display());
        }
    }
}

#[test]
fn every_page_is_a_module_of_the_guide() {
    let labels = definitions(LINKS);
    let stems = stems();
    assert_eq!(labels.len(), stems.len());
    for stem in stems {
        let module = stem.replace('-', "_");
        let target = format!("crate::guide::{module}");
        assert!(labels.contains(&(stem.as_str(), target.as_str())), "{stem}");
        assert!(GUIDE.contains(&format!("/docs/{stem}.md\")]\npub mod {module} {{}}")), "{stem}");
    }
}

#[test]
fn the_front_page_stays_short() {
    assert!(include_str!("../README.md").lines().count() <= 150);
}
