//! Random damage to a text.
//!
//! In: a text, a random source. Out: bytes: the text after one to twelve changes of its values, blocks or characters,
//! sometimes in another encoding. [`splinters`](super::splinters) has the words that it inserts.

use std::ops::Range;

use super::Language;
use super::splinters::{BORNE, INLINE, MJCF, NUMBERS, SDF, TABLE, URDF, VECTORS, WORDS, XACRO};
use super::texts::{blocks, values};
use crate::states::Random;

/// Length beyond which a text does not grow.
const LONGEST: usize = 4 << 20;

/// The bytes of the text after some changes.
pub(super) fn damage(language: Language, mut text: String, random: &mut Random) -> Vec<u8> {
    let changes = *random.choose(&[1, 1, 1, 1, 1, 2, 2, 3, 4, 12]);
    for _ in 0..changes {
        if text.len() < LONGEST {
            change(language, &mut text, random);
        }
    }
    if random.chance(16) {
        encoded(&text, random)
    } else {
        text.into_bytes()
    }
}

fn pick(ranges: &[Range<usize>], random: &mut Random) -> Range<usize> {
    if ranges.is_empty() {
        return 0..0;
    }
    random.choose(ranges).clone()
}

fn change(language: Language, text: &mut String, random: &mut Random) {
    match random.below(20) {
        0..7 => {
            let at = pick(&values(language, text), random);
            let new = value(&text[at.clone()], random);
            text.replace_range(at, &new);
        }
        7..9 => {
            let all = values(language, text);
            let (to, from) = (pick(&all, random), pick(&all, random));
            let copied = text[from].to_owned();
            text.replace_range(to, &copied);
        }
        9 => swap(text, &values(language, text), random),
        10 => text.replace_range(pick(&blocks(language, text), random), ""),
        11..13 => {
            let all = blocks(language, text);
            let (from, to) = (pick(&all, random), pick(&all, random));
            let copied = text[from].to_owned();
            text.insert_str(to.end, &copied);
        }
        13 => swap(text, &blocks(language, text), random),
        14 => {
            let between = match language {
                Language::Urdf => random.choose(&URDF),
                Language::Xacro => random.choose(&XACRO),
                Language::Mjcf => random.choose(&MJCF),
                Language::Sdf => random.choose(&SDF),
                Language::Table => random.choose(&TABLE),
                Language::Inline => random.choose(&INLINE),
            };
            text.insert_str(pick(&blocks(language, text), random).end, between);
        }
        15 => wrap(language, text, random),
        16 => shuffle_lines(text, random),
        _ => one_character(text, random),
    }
}

/// A replacement for a value; a number is replaced by another number more often than not.
fn value(old: &str, random: &mut Random) -> String {
    let words: Vec<&str> = old.split(' ').collect();
    if words.iter().all(|word| word.parse::<f64>().is_ok()) && !random.chance(3) {
        return exchanged(&words, random.choose::<&str>(&BORNE), random);
    }
    let many = [1, 30, 400, 10_000][random.below(4)];
    match random.below(12) {
        0..4 => (*random.choose(&NUMBERS)).to_owned(),
        4 => (*random.choose(&VECTORS)).to_owned(),
        5..7 => (*random.choose(&WORDS)).to_owned(),
        7 | 8 => exchanged(&words, random.choose::<&str>(&NUMBERS), random),
        9 => format!("-{old}"),
        10 => format!(
            "{old}{}",
            random.choose(&["9", "e9", "e-9", "0", " ", "\n", ".", "/3", "\u{e9}"])
        ),
        _ => random
            .choose(&["7", "0.1234567", "n", "\u{1d11e}", " 1", "9."])
            .repeat(many),
    }
}

/// The words, with a random one replaced.
fn exchanged(words: &[&str], other: &str, random: &mut Random) -> String {
    let changed = random.below(words.len());
    let words = words.iter().enumerate();
    let words = words.map(|(k, word)| if k == changed { other } else { word });
    words.collect::<Vec<_>>().join(" ")
}

fn swap(text: &mut String, ranges: &[Range<usize>], random: &mut Random) {
    let (a, b) = (pick(ranges, random), pick(ranges, random));
    let (a, b) = if a.start < b.start { (a, b) } else { (b, a) };
    if a.end <= b.start {
        let (first, second) = (text[a.clone()].to_owned(), text[b.clone()].to_owned());
        text.replace_range(b, &first);
        text.replace_range(a, &second);
    }
}

/// Nests a block inside many others.
fn wrap(language: Language, text: &mut String, random: &mut Random) {
    let depth = [1, 10, 100, 5000][random.below(4)];
    let at = pick(&blocks(language, text), random);
    let (open, close) = match language {
        Language::Urdf => ("<a>", "</a>"),
        Language::Xacro => *random.choose(&[
            ("<a>", "</a>"),
            ("<xacro:if value=\"1\">", "</xacro:if>"),
            ("${(", ")}"),
        ]),
        Language::Mjcf => *random.choose(&[
            ("<frame pos=\"0.1 0 0\">", "</frame>"),
            ("<body>", "</body>"),
            ("<replicate count=\"2\">", "</replicate>"),
        ]),
        Language::Sdf => *random.choose(&[
            ("<model name=\"m\">", "</model>"),
            ("<frame name=\"f\">", "</frame>"),
        ]),
        Language::Table => ("# ", "\n"),
        Language::Inline => *random.choose(&[("(", ")"), ("[", "]"), ("{", "}")]),
    };
    text.insert_str(at.end, &close.repeat(depth));
    text.insert_str(at.start, &open.repeat(depth));
}

fn shuffle_lines(text: &mut String, random: &mut Random) {
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    for k in (1..lines.len()).rev() {
        lines.swap(k, random.below(k + 1));
    }
    *text = lines.concat();
}

fn one_character(text: &mut String, random: &mut Random) {
    let mut at = random.below(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    match random.below(4) {
        0 => text.truncate(at),
        1 => drop((at < text.len()).then(|| text.remove(at))),
        2 => {
            let letters = "<>\"'=&;/ \n\t#-.e09[](){},:\u{0}\u{7f}\u{e9}\u{202e}\u{1f916}";
            let letters: Vec<char> = letters.chars().collect();
            text.insert(at, *random.choose(&letters));
        }
        _ => {
            let mut end = (at + 1 + random.below(40)).min(text.len());
            while !text.is_char_boundary(end) {
                end += 1;
            }
            text.replace_range(at..end, "");
        }
    }
}

/// The text in another encoding, or with bytes that are not UTF-8.
fn encoded(text: &str, random: &mut Random) -> Vec<u8> {
    let wide = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<_>>();
    match random.below(8) {
        0 => [&[0xef, 0xbb, 0xbf], text.as_bytes()].concat(),
        1 => [vec![0xff, 0xfe], wide(u16::to_le_bytes)].concat(),
        2 => [vec![0xfe, 0xff], wide(u16::to_be_bytes)].concat(),
        3 => wide(u16::to_le_bytes),
        4 => text.replace('\n', "\r\n").into_bytes(),
        5 => text.replace('\n', "\r").into_bytes(),
        // Latin-1.
        6 => text
            .chars()
            .map(|c| u8::try_from(u32::from(c)).unwrap_or(0xe9))
            .collect(),
        _ => {
            let mut bytes = text.as_bytes().to_vec();
            let at = random.below(bytes.len() + 1);
            let odd = *random.choose(&[0x00, 0x1a, 0x80, 0xbf, 0xc0, 0xed, 0xf8, 0xff]);
            bytes.insert(at, odd);
            bytes
        }
    }
}
