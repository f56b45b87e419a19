/** Stands in for `engine/write.ts` in the classic script, which would be half as large again with it. */

import { PageError } from "../../engine/errors.ts";
import type { Writer } from "../../engine/write.ts";

/** Refuses to load the writer. */
export async function loadWriter(): Promise<Writer> {
  throw new PageError("no-files", "river-seed.classic.js makes no SVG: use river-seed.js, on a web server");
}
