//! Lines of text to the host.
//!
//! In: words and numbers. Out: a line over semihosting. `core::fmt` is not used, because it has tables of functions and
//! paths that panic, which the image must not have.

use cortex_m_semihosting::hio;

/// A line of limited length; text beyond it is cut off.
pub struct Line {
    bytes: [u8; 160],
    length: usize,
}

impl Line {
    /// An empty line.
    pub fn new() -> Self {
        Self {
            bytes: [0; 160],
            length: 0,
        }
    }

    /// Appends a word.
    pub fn text(&mut self, text: &str) -> &mut Self {
        text.bytes().for_each(|byte| self.byte(byte));
        self
    }

    /// Appends an integer; one that does not fit a `u32` becomes the largest.
    pub fn integer(&mut self, value: impl TryInto<u32>) -> &mut Self {
        let value = value.try_into().unwrap_or(u32::MAX);
        let mut power = 1;
        while value / power >= 10 {
            power *= 10;
        }
        while power > 0 {
            // One digit.
            self.byte(b'0' + (value / power % 10) as u8);
            power /= 10;
        }
        self
    }

    /// Appends a number with three digits after the point.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the size of what is not huge"
    )]
    pub fn number(&mut self, value: f32) -> &mut Self {
        let size = value.abs();
        if size.is_nan() {
            return self.text("nan");
        }
        if value < 0.0 {
            self.text("-");
        }
        if size >= 4e6 {
            return self.text("huge");
        }
        let thousandths = (size * 1000.0 + 0.5) as u32;
        self.integer(thousandths / 1000).text(".");
        for power in [100, 10, 1] {
            self.byte(b'0' + (thousandths / power % 10) as u8);
        }
        self
    }

    /// Sends the line to the host.
    pub fn print(&mut self) {
        self.byte(b'\n');
        let line = self.bytes.get(..self.length).unwrap_or_default();
        // Without a host the error cannot be reported.
        if let Ok(mut host) = hio::hstdout() {
            let _ = host.write_all(line);
        }
    }

    fn byte(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }
}
