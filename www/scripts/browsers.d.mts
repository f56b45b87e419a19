export type Browser = "chrome" | "edge" | "firefox" | "safari" | "ios";
export function floor(): Record<Browser, string>;
export function targets(): string[];
