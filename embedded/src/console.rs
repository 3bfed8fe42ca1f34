//! Text to the host through semihosting, without `core::fmt`: formatting code would be most of
//! the program, and may panic.

use cortex_m_semihosting::debug;
use cortex_m_semihosting::hio::{self, HostStream};
use motes_core::error::Error;

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

    /// Writes the names that a line of the table starts with.
    pub fn row(&mut self, scenario: &str, particles: usize, scalar: &str) {
        self.text(scenario);
        self.text(",");
        self.decimal(particles as u64);
        self.text(",");
        self.text(scalar);
        self.text(",");
    }

    /// Writes the digest that a line of the table ends with.
    pub fn outcome(&mut self, outcome: &Result<u64, Error>) {
        match outcome {
            Ok(digest) => {
                self.hexadecimal(*digest);
                self.text("\n");
            }
            Err(_) => self.text("failed\n"),
        }
    }

    /// Ends the program: QEMU's exit code is 0 only if all went well.
    pub fn close(self, ok: bool) -> ! {
        debug::exit(if ok {
            debug::EXIT_SUCCESS
        } else {
            debug::EXIT_FAILURE
        });
        loop {
            cortex_m::asm::wfi();
        }
    }

    fn character(&mut self, character: u8) {
        if let Some(host) = &mut self.0 {
            let _ = host.write_all(&[character]);
        }
    }
}
