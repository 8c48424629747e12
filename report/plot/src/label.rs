//! Words beside points.
//!
//! In: points with their labels, the symbols that are drawn, and the area to stay in. Out: SVG, each
//! label where it covers neither a symbol nor a label before it, as far as there is such a place.

use super::symbol::text;

const SIZE: f64 = 11.0;
/// From a point to its label, in pixels.
const AWAY: f64 = 8.0;

/// Left, top, right, bottom.
type Box = [f64; 4];

/// Draws the labels.
pub(super) fn draw(svg: &mut String, points: &[([f64; 2], &str)], symbols: &[[f64; 2]], area: Box) {
    let around = |[x, y]: &[f64; 2]| [x - 5.0, y - 5.0, x + 5.0, y + 5.0];
    let mut taken: Vec<Box> = symbols.iter().map(around).collect();
    for ([x, y], label) in points {
        // Letters of 11 px are at most 6.2 px wide on average.
        let letters = u32::try_from(label.chars().count()).unwrap_or(0);
        let width = 6.2 * f64::from(letters);
        let (right, left, middle) = (x + AWAY, x - AWAY - width, x - 0.5 * width);
        let places = [
            [right, 0.0],
            [left, 0.0],
            [middle, -12.0],
            [middle, 13.0],
            [right, -9.0],
            [left, -9.0],
            [right, 9.0],
            [left, 9.0],
            [right, -15.0],
            [right, 15.0],
            [middle, -25.0],
            [middle, 26.0],
            [right, -28.0],
            [right, 28.0],
            [left, -28.0],
            [left, 28.0],
            [middle, -38.0],
            [middle, 39.0],
        ];
        let places =
            places.map(|[start, down]| [start, y + down - 6.0, start + width, y + down + 6.0]);
        let free = |place: &Box| {
            place[0] > area[0]
                && place[1] > area[1]
                && place[2] < area[2]
                && place[3] < area[3]
                && taken.iter().all(|other| apart(place, other))
        };
        let place = places.into_iter().find(free).unwrap_or(places[0]);
        let (anchor, start) = if place[0] > *x {
            ("start", place[0])
        } else if place[2] < *x {
            ("end", place[2])
        } else {
            ("middle", *x)
        };
        let size = format!("font-size=\"{SIZE}\"");
        text(svg, [start, place[1] + 10.0], anchor, &size, label);
        taken.push(place);
    }
}

fn apart(a: &Box, b: &Box) -> bool {
    a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1]
}

#[cfg(test)]
mod tests {
    use super::draw;

    #[test]
    fn labels_of_points_in_one_place_stand_one_above_the_other() {
        let mut svg = String::new();
        let labels = ["first", "second", "third", "fourth", "fifth", "sixth"];
        let points = labels.map(|label| ([100.0, 50.0], label));
        draw(
            &mut svg,
            &points,
            &[[100.0, 50.0]],
            [0.0, 0.0, 200.0, 100.0],
        );
        let mut places: Vec<&str> = svg.split("<text").skip(1).collect();
        for place in &mut places {
            *place = place.split_once("font-size").expect("it has one").0;
        }
        let count = places.len();
        places.sort_unstable();
        places.dedup();
        assert_eq!((places.len(), count), (labels.len(), labels.len()), "{svg}");
    }

    #[test]
    fn a_label_keeps_away_from_symbols_and_from_the_edge() {
        let mut svg = String::new();
        let points = [([100.0, 50.0], "first"), ([195.0, 50.0], "second")];
        let symbols = [[100.0, 50.0], [115.0, 50.0], [195.0, 50.0]];
        draw(&mut svg, &points, &symbols, [0.0, 0.0, 200.0, 100.0]);
        let anchors: Vec<&str> = svg.split("text-anchor=").skip(1).collect();
        assert!(
            anchors.iter().all(|rest| rest.starts_with("\"end\"")),
            "{svg}"
        );
    }
}
