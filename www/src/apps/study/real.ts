/** Loads pieces of the world's rivers. */

import { type Piece, SIDE } from "./piece.ts";
import rivers from "./real.json";
import sprite from "./real.png";

/** The number of pieces side by side in the picture. */
const COLUMNS = 11;

export interface Real {
  /** The name of its greatest river; empty if it has none. */
  river: string;
  kilometresPerPixel: number;
  piece: Piece;
}

export async function realPieces(): Promise<Real[]> {
  const picture = await createImageBitmap(await (await fetch(sprite)).blob());
  const canvas = document.createElement("canvas");
  canvas.width = picture.width;
  canvas.height = picture.height;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("this browser gives no 2D canvas");
  context.drawImage(picture, 0, 0);
  return rivers.map((river, i) => {
    const at = context.getImageData((i % COLUMNS) * SIDE, Math.floor(i / COLUMNS) * SIDE, SIDE, SIDE).data;
    return {
      ...river,
      piece: Uint8Array.from({ length: SIDE * SIDE }, (_, pixel) => Number((at[4 * pixel] ?? 0) > 127)),
    };
  });
}
