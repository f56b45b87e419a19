export function table(): Uint8Array;
