/** Stands in for `backend.ts` in the classic script: the renderer on the page itself, since no worker can be loaded from disk. */

import { RenderHost } from "../../host/render-host.ts";
import * as pageBackend from "./page-backend.ts";
import type { Init, Question } from "./protocol.ts";

/** One renderer for all widgets of a page. */
export const renderHost = new RenderHost<Question, Blob, [Init]>(({ tell }, init) => pageBackend.open(tell, init));

/** Returns the renderer for the page itself, which is part of the script. */
export async function importPageBackend(): Promise<typeof import("./page-backend.ts")> {
  return pageBackend;
}
