export interface Typeface {
  name: string;
  of: string;
  letters: string;
}

export const TYPEFACES: readonly Typeface[];
export function cut(one: Typeface): Promise<Buffer>;
