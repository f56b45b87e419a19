/** What social networks, search engines and newsletters hang on to the addresses that people pass on. */

/** Campaigns, in everybody's spelling: `utm_source`, `mtm_campaign`. */
const PREFIXES: readonly string[] = ["utm_", "hsa_", "mtm_", "pk_"];

// biome-ignore format: a list to be read
const NAMES: readonly string[] = [
  // Social networks.
  "fbclid", "igsh", "igshid", "twclid", "ttclid", "li_fat_id", "rdt_cid", "epik", "ScCid", "si",
  // Search engines and their advertisements.
  "gclid", "gclsrc", "gbraid", "wbraid", "dclid", "gad_source", "gad_campaignid", "srsltid", "msclkid", "yclid", "ysclid", "_ga", "_gl",
  // Newsletters, and what counts their readers.
  "mc_cid", "mc_eid", "_hsenc", "_hsmi", "__hstc", "__hssc", "__hsfp", "mkt_tok", "vero_id", "oly_anon_id", "oly_enc_id", "_kx",
  // Where somebody came from.
  "ref", "ref_src", "ref_url",
];

/** Address text without them: its reader did not put them there, so they are not reported. What stays is as it was. */
export function withoutTrackers(text: string): string {
  return text
    .split("&")
    .filter((part) => !isTracker(part))
    .join("&");
}

function isTracker(part: string): boolean {
  const [name] = new URLSearchParams(part).keys();
  return name !== undefined && (NAMES.includes(name) || PREFIXES.some((prefix) => name.startsWith(prefix)));
}
