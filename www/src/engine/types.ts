/** The types of the engine's functions. Only this folder knows where the packages are. */

export type * from "../../pkg/riverseed.js";
