/** The used part of gifenc; the package has no types. */
declare module 'gifenc' {
  /** Red, green and blue, 0 … 255 each. */
  export type Colour = readonly [number, number, number];

  /** At most this many colours that represent those of the pixels (red, green, blue, alpha; a buffer of their own). */
  export function quantize(rgba: Uint8ClampedArray, most: number): Colour[];

  /** The place of the nearest colour for each pixel. */
  export function applyPalette(rgba: Uint8ClampedArray, palette: readonly Colour[]): Uint8Array;

  interface FrameOptions {
    /** The first picture must have one: it serves all that have none. */
    readonly palette?: readonly Colour[];
    /** In ms, in tens. */
    readonly delay: number;
    readonly transparent?: boolean;
    readonly transparentIndex?: number;
    /** 1: the next picture is drawn over this one. */
    readonly dispose: number;
  }

  export function GIFEncoder(): {
    writeFrame(index: Uint8Array, width: number, height: number, options: FrameOptions): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  };
}
