//! Lines and columns of offsets in a text, counted in characters from 1.
//!
//! A mark every 64 bytes keeps each look-up fast, even if the file is a single line of megabytes.

use crate::error::Place;

/// Bytes between two marks.
const STRIDE: usize = 64;

/// A part of an expanded text that comes from one place.
pub(super) struct Segment {
    /// Offset of its beginning in the expanded text.
    pub(super) start: usize,
    /// The place that it comes from.
    pub(super) place: Place,
    /// True if its characters are those of the file, one by one in one line.
    pub(super) is_verbatim: bool,
}

/// The parts of an expanded text, in order.
pub(super) type Segments = Vec<Segment>;

/// A text, and the lines and columns of its bytes.
pub(super) struct Positions<'t> {
    text: &'t str,
    /// The places that an expanded text comes from; empty for the text of a file.
    segments: Segments,
    /// The number of an included file; `None` for the first file.
    file: Option<u32>,
    /// Line and column of every byte whose offset is a multiple of [`STRIDE`].
    marks: Vec<(u32, u32)>,
}

impl<'t> Positions<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        let mut marks = Vec::with_capacity(text.len() / STRIDE + 1);
        let mut at = (1, 1);
        for chunk in text.as_bytes().chunks(STRIDE) {
            marks.push(at);
            at = after(at, chunk);
        }
        if text.len().is_multiple_of(STRIDE) {
            marks.push(at);
        }
        Self {
            text,
            segments: Segments::new(),
            file: None,
            marks,
        }
    }

    #[cfg(feature = "formats")]
    /// The places that an expanded text comes from.
    pub(super) fn of_expanded(text: &'t str, segments: Segments) -> Self {
        Self {
            text,
            segments,
            file: None,
            marks: Vec::new(),
        }
    }

    #[cfg(feature = "formats")]
    /// The places of a text that includes others, or is included: of the file with this index, 0 for the first.
    pub(super) fn of_file(text: &'t str, index: usize) -> Self {
        let included = index.checked_sub(1);
        Self {
            file: included.map(|file| u32::try_from(file).unwrap_or(u32::MAX)),
            ..Self::new(text)
        }
    }

    /// True if the text was expanded from others.
    pub(super) const fn is_expanded(&self) -> bool {
        self.marks.is_empty()
    }

    /// The text.
    pub(super) const fn text(&self) -> &'t str {
        self.text
    }

    /// The place of the character at an offset; offsets beyond the end give the end.
    pub(super) fn place(&self, offset: usize) -> Place {
        let offset = offset.min(self.text.len());
        if self.is_expanded() {
            return self.origin(offset);
        }
        let mark = offset / STRIDE;
        let passed = &self.text.as_bytes()[mark * STRIDE..offset];
        let (line, column) = after(self.marks[mark], passed);
        self.at(line, column)
    }

    /// The place that a character of an expanded text comes from.
    fn origin(&self, offset: usize) -> Place {
        let after = self.segments.partition_point(|part| part.start <= offset);
        let Some(segment) = after.checked_sub(1).map(|at| &self.segments[at]) else {
            return Place::Unknown;
        };
        if !segment.is_verbatim {
            return segment.place;
        }
        let passed = self.text[segment.start..offset].chars().count();
        segment.place.shifted(u32::try_from(passed).unwrap_or(0))
    }

    /// The place of a line and a column.
    pub(super) const fn at(&self, line: u32, column: u32) -> Place {
        match self.file {
            None => Place::File { line, column },
            Some(file) => Place::Included { file, line, column },
        }
    }
}

/// The position after some more bytes; continuation bytes of a character do not count.
fn after((mut line, mut column): (u32, u32), bytes: &[u8]) -> (u32, u32) {
    for &byte in bytes {
        if byte == b'\n' {
            line += 1;
            column = 1;
        } else if byte & 0b1100_0000 != 0b1000_0000 {
            column += 1;
        }
    }
    (line, column)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, offset: usize) -> (u32, u32) {
        match Positions::new(text).place(offset) {
            Place::File { line, column } => (line, column),
            place => panic!("{place:?}"),
        }
    }

    #[test]
    fn lines_and_characters_are_counted_from_one() {
        assert_eq!(at("", 0), (1, 1));
        assert_eq!(at("ab\ncd", 0), (1, 1));
        assert_eq!(at("ab\ncd", 2), (1, 3));
        assert_eq!(at("ab\ncd", 3), (2, 1));
        assert_eq!(at("αβ\nγδ", 7), (2, 2));
        assert_eq!(at("ab", 99), (1, 3));
    }

    #[test]
    fn marks_agree_with_counting() {
        let text = "αβγ x\n".repeat(300) + &"y".repeat(STRIDE * 3);
        let positions = Positions::new(&text);
        for (offset, _) in text.char_indices() {
            let before = &text[..offset];
            let line = before.matches('\n').count() + 1;
            let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
            let Place::File { line: l, column: c } = positions.place(offset) else {
                panic!("no place");
            };
            assert_eq!((l as usize, c as usize), (line, column), "offset {offset}");
        }
    }
}
