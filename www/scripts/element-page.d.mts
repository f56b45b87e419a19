import type { Parameter } from "../pkg-page/riverseed_page.js";
export function withTables(text: string, parameters: readonly Parameter[]): string;
