/** Fetches and starts wasm modules, and gives each failure a code. */

import { PageError } from "./errors.ts";
import { DOWNLOAD_SILENCE_MS, limited } from "./time-limits.ts";

/** A module of one function that splats and counts bits in four lanes: valid only where SIMD is. */
const SIMD_PROBE = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** HTTP statuses of a file that does not exist: "not found" and "gone". */
const GONE: ReadonlySet<number> = new Set([404, 410]);

/**
 * Returns whether the browser runs wasm with SIMD. Checked before the download, so that an old browser fetches nothing
 * in vain.
 */
function isSupported(): boolean {
  return typeof WebAssembly === "object" && WebAssembly.validate(SIMD_PROBE);
}

/** Wraps a loader so that it runs once and every caller gets its result. After a failure it can be tried again. */
export function once<Given extends unknown[], T>(
  load: (...given: Given) => Promise<T>,
): (...given: Given) => Promise<T> {
  let loading: Promise<T> | undefined;
  return (...given) => {
    loading ??= load(...given).catch((error: unknown) => {
      loading = undefined;
      throw error;
    });
    return loading;
  };
}

/** Fetches a module and links it with its script. Calls `progress` for every part of the module that arrives. */
export async function start<T>(
  url: string,
  link: (compiled: WebAssembly.Module) => Promise<T>,
  progress: () => void = () => {},
): Promise<T> {
  if (!isSupported()) throw new PageError("wasm-unsupported", "no WebAssembly, or none with SIMD");
  const compiled = await compiledFrom(url, progress);
  try {
    return await link(compiled);
  } catch (error) {
    // Script and wasm from different builds do not link: a stale cache, or half an upload.
    if (error instanceof WebAssembly.LinkError) throw new PageError("file-missing", error.message);
    throw error;
  }
}

/**
 * Downloads and compiles a module. Gives up when nothing more arrives, and then aborts the connection: the next try
 * gets a new one.
 */
async function compiledFrom(url: string, progress: () => void): Promise<WebAssembly.Module> {
  const control = new AbortController();
  try {
    return await limited(DOWNLOAD_SILENCE_MS, url, async (heard) => {
      const response = await download(url, control.signal);
      void tellOfParts(response.clone(), () => {
        heard();
        progress();
      });
      return compile(response);
    });
  } catch (error) {
    control.abort();
    throw error;
  }
}

/**
 * Reads a copy of the response, so that the response itself can be compiled while it streams, and cached. Its errors
 * are reported there.
 */
async function tellOfParts({ body }: Response, heard: () => void): Promise<void> {
  const reader = body?.getReader();
  try {
    while (reader && !(await reader.read()).done) heard();
  } catch {}
}

async function download(url: string, signal: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, { credentials: "same-origin", signal });
  } catch (error) {
    throw new PageError("wasm-fetch", String(error));
  }
  const { ok, status } = response;
  if (!ok)
    throw new PageError(GONE.has(status) ? "file-missing" : "wasm-fetch", `the server answered ${status} for ${url}`);
  return response;
}

async function compile(response: Response): Promise<WebAssembly.Module> {
  const type = response.headers.get("content-type") ?? "";
  try {
    if (type.startsWith("application/wasm")) return await WebAssembly.compileStreaming(response);
    // The wrong type on the right bytes is common on plain hosts and harms nobody: compile without streaming.
    const bytes = await response.arrayBuffer();
    if (!isWasm(bytes)) throw new PageError("wasm-mime", `expected application/wasm, got ${type || "no type"}`);
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw nameCompileError(error);
  }
}

function isWasm(bytes: ArrayBuffer): boolean {
  const magic = new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength));
  return magic.length === 4 && magic.every((byte, i) => byte === SIMD_PROBE[i]);
}

function nameCompileError(error: unknown): PageError {
  if (error instanceof PageError) return error;
  const message = error instanceof Error ? error.message : String(error);
  // There is no error class for this: Chromium and Safari name the missing keyword, Firefox says CSP.
  if (/unsafe-eval|content security policy|\bCSP\b/i.test(message)) return new PageError("wasm-csp", message);
  return new PageError("wasm-fetch", message);
}
