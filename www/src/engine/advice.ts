/** Advice for each failure. Separate from the error codes, so that these texts are loaded only after a failure. */

import type { Code, PageError } from "./errors.ts";

export interface Advice {
  title: string;
  /** One or two sentences that say what to do. */
  text: string;
  /** True if loading the page again is likely to help. */
  reload: boolean;
}

const ADVICE: Record<Code, Advice> = {
  "wasm-unsupported": {
    title: "This browser cannot grow rivers",
    text:
      "Riverseed needs WebAssembly with SIMD. It runs in Chrome and Edge 120, Firefox 121, Safari 17.2 and newer. " +
      "Update the browser, or allow WebAssembly if a privacy setting turned it off.",
    reload: true,
  },
  "wasm-fetch": {
    title: "The river engine did not arrive",
    text:
      "Its file could not be downloaded completely. Check the connection and reload the page. For the site’s owner: the " +
      ".wasm file must be on a web server, beside the scripts, and for pages of another origin that server must send " +
      "Access-Control-Allow-Origin.",
    reload: true,
  },
  "wasm-mime": {
    title: "The server sent something else",
    text:
      "The server sent a file that is not WebAssembly, most often its own error page. For the site’s owner: upload the " +
      ".wasm file and serve it as “application/wasm”.",
    reload: true,
  },
  "wasm-csp": {
    title: "This site’s policy forbids WebAssembly",
    text:
      "The Content-Security-Policy blocked the river engine. For the site’s owner: add 'wasm-unsafe-eval' to the " +
      "policy’s script-src.",
    reload: false,
  },
  "wasm-timeout": {
    title: "The river engine did not answer",
    text:
      "It took too long to load, or stopped responding. Check the connection and reload the page. For the site’s owner: " +
      "check that the server sends the scripts and the .wasm file completely.",
    reload: true,
  },
  "file-missing": {
    title: "This site has just changed",
    text:
      "One of its files is gone, or belongs to another version. Load the page again. For the site’s owner: if it stays " +
      "so, upload all .js and .wasm files of one build, the .wasm files beside the scripts.",
    reload: true,
  },
  "bad-params": {
    title: "This recipe could not be read",
    text: "The river engine does not know one of its values. Start from a new river, then change one thing at a time.",
    reload: false,
  },
  "too-large": {
    title: "This river is too large to draw here",
    text: "It needs more memory than the page may use. Use fewer attractors, or a smaller window.",
    reload: false,
  },
  "no-memory": {
    title: "Not enough memory to finish the rivers",
    text: "The browser gave the page no more memory. Use fewer attractors, or close other pages and reload this one.",
    reload: true,
  },
  "no-land": {
    title: "No land found",
    text: "A land needs a coast with water on one side. Draw a larger one, or choose another picture.",
    reload: false,
  },
  "bad-image": {
    title: "This picture cannot be read",
    text: "Choose a PNG, at most 4096 pixels a side: white for land, black for water.",
    reload: false,
  },
  panic: {
    title: "The river engine stopped",
    text:
      "That is a fault in Riverseed, not in anything you did. Load the page again; if it stops at the same place, " +
      "start from a fresh river, and please report the link.",
    reload: true,
  },
  unknown: {
    title: "Something went wrong",
    text: "Load the page again. If it happens at the same place, please report it together with the link.",
    reload: true,
  },
};

export function advice(error: PageError): Advice {
  return ADVICE[error.code];
}
