import decodeQR from 'qr/decode.js';
import { describe, expect, it } from 'vitest';

import { QR_CHARACTERS, qrPath } from './qr-code';

/** Paints the drawing as a camera would see it, three pixels a square, and reads it. */
function readBack(link: string): string {
  const drawn = qrPath(link);
  if (drawn === null) return '';
  const side = drawn.size * 3;
  const data = new Uint8Array(side * side * 4).fill(255);
  for (const [, x = '', y = '', length = ''] of drawn.path.matchAll(/M(\d+) (\d+)h(\d+)/g))
    for (let row = 3 * Number(y); row < 3 * Number(y) + 3; row += 1)
      for (let column = 3 * Number(x); column < 3 * (Number(x) + Number(length)); column += 1)
        data.fill(0, (row * side + column) * 4, (row * side + column) * 4 + 3);
  return decodeQR({ width: side, height: side, data });
}

describe('a QR code', () => {
  it('says the link again', () => {
    const link = 'https://parcours.example/app/#p=1.aZRXROcAADVPO0oEQRB9VdXV0z3d-_x0BiYgi7DyiG0';
    expect(readBack(link)).toBe(link);
  });

  it('takes links of 2,953 characters and no longer ones', () => {
    const longest = 'aZ-_'.repeat(800).slice(0, QR_CHARACTERS);
    expect(readBack(longest)).toBe(longest);
    expect(qrPath(`${longest}a`)).toBeNull();
  });
});
