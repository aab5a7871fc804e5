//! Many questions, answered in order, in memory for one.

use std::io::{self, BufRead, BufReader, Read, Write};

use indicatif::ProgressBar;

use crate::question::{Precision, answer, refuse};

/// The longest line that is read, in bytes. A description of the most terms is shorter.
pub const MAX_LINE: usize = 1 << 20;

/// How many answers may wait to be written, in bytes.
const MAX_PENDING: usize = 1 << 16;

/// How many questions there were.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    pub questions: u64,
    /// Those whose answer is an error.
    pub failed: u64,
}

/// What editors of some systems write in front of a text in UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Answers every line that is not blank; errors count the blank ones too. The progress counts bytes of the input.
pub fn answer_all(
    input: &mut BufReader<impl Read>,
    output: &mut impl Write,
    precision: Precision,
    progress: &ProgressBar,
) -> io::Result<Tally> {
    let (mut tally, mut number) = (Tally::default(), 0);
    let (mut line, mut pending) = (Vec::new(), Vec::new());
    loop {
        // Before waiting for more questions, whoever asks gets the answers to those so far.
        if pending.len() >= MAX_PENDING || input.buffer().is_empty() {
            progress.suspend(|| output.write_all(&pending).and_then(|()| output.flush()))?;
            pending.clear();
        }
        line.clear();
        let read = input.by_ref().take(MAX_LINE as u64 + 1).read_until(b'\n', &mut line)?;
        if read == 0 {
            return Ok(tally);
        }
        progress.inc(read as u64);
        number += 1;
        let too_long = read > MAX_LINE && line.last() != Some(&b'\n');
        if too_long {
            progress.inc(skip_line(input)?);
        }
        let text = match line.strip_prefix(BYTE_ORDER_MARK) {
            Some(text) if number == 1 => text,
            _ => &line,
        };
        let text = text.trim_ascii();
        if text.is_empty() && !too_long {
            continue;
        }
        tally.questions += 1;
        let answered = if too_long {
            Err(format!("a line may have at most {MAX_LINE} bytes"))
        } else {
            answer(text, precision, &mut pending)
        };
        if let Err(error) = answered {
            tally.failed += 1;
            refuse(&error, number, &mut pending);
        }
        pending.push(b'\n');
    }
}

/// Skips the rest of a line and counts its bytes.
fn skip_line(input: &mut impl BufRead) -> io::Result<u64> {
    input.skip_until(b'\n').map(|skipped| skipped as u64)
}
