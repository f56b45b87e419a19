/** Tells the owner of the page of a failure. */

import type { PageError } from "../../engine/page-error.ts";
import { importPageBackend } from "./backend.ts";
import type { ErrorDetail } from "./events.ts";

/** Reports a failure: as an event, and on the console unless a listener prevents that, which `emit` returns. */
export async function reportFailure(error: PageError, emit: (detail: ErrorDetail) => boolean): Promise<void> {
  const { code, message } = error;
  // The advice is fetched when it is needed. If that fails too, the code has to suffice.
  const advice = await importPageBackend().then(
    ({ advice }) => advice(error).text,
    () => "",
  );
  if (emit({ code, message, advice })) console.warn(`river-seed: ${code}: ${message}. ${advice}`);
}
