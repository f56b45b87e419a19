/** The types of the wasm modules' functions. Only this folder knows where the packages are. */

export type {
  Cells,
  Inspector,
  LabelFacts,
  LakeFacts,
  Lengths,
  Making,
  MapPromise,
  Measure,
  Moment,
  NameFacts,
  Part,
  PlaceFacts,
  Raster,
  RiverFacts,
} from "../../pkg-engine/riverseed_engine.js";
export type * from "../../pkg-make/riverseed.js";
