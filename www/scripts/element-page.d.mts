import type { Parameter } from "../pkg-full/riverseed_full.js";
export function withTables(text: string, parameters: readonly Parameter[]): string;
