/** Parameters that social networks, search engines and newsletters add to shared addresses. */

/** Prefixes of campaign parameters, such as `utm_source` and `mtm_campaign`. */
const PREFIXES: readonly string[] = ["utm_", "hsa_", "mtm_", "pk_"];

// biome-ignore format: a list to be read
const NAMES: readonly string[] = [
  // Social networks.
  "fbclid", "igsh", "igshid", "twclid", "ttclid", "li_fat_id", "rdt_cid", "epik", "ScCid", "si",
  // Search engines and their advertisements.
  "gclid", "gclsrc", "gbraid", "wbraid", "dclid", "gad_source", "gad_campaignid", "srsltid", "msclkid", "yclid", "ysclid", "_ga", "_gl",
  // Newsletters, and the counting of their readers.
  "mc_cid", "mc_eid", "_hsenc", "_hsmi", "__hstc", "__hssc", "__hsfp", "mkt_tok", "vero_id", "oly_anon_id", "oly_enc_id", "_kx",
  // Where a visitor came from.
  "ref", "ref_src", "ref_url",
];

/**
 * Removes tracking parameters from address text. They are not reported, since the visitor did not add them. The rest is
 * unchanged.
 */
export function withoutTrackers(text: string): string {
  return text
    .split("&")
    .filter((part) => !isTracker(part))
    .join("&");
}

function isTracker(part: string): boolean {
  // HTML's ampersand may have come with the name.
  const [name] = new URLSearchParams(part.replace(/^(?:amp;)+/, "")).keys();
  return name !== undefined && (NAMES.includes(name) || PREFIXES.some((prefix) => name.startsWith(prefix)));
}
