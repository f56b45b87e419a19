export function membersOf(code: string, lang?: "ts" | "dts"): string[];
export function newerThanFloor(code: string, ours?: ReadonlySet<string>): { line: number; name: string }[];
