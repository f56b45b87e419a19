/** Copies the core's pixels to the canvas, only where they changed. */

/** The core's pixels in its own memory. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  pixelsPointer(): number;
  pixelsLength(): number;
  dirty(): Uint32Array;
}

export class Blitter {
  #image: ImageData | undefined;

  constructor(
    private readonly context: Pick<CanvasRenderingContext2D, "putImageData">,
    private readonly memory: WebAssembly.Memory,
  ) {}

  /** Copies the rectangle that the last paint changed. */
  blit(pixels: Pixels): void {
    const [x = 0, y = 0, width = 0, height = 0] = pixels.dirty();
    if (width > 0 && height > 0) this.context.putImageData(this.#view(pixels), 0, 0, x, y, width, height);
  }

  /**
   * Returns a view of the core's pixels without a copy. It is kept until memory grows (which detaches it), or the
   * pixels move or change size.
   */
  #view(pixels: Pixels): ImageData {
    const image = this.#image;
    const pointer = pixels.pixelsPointer();
    if (
      image &&
      image.data.buffer === this.memory.buffer &&
      image.data.byteOffset === pointer &&
      image.width === pixels.width &&
      image.height === pixels.height
    ) {
      return image;
    }
    const bytes = new Uint8ClampedArray(this.memory.buffer, pointer, pixels.pixelsLength());
    this.#image = new ImageData(bytes, pixels.width, pixels.height);
    return this.#image;
  }
}
