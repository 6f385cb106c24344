import { describe, expect, it } from 'vitest';
import { fnvOfBytes, fnvOfText } from './fnv';

describe('FNV-1a', () => {
  it.each([
    ['', 0x811c9dc5],
    ['a', 0xe40c292c],
    ['foobar', 0xbf9cf968],
  ])('of %j is what its authors publish', (text, sum) => {
    expect(fnvOfText(text)).toBe(sum);
    expect(fnvOfBytes(new TextEncoder().encode(text))).toBe(sum);
  });

  it('goes on where another part ended', () => {
    expect(fnvOfText('bar', fnvOfText('foo'))).toBe(fnvOfText('foobar'));
  });
});
