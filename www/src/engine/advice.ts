/** What a person can do about each failure. Apart from their names: who has no failure need not have these. */

import type { Code, PageError } from "./errors.ts";

export interface Advice {
  title: string;
  /** What to do, in one or two sentences. */
  text: string;
  /** Whether loading the page again is likely to help. */
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
      "Its file could not be downloaded whole. Check the connection and load the page again. Whoever runs this site: the " +
      ".wasm file must lie beside the scripts, on a web server, and for pages of another origin that server must send " +
      "Access-Control-Allow-Origin.",
    reload: true,
  },
  "wasm-mime": {
    title: "The server sent something else",
    text:
      "In place of the river engine came a file that is not WebAssembly, most often the server’s own error page. " +
      "Whoever runs this site should upload the .wasm file and serve it as “application/wasm”.",
    reload: true,
  },
  "wasm-csp": {
    title: "This site’s policy forbids WebAssembly",
    text:
      "The Content-Security-Policy stopped the river engine. Whoever runs this site should add " +
      "'wasm-unsafe-eval' to its script-src.",
    reload: false,
  },
  "wasm-timeout": {
    title: "The river engine did not answer",
    text:
      "Nothing more of it came for too long, so it was given up. Check the connection and load the page again. Whoever runs " +
      "this site: see whether the server sends the scripts and the .wasm file whole.",
    reload: true,
  },
  "no-tools": {
    title: "A part of Riverseed did not arrive",
    text: "What makes files and traces pictures could not be downloaded. Check the connection and try again.",
    reload: true,
  },
  "bad-params": {
    title: "This recipe could not be read",
    text: "A value in it is not one that the river engine knows. Start from a fresh river, then change one thing at a time.",
    reload: false,
  },
  "too-large": {
    title: "This river is too large to draw here",
    text: "It asks for more memory than the page may take. Use fewer attractors, or a smaller window.",
    reload: false,
  },
  "no-memory": {
    title: "The memory ran out before the rivers were done",
    text: "The browser gave the page no more of it. Use fewer attractors, or close other pages and load this one again.",
    reload: true,
  },
  "no-land": {
    title: "This is no land",
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
