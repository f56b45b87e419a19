/** What the engine's functions take and give. Where the packages lie is known to this folder alone. */

export type * from "../../pkg/riverseed.js";
