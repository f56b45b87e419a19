/** The studio on the page itself, in slices: where workers are refused. */

import { load } from "../wasm.ts";
import type { News } from "./orders.ts";
import { Studio } from "./studio.ts";

export async function openHere(tell: (news: News) => void, wasmUrl: string | undefined): Promise<Studio> {
  return new Studio(await load(wasmUrl), tell);
}
