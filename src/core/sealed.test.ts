import { describe, expect, it } from 'vitest';

import { sealed, unsealed } from './sealed';

const bytes = Uint8Array.from([0, 1, 250, 255, 7, 7, 7]);

describe('bytes in an address', () => {
  it('come back as they were', () => expect(unsealed(sealed(bytes))).toEqual(bytes));

  it('have four more for their checksum', () => expect(sealed(bytes)).toHaveLength(Math.ceil((11 * 4) / 3)));

  it('are refused if they were cut short, changed or never were any', () => {
    const text = sealed(bytes);
    for (let length = 0; length < text.length; length += 1) expect(unsealed(text.slice(0, length))).toBeNull();
    expect(unsealed(`${text.slice(0, -2)}AA`)).toBeNull();
    expect(unsealed('not*base64')).toBeNull();
  });
});
