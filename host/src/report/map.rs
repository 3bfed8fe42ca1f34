//! Pictures of results over a plane as SVG: colour maps with axes and a colour bar.
//!
//! Written as text, not with the drawing library of [`figure`](super::figure): the cells are a picture
//! in the picture, a byte each.

use std::fmt::Write;
use std::ops::Range;

use super::figure::{FigureError, range, tick};
use super::png::Indexed;
use crate::io::escaped;

pub use super::raster::Raster;

/// One quantity over x and y.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// The quantity, with its unit.
    pub heading: String,
    /// Values row by row from below, x running fastest; those not finite stay empty.
    pub cells: Vec<f64>,
    /// Cells in x.
    pub nx: usize,
    /// Cells in y.
    pub ny: usize,
    /// Lower corner.
    pub lower: [f64; 2],
    /// Upper corner.
    pub upper: [f64; 2],
}

pub(super) const MOST_MAPS: usize = 4;

/// Cells that are drawn along a side, at the most: a picture of four maps stays below 200 kB.
const MOST_CELLS: usize = 160;

/// Colours: so many that the eye sees no steps, so few that neighbours often share one.
const COLOURS: usize = 64;

/// Viridis at even distances, as red, green and blue: of even steps to the eye, also to the
/// colour-blind and in print (van der Walt & Smith 2015).
const VIRIDIS: [u32; 16] = [
    0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e, //
    0x1f988b, 0x22a884, 0x35b779, 0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725,
];

// All lengths in pixels.
const HEAD: f64 = 62.0;
/// The largest side of a map: 64, 96 or 128 cells are whole pixels.
const SIDE: f64 = 384.0;
const MARGIN: Margin = Margin {
    left: 64.0,
    right: 92.0,
    above: 30.0,
    below: 40.0,
};
/// The colour bar: distance from the map, width, and least height.
const BAR: (f64, f64, f64) = (16.0, 14.0, 100.0);
/// From one tick to the next, at least.
const TICK_SPACING: f64 = 48.0;

const INK: &str = "#333333";
const EMPTY: &str = "#ececec";

struct Margin {
    left: f64,
    right: f64,
    above: f64,
    below: f64,
}

/// A rectangle on the page.
#[derive(Clone, Copy)]
struct Frame {
    x: f64,
    y: f64,
    width: f64,
    height: f64,
}

/// Draws 1 to 4 maps, two beside each other, lengths in x and y to the same scale; each has the
/// colours of viridis from its least to its largest value. A second line of the title is smaller.
/// Returns the picture as SVG text.
///
/// # Errors
/// Another number of maps; a map with other cells than `nx * ny`, or without extent.
pub fn maps(title: &str, maps: &[Map]) -> Result<String, FigureError> {
    let count = maps.len();
    if !(1..=MOST_MAPS).contains(&count) {
        return Err(FigureError::MapCount { count });
    }
    maps.iter().try_for_each(check)?;
    let maps: Vec<Map> = maps.iter().map(coarsened).collect();

    let columns = count.min(2);
    let column_width = MARGIN.left + SIDE + MARGIN.right;
    let mut body = String::new();
    let mut y = HEAD;
    for row in maps.chunks(columns) {
        let height = row.iter().map(|map| size(map).1).fold(BAR.2, f64::max);
        for (column, map) in row.iter().enumerate() {
            let (width, own) = size(map);
            let frame = Frame {
                x: column as f64 * column_width + MARGIN.left + (SIDE - width) / 2.0,
                y: y + MARGIN.above + (height - own) / 2.0,
                width,
                height: own,
            };
            draw(&mut body, map, frame);
        }
        y += MARGIN.above + height + MARGIN.below;
    }
    let (width, height) = (columns as f64 * column_width, y);
    let mut text = format!(
        "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" \
         xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" fill=\"{INK}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        px(width),
        px(height)
    );
    let (first, second) = title.split_once('\n').unwrap_or((title, ""));
    label(&mut text, (18.0, 24.0), (18, "start"), first);
    label(&mut text, (18.0, 45.0), (12, "start"), second);
    Ok(text + &body + "</svg>\n")
}

