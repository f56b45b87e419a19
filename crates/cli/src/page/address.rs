//! The address of a site, given by the caller and written into files as it is read.

use http::Uri;
use http::uri::{Authority, Scheme};
use riverseed::recipe::shown;

use super::super::Failure;

/// An address of a folder on the web, without user, query or fragment.
#[derive(Clone, Debug)]
pub struct Address {
    /// The scheme, host and port, as a content security policy names them.
    pub origin: String,
    /// The path, with a slash at both ends.
    path: String,
}

impl Address {
    /// Reads the value of an option. A folder's address gets the slash at its end that it may lack.
    ///
    /// # Errors
    /// Refuses everything but an http or https address of a folder.
    pub fn read(option: &'static str, text: &str) -> Result<Self, Failure> {
        let refused = |reason: String| Failure::Address { option, text: shown(text), reason };
        let uri: Uri = text.parse().map_err(|error| refused(format!("{error}; {EXPECTED}")))?;
        let is_web = |scheme: &&Scheme| [Scheme::HTTP, Scheme::HTTPS].contains(scheme);
        let is_host = |authority: &&Authority| !authority.as_str().contains('@');
        match (uri.scheme().filter(is_web), uri.authority().filter(is_host), uri.query()) {
            // The parser drops fragments.
            (Some(scheme), Some(authority), None) if !text.contains('#') => Ok(Self {
                origin: format!("{scheme}://{authority}"),
                path: format!("{}/", uri.path().trim_end_matches('/')),
            }),
            _ => Err(refused(EXPECTED.into())),
        }
    }

    /// The address of a file in the folder.
    pub fn of(&self, file: &str) -> String {
        format!("{}{}{file}", self.origin, self.path)
    }

    /// The address of the folder with a link as its query.
    pub fn with_query(&self, link: &str) -> String {
        format!("{}?{link}", self.of(""))
    }
}

const EXPECTED: &str = "expected the address of a folder, such as https://example.org/maps/kauri/, without ? and #";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_read_and_files_in_them_found() {
        for text in ["https://example.org/maps/kauri", "https://example.org/maps/kauri/"] {
            let address = Address::read("--address", text).unwrap();
            assert_eq!(address.of(""), "https://example.org/maps/kauri/");
            assert_eq!(address.of("card.jpg"), "https://example.org/maps/kauri/card.jpg");
            assert_eq!(address.with_query("seed=a+b"), "https://example.org/maps/kauri/?seed=a+b");
        }
        assert_eq!(Address::read("--address", "http://localhost:8000").unwrap().of("a"), "http://localhost:8000/a");
        assert_eq!(Address::read("--address", "https://a.b:1/c//").unwrap().origin, "https://a.b:1");
    }

    #[test]
    fn other_addresses_are_refused_with_what_is_expected() {
        for text in [
            "",
            "kauri/",
            "javascript:alert(1)",
            "file:///tmp/",
            "https://a.b/?x",
            "https://a.b/#x",
            "https://u:p@a.b/",
        ] {
            let refusal = Address::read("--address", text).unwrap_err().to_string();
            assert!(refusal.contains("--address") && refusal.contains("https://example.org/"), "{text}: {refusal}");
        }
    }
}
