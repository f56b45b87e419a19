//! The address of a site, given by the caller and written into files as it is read.

use http::Uri;
use http::uri::Scheme;
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
        if !text.is_ascii() {
            return Err(refused(format!(
                "other letters than ASCII have to be encoded (xn--… in hosts, %… in paths); {EXPECTED}"
            )));
        }
        let uri: Uri = text.parse().map_err(|error| refused(format!("{error}; {EXPECTED}")))?;
        let scheme = uri.scheme().filter(|scheme| [&Scheme::HTTP, &Scheme::HTTPS].contains(scheme));
        let authority = uri.authority().map(http::uri::Authority::as_str).filter(|authority| is_authority(authority));
        let path = Some(uri.path()).filter(|path| is_folder(path));
        match (scheme, authority, path, uri.query()) {
            // The parser drops fragments.
            (Some(scheme), Some(authority), Some(path), None) if !text.contains('#') => {
                Ok(Self { origin: format!("{scheme}://{authority}"), path: format!("{}/", path.trim_end_matches('/')) })
            }
            _ => Err(refused(EXPECTED.into())),
        }
    }

    /// Returns the address of a file in the folder.
    pub fn of(&self, file: &str) -> String {
        format!("{}{}{file}", self.origin, self.path)
    }

    /// Returns the address of the folder with a link as its query.
    pub fn with_query(&self, link: &str) -> String {
        format!("{}?{link}", self.of(""))
    }
}

const EXPECTED: &str = "expected the address of a folder, such as https://example.org/maps/kauri/, without ? and #";

/// Returns `true` for a host with or without a port. It is stricter than the standard, since hosts stand in content
/// security policies, where other signs have a meaning.
fn is_authority(authority: &str) -> bool {
    let (host, port) = match authority.rsplit_once(':').filter(|(_, port)| !port.ends_with(']')) {
        Some((host, port)) => (host, Some(port)),
        None => (authority, None),
    };
    let is_name = |sign: u8| sign.is_ascii_alphanumeric() || sign == b'-' || sign == b'.';
    let is_number = |sign: u8| sign.is_ascii_hexdigit() || sign == b':' || sign == b'.';
    let is_host = match host.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        Some(number) => !number.is_empty() && number.bytes().all(is_number),
        None => !host.is_empty() && host.bytes().all(is_name),
    };
    let is_port =
        |port: &str| port.bytes().all(|sign| sign.is_ascii_digit()) && port.parse::<u16>().is_ok_and(|port| port > 0);
    is_host && port.is_none_or(is_port)
}

/// Returns `true` for the path of a folder: of plain and percent-encoded signs, without steps up, and no page.
fn is_folder(path: &str) -> bool {
    let is_plain = |sign: u8| sign.is_ascii_alphanumeric() || b"-._~!$&'()*+,;=:@/".contains(&sign);
    let mut signs = path.bytes();
    while let Some(sign) = signs.next() {
        let is_encoded =
            |signs: &mut std::str::Bytes<'_>| (0..2).all(|_| signs.next().is_some_and(|sign| sign.is_ascii_hexdigit()));
        if !(is_plain(sign) || sign == b'%' && is_encoded(&mut signs)) {
            return false;
        }
    }
    let is_step = |part: &str| matches!(part, "." | "..");
    let page = path.trim_end_matches('/').to_ascii_lowercase();
    !path.split('/').any(is_step) && !page.ends_with(".html") && !page.ends_with(".htm")
}

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
        assert_eq!(
            Address::read("--address", "https://[::1]:80/%C3%A4/").unwrap().of("b"),
            "https://[::1]:80/%C3%A4/b"
        );
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
