import { describe, expect, it } from 'vitest';
import { fromBase64, toBase64 } from './base64';

describe('base64', () => {
  it('is what Node makes of all lengths up to 300 bytes', () => {
    for (let length = 0; length <= 300; length++) {
      const bytes = Uint8Array.from({ length }, (_, index) => (index * 89 + length * 41) % 256);
      const text = Buffer.from(bytes).toString('base64');
      expect(toBase64(bytes)).toBe(text);
      expect(fromBase64(text)).toEqual(bytes);
    }
  });

  it('is refused with a foreign sign, a wrong length or an early end', () => {
    for (const text of ['AAA', 'AA-A', 'A=AA', 'AA=A', '=AAA', 'AAAA=', 'ÄAAA']) expect(fromBase64(text)).toBeNull();
  });
});