fn check(map: &Map) -> Result<(), FigureError> {
    let Map { nx, ny, .. } = *map;
    if map.cells.is_empty() || nx.checked_mul(ny) != Some(map.cells.len()) {
        return Err(FigureError::CellCount {
            heading: map.heading.clone(),
            cells: map.cells.len(),
            nx,
            ny,
        });
    }
    let span = |d: usize| map.upper[d] - map.lower[d];
    if !(0..2).all(|d| span(d) > 0.0 && span(d).is_finite()) {
        return Err(FigureError::Bounds {
            heading: map.heading.clone(),
            lower: map.lower,
            upper: map.upper,
        });
    }
    Ok(())
}

/// The map in no more cells than are drawn, each the mean of those that it stands for.
fn coarsened(map: &Map) -> Map {
    let (nx, ny) = (map.nx.min(MOST_CELLS), map.ny.min(MOST_CELLS));
    let part = |i: usize, n: usize, all: usize| i * all / n..(i + 1) * all / n;
    let mean = |cell: usize| {
        let (mut sum, mut count) = (0.0, 0.0);
        for j in part(cell / nx, ny, map.ny) {
            for value in &map.cells[j * map.nx..][part(cell % nx, nx, map.nx)] {
                if value.is_finite() {
                    (sum, count) = (sum + value, count + 1.0);
                }
            }
        }
        sum / count
    };
    Map {
        heading: map.heading.clone(),
        cells: (0..nx * ny).map(mean).collect(),
        nx,
        ny,
        ..*map
    }
}

/// Width and height of a map.
fn size(map: &Map) -> (f64, f64) {
    let [x, y] = [0, 1].map(|d| map.upper[d] - map.lower[d]);
    let longer = x.max(y);
    (SIDE * (x / longer), SIDE * (y / longer))
}

/// The cells, their frame with ticks, and the colour bar.
fn draw(text: &mut String, map: &Map, frame: Frame) {
    let finite = map.cells.iter().copied().filter(|value| value.is_finite());
    let values = range(finite, 0.0);
    let Frame {
        x,
        y,
        width,
        height,
    } = frame;
    let middle = (x + width / 2.0, y - 14.0);
    label(text, middle, (14, "middle"), &map.heading);
    let _ = writeln!(text, "<rect {} fill=\"{EMPTY}\"/>", place(frame));
    paint(text, frame, (map.nx, map.ny), |cell| {
        level(map.cells[cell], &values)
    });
    outline(text, frame);

    for value in ticks(map.lower[0]..map.upper[0], width) {
        let part = (value - map.lower[0]) / (map.upper[0] - map.lower[0]);
        let (x, bottom) = (x + part * width, y + height);
        stroke(text, (x, bottom), (0.0, 4.0));
        let words = tick(value, &(map.lower[0]..map.upper[0]));
        label(text, (x, bottom + 13.0), (12, "middle"), &words);
    }
    for value in ticks(map.lower[1]..map.upper[1], height) {
        let part = (value - map.lower[1]) / (map.upper[1] - map.lower[1]);
        let y = y + height - part * height;
        stroke(text, (x, y), (-4.0, 0.0));
        let words = tick(value, &(map.lower[1]..map.upper[1]));
        label(text, (x - 8.0, y), (12, "end"), &words);
    }
    draw_bar(text, frame, &values);
}

/// The colours and what they stand for, right of a map.
fn draw_bar(text: &mut String, map: Frame, values: &Range<f64>) {
    let height = map.height.max(BAR.2);
    let bar = Frame {
        x: map.x + map.width + BAR.0,
        y: map.y + (map.height - height) / 2.0,
        width: BAR.1,
        height,
    };
    paint(text, bar, (1, COLOURS), Some);
    outline(text, bar);
    for value in ticks(values.clone(), height) {
        let part = (value - values.start) / (values.end - values.start);
        let (x, y) = (bar.x + bar.width, bar.y + height - part * height);
        stroke(text, (x, y), (4.0, 0.0));
        label(text, (x + 8.0, y), (12, "start"), &tick(value, values));
    }
}

