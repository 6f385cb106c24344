import { describe, expect, it } from 'vitest';

import { paintColors } from '#scene/paint/paint';
import { paints } from './paints';

const linear = (byte: number): number => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4); // prettier-ignore
function luminance(hex: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => linear(parseInt(hex.slice(at, at + 2), 16)));
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

describe('the colours of fields and things', () => {
  it.each(paintColors)('have a frame and words of 4.5:1 at least to their ground: %s', (color) => {
    const [light = 0, dark = 0] = [paints[color].fill, paints[color].ink].map(luminance).sort((a, b) => b - a);
    expect((light + 0.05) / (dark + 0.05)).toBeGreaterThanOrEqual(4.5);
  });
});
