/** A picture in memory; the browser's `ImageData` is one. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue and alpha 0 … 255 per pixel, not premultiplied, row by row from the upper left. */
  readonly data: Uint8ClampedArray<ArrayBuffer>;
}

/** An empty, transparent picture. */
export const emptyPixels = (width: number, height: number): Pixels => ({
  width,
  height,
  data: new Uint8ClampedArray(4 * width * height),
});

/** A picture turned by a quarter, clockwise. */
export function quarterTurned({ width, height, data }: Pixels): Pixels {
  const turned = emptyPixels(height, width);
  const from = new Uint32Array(data.buffer, data.byteOffset, width * height);
  const to = new Uint32Array(turned.data.buffer);
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1) to[x * height + (height - 1 - y)] = from[y * width + x] ?? 0;
  return turned;
}
