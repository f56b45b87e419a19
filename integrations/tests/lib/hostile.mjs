// Words of people who wish a page ill: each may be text in an attribute, and nothing else anywhere.

export const HOSTILE = [
  "<script>globalThis.hit=1</script>",
  '"><img src=x onerror=globalThis.hit=1>',
  "' onload='globalThis.hit=1",
  "</river-seed><b>bold</b>",
  "../../../../etc/passwd",
  "..\\..\\windows",
  "{{ 7 | times: 7 }} {% raw %} ${7*7}",
  "$(touch hit) `touch hit`; touch hit",
  "-o hit.png",
  "a & b &amp; c %26 + d",
  "\u202egnp.exe\u202c",
];

/** Two hundred letters, where sixty-four are allowed. */
export const LONG = "x".repeat(200);
