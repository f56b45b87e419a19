/**
 * What can go wrong, by name, and what a person can do about each. Every failure that reaches the page passes
 * through `named`, so that nobody is shown a stack trace or a blank canvas.
 */

export type Code =
  | "wasm-unsupported"
  | "wasm-fetch"
  | "wasm-mime"
  | "wasm-csp"
  | "no-tools"
  | "bad-params"
  | "too-large"
  | "no-land"
  | "bad-image"
  | "panic"
  | "unknown";

export class PageError extends Error {
  constructor(
    readonly code: Code,
    message: string,
  ) {
    super(message);
    this.name = "PageError";
  }
}

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
      "Riverseed needs WebAssembly with SIMD: Chrome 91, Edge 91, Firefox 89, Safari 16.4 or newer. " +
      "Update the browser, or allow WebAssembly if a privacy setting turned it off.",
    reload: true,
  },
  "wasm-fetch": {
    title: "The river engine did not arrive",
    text:
      "Its file could not be downloaded whole. Check the connection and load the page again. If this is your own copy " +
      "of the site, the .wasm file must lie beside the scripts in “assets”, and the page must come from a web server.",
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

function isCode(code: unknown): code is Code {
  return typeof code === "string" && Object.hasOwn(ADVICE, code);
}

/** Gives whatever was thrown its name. The core's errors carry a code; a trap in wasm is a panic. */
export function named(thrown: unknown): PageError {
  if (thrown instanceof PageError) return thrown;
  if (!(thrown instanceof Error)) return new PageError("unknown", String(thrown));
  if ("code" in thrown && isCode(thrown.code)) return new PageError(thrown.code, thrown.message);
  if (thrown.name === "RuntimeError") return new PageError("panic", thrown.message);
  // What engines throw when memory cannot grow: `RangeError` from typed arrays and from WebAssembly.Memory.
  if (thrown instanceof RangeError) return new PageError("too-large", thrown.message);
  return new PageError("unknown", thrown.message);
}

const RECOVERABLE: ReadonlySet<Code> = new Set(["no-tools", "bad-params", "too-large", "no-land", "bad-image"]);

/** A failure after which the picture on the page is still good, so that a note beside it is enough. */
export function isRecoverable(error: PageError): boolean {
  return RECOVERABLE.has(error.code);
}
