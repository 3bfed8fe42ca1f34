//! Small pictures of few colours as PNG, embedded in SVG.
//!
//! PNG (second edition): W3C recommendation of 10 November 2003, of which this writes one kind: colours
//! by number, 8 bits each, without compression (stored blocks of RFC 1951). A map of 128 x 128 cells
//! is 16 kB.

/// A picture of colours by number, row by row from above.
pub(super) struct Indexed<'a> {
    /// Pixels in x.
    pub width: usize,
    /// Pixels in y.
    pub height: usize,
    /// One number a pixel, below the number of colours; that number itself for a pixel that shows
    /// what lies behind.
    pub pixels: &'a [u8],
    /// Red, green and blue, at most 255 colours.
    pub colours: &'a [u32],
}

impl Indexed<'_> {
    /// The picture as a link that holds it.
    pub fn link(&self) -> String {
        format!("data:image/png;base64,{}", base64(&self.png()))
    }

    fn png(&self) -> Vec<u8> {
        let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
        let side = |n: usize| (n as u32).to_be_bytes();
        let head = [&side(self.width)[..], &side(self.height), &[8, 3, 0, 0, 0]].concat();
        let palette = self.colours.iter().flat_map(|c| [c >> 16, c >> 8, *c]);
        let mut palette: Vec<u8> = palette.map(|part| part as u8).collect();
        palette.extend([0; 3]);
        let mut opacity = vec![255; self.colours.len()];
        opacity.push(0);
        let mut rows = Vec::with_capacity((self.width + 1) * self.height);
        for row in self.pixels.chunks(self.width) {
            // No filter.
            rows.push(0);
            rows.extend(row);
        }
        chunk(&mut file, b"IHDR", &head);
        chunk(&mut file, b"PLTE", &palette);
        chunk(&mut file, b"tRNS", &opacity);
        chunk(&mut file, b"IDAT", &stored(&rows));
        chunk(&mut file, b"IEND", &[]);
        file
    }
}

fn chunk(file: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    file.extend((data.len() as u32).to_be_bytes());
    let start = file.len();
    file.extend(kind);
    file.extend(data);
    let check = crc32(&file[start..]);
    file.extend(check.to_be_bytes());
}

/// A zlib stream of stored blocks.
fn stored(data: &[u8]) -> Vec<u8> {
    let mut stream = vec![0x78, 0x01];
    let blocks = data.chunks(0xffff);
    let last = blocks.len().saturating_sub(1);
    for (i, block) in blocks.enumerate() {
        stream.push(u8::from(i == last));
        let length = block.len() as u16;
        stream.extend(length.to_le_bytes());
        stream.extend((!length).to_le_bytes());
        stream.extend(block);
    }
    let (mut a, mut b) = (1u32, 0u32);
    for &byte in data {
        a = (a + u32::from(byte)) % 65_521;
        b = (b + a) % 65_521;
    }
    stream.extend((b << 16 | a).to_be_bytes());
    stream
}

fn crc32(data: &[u8]) -> u32 {
    !data.iter().fold(!0, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc: u32, _| {
            (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

fn base64(data: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(data.len() * 4 / 3 + 4);
    for three in data.chunks(3) {
        let bits = (0..3).fold(0u32, |bits, i| {
            bits << 8 | u32::from(three.get(i).copied().unwrap_or(0))
        });
        for i in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * i)) as usize & 63];
            text.push(if i <= three.len() {
                char::from(letter)
            } else {
                '='
            });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of RFC 1950, RFC 4648 and the PNG recommendation, annex D.
    #[test]
    fn sums_and_letters_are_those_of_the_standards() {
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
        assert_eq!(crc32(b"IEND"), 0xae42_6082);
        assert_eq!(stored(b"Wikipedia")[16..], 0x11e6_0398u32.to_be_bytes());
        let words = ["", "f", "fo", "foo", "foob", "fooba", "foobar"];
        let coded = [
            "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy",
        ];
        assert_eq!(words.map(|word| base64(word.as_bytes())), coded);
    }

    #[test]
    fn long_rows_are_cut_into_blocks_and_the_last_one_says_so() {
        let stream = stored(&vec![7; 100_000]);
        assert_eq!(stream.len(), 2 + 2 * 5 + 100_000 + 4);
        assert_eq!((stream[2], stream[2 + 5 + 0xffff]), (0, 1));
    }
}
