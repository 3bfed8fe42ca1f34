//! Text to the host through semihosting, without `core::fmt`: formatting code would be most of
//! the program, and may panic.

use cortex_m_semihosting::hio::{self, HostStream};

/// The host's standard output.
pub struct Console(Option<HostStream>);

impl Console {
    /// Opens it. Without a host, what is written is lost.
    pub fn open() -> Self {
        Self(hio::hstdout().ok())
    }

    /// Writes text.
    pub fn text(&mut self, text: &str) {
        if let Some(host) = &mut self.0 {
            let _ = host.write_all(text.as_bytes());
        }
    }

    /// Writes 16 hexadecimal digits.
    pub fn hexadecimal(&mut self, value: u64) {
        for place in (0..16).rev() {
            let digit = (value >> (4 * place) & 15) as u8;
            self.character(if digit < 10 {
                b'0' + digit
            } else {
                b'a' + digit - 10
            });
        }
    }

    /// Writes a whole number.
    pub fn decimal(&mut self, value: u64) {
        let mut power = 1;
        while value / 10 >= power {
            power *= 10;
        }
        while power > 0 {
            self.character(b'0' + (value / power % 10) as u8);
            power /= 10;
        }
    }

    fn character(&mut self, character: u8) {
        if let Some(host) = &mut self.0 {
            let _ = host.write_all(&[character]);
        }
    }
}
