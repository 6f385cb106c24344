import LZString from 'lz-string';
import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';

import { textOfLzBase64 } from './lz-string';

describe('a text that LZ-String packed', () => {
  it('comes back, whatever is in it', () => {
    const rng = createRng(4);
    const letters = Array.from('ab \nüß€😀\u0000\uffff');
    const random = (length: number): string =>
      Array.from({ length }, () => letters[rng.u32() % letters.length]).join('');
    const texts = ['a', 'aaaaaaaaaaaaa', 'print("hi")\n', ...[1, 2, 3, 10, 100, 5_000].map(random)];
    for (const text of texts) expect(textOfLzBase64(LZString.compressToBase64(text), 10_000)).toEqual({ text });
  });

  it('comes back from the alphabet of addresses too', () => {
    const text = '[{"name":"main.py","data":"from gturtle import *\\nmakeTurtle()\\n"}]';
    const base64 = LZString.compressToBase64(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
    expect(textOfLzBase64(base64, 1_000)).toEqual({ text });
  });

  it('is not unpacked beyond the limit: a kB would become 300 kB', () => {
    const bomb = LZString.compressToBase64('a'.repeat(300_000));
    expect(bomb.length).toBeLessThan(2_000);
    expect(textOfLzBase64(bomb, 100_000)).toBe('too-large');
  });

  it('is damaged when it is cut off or no base64', () => {
    const whole = LZString.compressToBase64('while True:\n    forward()\n');
    for (const text of ['', '!', 'A', whole.slice(0, 9), 'a%20b']) expect(textOfLzBase64(text, 100)).toBe('damaged');
  });
});
