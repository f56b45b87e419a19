/** The river engine without the element, for programs that draw rivers in their own way. */

export { named, PageError } from "../../engine/errors.ts";
export { type Core, type Engine, load } from "../../engine/make.ts";
export type * from "../../engine/types.ts";
