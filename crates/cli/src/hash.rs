//! The hash FNV-1a (Fowler, Noll, Vo) with 128 bits: it tells files and names apart by chance, not against forgers.

use std::fs::File;
use std::io::{BufRead, BufReader, Result};
use std::path::Path;

const OFFSET_BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;

/// Computes the hash of bytes.
pub fn of(bytes: &[u8]) -> u128 {
    with(OFFSET_BASIS, bytes)
}

/// Computes the hash of a file's bytes, of which it holds few at a time.
///
/// # Errors
/// Fails with the reader's errors.
pub fn of_file(path: &Path) -> Result<u128> {
    let mut file = BufReader::new(File::open(path)?);
    let mut hash = OFFSET_BASIS;
    loop {
        let bytes = file.fill_buf()?;
        let count = bytes.len();
        if count == 0 {
            return Ok(hash);
        }
        hash = with(hash, bytes);
        file.consume(count);
    }
}

fn with(hash: u128, bytes: &[u8]) -> u128 {
    bytes.iter().fold(hash, |hash, byte| (hash ^ u128::from(*byte)).wrapping_mul(PRIME))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hash_is_as_published_and_that_of_a_file_is_that_of_its_bytes() {
        assert_eq!(of(b"foobar"), 0x343e_1662_793c_64bf_6f0d_3597_ba44_6f18);
        let long = [b"riverseed".repeat(3000), vec![0]].concat();
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(&file, &long).unwrap();
        assert_eq!(of_file(file.path()).unwrap(), of(&long));
    }
}