/// Fills a frame with cells, row by row from below.
fn paint(
    text: &mut String,
    frame: Frame,
    (nx, ny): (usize, usize),
    level: impl Fn(usize) -> Option<usize>,
) {
    let colours: Vec<u32> = (0..COLOURS).map(viridis).collect();
    let rows = (0..ny).rev().flat_map(|j| (0..nx).map(move |i| j * nx + i));
    let pixels = rows.map(|cell| level(cell).unwrap_or(COLOURS) as u8);
    let picture = Indexed {
        width: nx,
        height: ny,
        pixels: &pixels.collect::<Vec<u8>>(),
        colours: &colours,
    };
    let _ = writeln!(
        text,
        "<image {} preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" href=\"{}\"/>",
        place(frame),
        picture.link()
    );
}

/// The colour of a value, 0 to 63; none for what is not finite.
fn level(value: f64, values: &Range<f64>) -> Option<usize> {
    let part = (value - values.start) / (values.end - values.start);
    let level = (part * COLOURS as f64) as usize;
    value.is_finite().then_some(level.min(COLOURS - 1))
}

/// The colour of a level, between the two next to it in the table.
fn viridis(level: usize) -> u32 {
    let intervals = VIRIDIS.len() - 1;
    let place = level * intervals;
    let (first, part) = (place / (COLOURS - 1), place % (COLOURS - 1));
    let (lower, upper) = (VIRIDIS[first], VIRIDIS[(first + 1).min(intervals)]);
    let (near, far) = ((COLOURS - 1 - part) as u32, part as u32);
    let mixed = |shift: u32| {
        let [lower, upper] = [lower, upper].map(|colour| (colour >> shift) & 0xff);
        ((lower * near + upper * far) / (near + far)) << shift
    };
    mixed(16) | mixed(8) | mixed(0)
}

/// Multiples of 1, 2 or 5 times a power of ten within a range, as many as fit a length.
fn ticks(range: Range<f64>, length: f64) -> impl Iterator<Item = f64> {
    // At most 6 intervals: for those `tick` has the digits. Two ticks to read a scale from.
    let most = (length / TICK_SPACING).floor().clamp(2.0, 6.0);
    let least = (range.end - range.start) / most;
    let power = 10.0_f64.powf(least.log10().floor());
    let multiple = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let step = multiple.into_iter().find(|step| *step >= least * 0.999_999);
    let step = step.unwrap_or(least);
    // An extreme that misses a round number by less than a pixel still shows it.
    let slack = 0.002 * (range.end - range.start) / step;
    let first = (range.start / step - slack).ceil() as i64;
    let last = (range.end / step + slack).floor() as i64;
    (first..=last).map(move |k| k as f64 * step)
}

fn label(text: &mut String, (x, y): (f64, f64), (size, anchor): (u32, &str), words: &str) {
    // A third of the size below: centred, in every renderer.
    let (x, y) = (px(x), px(y + 0.35 * f64::from(size)));
    let words = escaped(words);
    let _ = writeln!(
        text,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\">{words}</text>"
    );
}

fn stroke(text: &mut String, (x, y): (f64, f64), (dx, dy): (f64, f64)) {
    let (x, y) = (px(x), px(y));
    let _ = writeln!(text, "<path d=\"M{x} {y}l{dx} {dy}\" stroke=\"{INK}\"/>");
}

fn outline(text: &mut String, frame: Frame) {
    let place = place(frame);
    let _ = writeln!(text, "<rect {place} fill=\"none\" stroke=\"{INK}\"/>");
}

fn place(frame: Frame) -> String {
    let [x, y, width, height] = [frame.x, frame.y, frame.width, frame.height].map(px);
    format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"")
}

