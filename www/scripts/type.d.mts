/** A face, and the style of the font that it is taken from. */
export interface Face {
  name: string;
  style: string;
}

/** The faces that there are. */
export const FACES: Face[];

/** Returns the bytes of a face's table of type. */
export function table(face: Face): Uint8Array;
