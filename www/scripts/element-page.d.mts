import type { Parameter } from "../src/engine/table.ts";
export function withTables(text: string, parameters: readonly Parameter[]): string;
