import decodeQR from 'qr/decode.js';
import { describe, expect, it } from 'vitest';

import { QR_RIM } from '../../../kit/links/qr-code';
import { PAPER_QR_CHARACTERS, paperQr, type PaperQr } from './paper-qr';

const link = (characters: number): string => 'https://parcours.example/#p=9.'.padEnd(characters, 'aZ-_7');

/** Side of the code without its rim, in mm. */
const sideMm = ({ size, squareMm }: PaperQr): number => (size - 2 * QR_RIM) * squareMm;

/**
 * Reads a code as a camera sees it from paper: 200 dots an inch, each the mean of what it covers, so that edges are grey, on
 * paper that is not white, with a stain.
 */
function readFromPaper({ runs, size, squareMm }: PaperQr): string {
  const fine = 8;
  const dark = Array.from({ length: size * fine }, () => new Uint8Array(size * fine));
  for (const { x, y, length } of runs)
    for (let row = y * fine; row < (y + 1) * fine; row += 1) dark[row]?.fill(1, x * fine, (x + length) * fine);
  const step = (25.4 / 200 / squareMm) * fine;
  const side = Math.floor((size * fine) / step);
  const data = new Uint8Array(side * side * 4).fill(255);
  for (let y = 0; y < side; y += 1)
    for (let x = 0; x < side; x += 1) {
      let sum = 0;
      let count = 0;
      for (let fromY = Math.floor(y * step); fromY < (y + 1) * step; fromY += 1)
        for (let fromX = Math.floor(x * step); fromX < (x + 1) * step; fromX += 1) {
          sum += dark[fromY]?.[fromX] ?? 0;
          count += 1;
        }
      data.fill(Math.round(225 - (190 * sum) / count), (y * side + x) * 4, (y * side + x) * 4 + 3);
    }
  const stain = { at: Math.round(0.55 * side), side: Math.round(1 / 0.127) }; // one mm of 0.127 mm dots
  for (let row = stain.at; row < stain.at + stain.side; row += 1)
    data.fill(60, (row * side + stain.at) * 4, (row * side + stain.at + stain.side) * 4);
  return decodeQR({ width: side, height: side, data });
}

describe('a QR code on paper', () => {
  it('is as large as a stamp for the link of a ready course, with squares of 0.9 mm', () => {
    const code = paperQr(link(120))!;
    expect(code.squareMm).toBe(0.9);
    expect(sideMm(code)).toBeLessThan(45);
  });

  it('is never wider than 56 mm, nor are its squares smaller than 0.42 mm', () => {
    for (const characters of [300, 700, 1000, 1300, PAPER_QR_CHARACTERS]) {
      const code = paperQr(link(characters))!;
      expect(sideMm(code)).toBeLessThanOrEqual(56.001);
      expect(code.squareMm).toBeGreaterThanOrEqual(0.42);
    }
  });

  it.each([120, 600, 1200, PAPER_QR_CHARACTERS])(
    'is read with grey paper, 200 dots an inch and a stain of 1 mm: %i characters',
    (characters) => expect(readFromPaper(paperQr(link(characters))!)).toBe(link(characters)),
  );

  it('is not printed for a link of more than 1,628 characters', () => {
    expect(paperQr(link(PAPER_QR_CHARACTERS + 1))).toBeNull();
    expect(paperQr(link(3000))).toBeNull();
  });
});
