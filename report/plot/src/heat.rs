//! A map of numbers: rows by columns, coloured by their power of ten.
//!
//! In: numbers, the labels of rows and columns, and the ends of the scale. Out: one SVG. Light is
//! little and dark is much, in one hue, so that it reads without colours as well; what there is no
//! number for stays white.

use std::fmt::Write as _;

use super::symbol::text;
use super::{WIDTH, card};

/// Numbers in rows and columns.
#[derive(Clone, Debug)]
pub struct Map {
    /// The first line.
    pub title: String,
    /// The quantity of the numbers, with its unit.
    pub unit: String,
    /// The labels of the columns.
    pub columns: Vec<String>,
    /// Label and numbers of each row; `None` where there is none.
    pub rows: Vec<(String, Vec<Option<f64>>)>,
    /// The powers of ten that are lightest and darkest.
    pub scale: [f64; 2],
}

/// The least width of the labels of rows, and that of a letter.
const LABELS: f64 = 190.0;
const LETTER: f64 = 6.8;
const CELL: f64 = 24.0;
const TOP: f64 = 96.0;

/// The text of the SVG.
#[must_use]
pub fn draw(map: &Map) -> String {
    let mut svg = String::new();
    let count = |length: usize| f64::from(u32::try_from(length).unwrap_or(u32::MAX));
    let letters = map.rows.iter().map(|(label, _)| label.chars().count());
    let labels = LABELS.max(32.0 + LETTER * count(letters.max().unwrap_or(0)));
    let width = (WIDTH - labels - 24.0) / count(map.columns.len()).max(1.0);
    let small = "font-size=\"12\"";
    text(&mut svg, [24.0, 52.0], "start", small, &map.unit);
    let mut x = labels;
    for label in &map.columns {
        // Words of a label stand one below the other, the last one at the map.
        let words: Vec<&str> = label.split(' ').collect();
        for (k, word) in words.iter().rev().enumerate() {
            let y = TOP - 6.0 - 14.0 * count(k);
            text(&mut svg, [x + 0.5 * width, y], "middle", small, word);
        }
        x += width;
    }
    let mut y = TOP;
    for (label, numbers) in &map.rows {
        text(&mut svg, [labels - 8.0, y + 16.5], "end", small, label);
        let mut x = labels;
        for number in numbers {
            cell(&mut svg, [x, y, width], *number, map.scale);
            x += width;
        }
        y += CELL;
    }
    card(&map.title, y + 16.0, &svg)
}

fn cell(svg: &mut String, [x, y, width]: [f64; 3], number: Option<f64>, [low, high]: [f64; 2]) {
    let part = number.map_or(0.0, |number| {
        ((number.max(f64::MIN_POSITIVE).log10() - low) / (high - low)).clamp(0.0, 1.0)
    });
    // From white to the blue of the palette, and on to nearly black.
    let mix = |light: f64, middle: f64, dark: f64| {
        if part < 0.5 {
            light + 2.0 * part * (middle - light)
        } else {
            middle + (2.0 * part - 1.0) * (dark - middle)
        }
    };
    let [red, green, blue] = [
        mix(247.0, 60.0, 8.0),
        mix(251.0, 140.0, 29.0),
        mix(255.0, 200.0, 70.0),
    ];
    let _ = writeln!(
        svg,
        "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{:.2}\" height=\"{}\" \
         fill=\"rgb({red:.0},{green:.0},{blue:.0})\"/>",
        width - 1.0,
        CELL - 1.0
    );
    let ink = if part > 0.4 { "#ffffff" } else { super::INK };
    let ink = format!("font-size=\"12\" fill=\"{ink}\"");
    let label = match number {
        None => "–".to_owned(),
        Some(number) if number.is_infinite() => "∞".to_owned(),
        Some(number) if number.is_nan() => "NaN".to_owned(),
        Some(number) if number < 9.95 => format!("{number:.1}"),
        Some(number) if number < 9999.5 => format!("{number:.0}"),
        Some(number) => format!("{number:.0e}"),
    };
    text(svg, [x + 0.5 * width, y + 16.5], "middle", &ink, &label);
}
