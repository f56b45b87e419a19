/** Most readers never ask for a file: what writes them is fetched when somebody does. */

import { named, PageError } from "./errors.ts";
import type { FilesCore } from "./files.ts";
import { limited, SCRIPT_MS } from "./time-limits.ts";

/** From where it lies beside the script, unless its first caller knows better. */
export async function fetchFiles(url?: string): Promise<FilesCore> {
  try {
    const files = await limited(SCRIPT_MS, "its script", () => import("./files.ts"));
    return await files.loadFiles(url);
  } catch (thrown) {
    const { code, message } = named(thrown);
    throw new PageError(
      "no-files",
      `the part of Riverseed that does this did not arrive (${code}: ${message}). Check the connection and try again.`,
    );
  }
}
