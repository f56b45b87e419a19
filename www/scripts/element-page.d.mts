import type { Parameter } from "../pkg/riverseed.js";
export function withTables(text: string, parameters: readonly Parameter[]): string;