/// Hundredths of a pixel.
fn px(value: f64) -> String {
    ((100.0 * value).round() / 100.0).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A map of the values of a function of the cell.
    fn map((nx, ny): (usize, usize), value: impl Fn(usize) -> f64) -> Map {
        Map {
            heading: "density".to_owned(),
            cells: (0..nx * ny).map(value).collect(),
            nx,
            ny,
            lower: [0.0, 0.0],
            upper: [nx as f64, ny as f64],
        }
    }

    /// Values in 0..1 without order.
    fn noise(cell: usize) -> f64 {
        (cell as f64 * 0.618_033_988_749_895).fract()
    }

    /// The colour of every cell of the first map of a picture, in a file read back.
    fn read_back(text: &str, nx: usize, ny: usize) -> Vec<Option<String>> {
        let link = text.split("base64,").nth(1).unwrap();
        let value = |letter: u8| match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' => 62,
            _ => 63,
        };
        let letters = link
            .bytes()
            .take_while(|&letter| letter != b'"' && letter != b'=');
        let bits: Vec<u8> = letters.map(value).collect();
        let bytes: Vec<u8> = (bits.chunks(4))
            .flat_map(|four| {
                let all = (0..4).fold(0u32, |all, i| {
                    all << 6 | u32::from(*four.get(i).unwrap_or(&0))
                });
                let count = four.len() - 1;
                all.to_be_bytes()[1..=count].to_vec()
            })
            .collect();
        let chunk = |kind: &[u8]| {
            let at = bytes.windows(4).position(|four| four == kind).unwrap();
            let length = u32::from_be_bytes(bytes[at - 4..at].try_into().unwrap());
            &bytes[at + 4..at + 4 + length as usize]
        };
        let (palette, data) = (chunk(b"PLTE"), chunk(b"IDAT"));
        // One stored block behind two bytes of zlib and five of its own.
        let rows = &data[7..7 + (nx + 1) * ny];
        let cell = |cell: usize| {
            let row = ny - 1 - cell / nx;
            let number = usize::from(rows[row * (nx + 1) + 1 + cell % nx]);
            let colour = &palette[3 * number..3 * number + 3];
            let [r, g, b] = [colour[0], colour[1], colour[2]];
            (number < COLOURS).then(|| format!("#{r:02x}{g:02x}{b:02x}"))
        };
        (0..nx * ny).map(cell).collect()
    }

    #[test]
    fn every_cell_is_painted_in_its_colour_and_empty_ones_are_not() {
        let value = |cell: usize| match cell % 7 {
            3 => f64::NAN,
            5 => f64::INFINITY,
            _ => (cell / 9) as f64,
        };
        let map = map((31, 17), value);
        let text = maps("title", std::slice::from_ref(&map)).unwrap();
        let painted = read_back(&text, 31, 17);
        let mut seen = std::collections::BTreeMap::<usize, String>::new();
        for (cell, colour) in painted.into_iter().enumerate() {
            // The largest value that is not empty is (31 * 17 - 1) / 9.
            let level = level(map.cells[cell], &(0.0..58.0));
            assert_eq!(colour.is_some(), map.cells[cell].is_finite());
            if let (Some(level), Some(colour)) = (level, colour) {
                assert_eq!(seen.entry(level).or_insert(colour.clone()), &colour);
            }
        }
        assert!(seen.len() > 50, "{} colours", seen.len());
        assert_eq!((&*seen[&0], &*seen[&63]), ("#440154", "#fde725"));
        let colours: std::collections::BTreeSet<&String> = seen.values().collect();
        assert_eq!(colours.len(), seen.len(), "each level has its own colour");
    }

    #[test]
    fn a_picture_stays_small_where_no_two_neighbours_agree() {
        let map = map((128, 128), noise);
        let one = maps("t", std::slice::from_ref(&map)).unwrap().len();
        let four = maps("t", &vec![map.clone(); 4]).unwrap().len();
        assert!(one < 40_000 && four < 130_000, "{one}, {four} bytes");
        // The probe may have more cells than a picture shows.
        let fine = super::tests::map((1000, 300), noise);
        let four = maps("t", &vec![fine; 4]).unwrap().len();
        assert!(four < 200_000, "{four} bytes");
    }

    #[test]
    fn what_is_too_fine_is_drawn_by_its_means() {
        let fine = map((3 * MOST_CELLS, 2), |cell| [1.0, 2.0, 6.0][cell % 3]);
        let coarse = coarsened(&fine);
        assert_eq!((coarse.nx, coarse.ny), (MOST_CELLS, 2));
        assert!(coarse.cells.iter().all(|value| *value == 3.0));
        assert_eq!(coarse.upper, fine.upper);
    }

    #[test]
    fn lengths_in_x_and_y_have_one_scale() {
        for upper in [[3.0, 1.0], [1.0, 4.0], [2.0, 2.0], [1e-3, 5e-4]] {
            let map = Map {
                upper,
                ..map((12, 7), noise)
            };
            let text = maps("title", &[map]).unwrap();
            let image = text.split("<image ").nth(1).unwrap();
            let side = |name: &str| -> f64 {
                let side = image.split(&format!("{name}=\"")).nth(1).unwrap();
                side.split('"').next().unwrap().parse().unwrap()
            };
            let (x, y) = (side("width") / upper[0], side("height") / upper[1]);
            // Hundredths of a pixel.
            assert!((x / y - 1.0).abs() < 1e-3, "{x} and {y} pixels a length");
        }
    }

    #[test]
    fn empty_and_constant_maps_are_drawn_and_words_are_escaped() {
        let constant = |value: f64| map((4, 3), move |_| value);
        let named = Map {
            heading: "a < b & c".to_owned(),
            ..constant(1e-300)
        };
        let all = [constant(f64::NAN), constant(0.0), constant(-3.0), named];
        let text = maps("x > 0", &all).unwrap();
        assert!(text.starts_with("<svg") && text.ends_with("</svg>\n"));
        assert!(text.contains(">a &lt; b &amp; c<") && text.contains(">x &gt; 0<"));
        assert!(!text.contains("NaN") && !text.contains("inf"));
        assert!(read_back(&text, 4, 3).iter().all(Option::is_none));
    }

    #[test]
    fn what_is_no_map_is_refused() {
        let good = map((4, 3), noise);
        for count in [0, 5] {
            let error = maps("t", &vec![good.clone(); count]).unwrap_err();
            assert!(error.to_string().starts_with(&format!("{count} maps")));
        }
        let refusal = |map: Map| maps("t", &[map]).unwrap_err().to_string();
        let ny = 4;
        let text = refusal(Map { ny, ..good.clone() });
        assert_eq!(text, "the map \"density\" has 12 cells for 4 x 4");
        assert!(refusal(map((0, 0), noise)).contains("0 cells"));
        for upper in [
            [0.0, 1.0],
            [1.0, -1.0],
            [f64::NAN, 1.0],
            [f64::INFINITY, 1.0],
        ] {
            let map = Map {
                upper,
                ..good.clone()
            };
            assert!(refusal(map).contains("need lower < upper"));
        }
    }

    #[test]
    fn ticks_are_round_numbers_within_the_range() {
        for (range, length, expected) in [
            (0.0..1.0, 320.0, vec![0.0, 0.2, 0.4, 0.6, 0.8, 1.0]),
            (-0.5..0.5, 160.0, vec![-0.5, 0.0, 0.5]),
            (0.9..1.07, 320.0, vec![0.9, 0.95, 1.0, 1.05]),
            (0.0..3e5, 60.0, vec![0.0, 2e5]),
            (1.000_1..1.999_9, 160.0, vec![1.0, 1.5, 2.0]),
        ] {
            let found: Vec<f64> = ticks(range.clone(), length).collect();
            assert_eq!(found.len(), expected.len(), "{found:?} in {range:?}");
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-12);
            }
        }
    }
}
