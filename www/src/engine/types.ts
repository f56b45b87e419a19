/** The types of the wasm modules' functions. Only this folder knows where the packages are. */

export type * from "../../pkg-make/riverseed.js";
export type {
  FinishedMap,
  Inspector,
  LabelFacts,
  Measure,
  PlaceFacts,
  RiverFacts,
} from "../../pkg-tell/riverseed_tell.js";
export type { Cells, MapFiles } from "../../pkg-write/riverseed_write.js";
