import { zlibSync, deflateSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { toBase64 } from '#core/base64';
import { packLevels, unpackLevels } from './background';

describe('the levels of a background', () => {
  const levels = Uint8Array.from({ length: 600 * 450 }, (_, cell) => (cell * 7) % 16);

  it('are the same after packing and unpacking, and are packed at least ten times smaller than they are', () => {
    const packed = packLevels(levels);
    expect(packed.length).toBeLessThan(levels.length / 10);
    expect(unpackLevels({ cells: [600, 450], levels: packed })).toEqual(levels);
  });

  it('are refused if they are not as many as the cells, too few or too many', () => {
    const packed = packLevels(levels);
    expect(unpackLevels({ cells: [600, 451], levels: packed })).toBeNull();
    expect(unpackLevels({ cells: [600, 449], levels: packed })).toBeNull();
    expect(unpackLevels({ cells: [1, 1], levels: '' })).toBeNull();
  });

  it('are refused if they would become 16 MB', () => {
    const bomb = toBase64(deflateSync(new Uint8Array(16_000_000), { level: 9 }));
    expect(bomb.length).toBeLessThan(30_000);
    expect(unpackLevels({ cells: [1000, 1000], levels: bomb })).toBeNull();
  });

  it('are refused without an exception if they are damaged: cut, no base64, no deflated data, brighter than 15', () => {
    const packed = packLevels(levels);
    const damaged = [packed.slice(0, 400), 'A', '====', '!!!!', '////', toBase64(zlibSync(levels))];
    for (const text of damaged) expect(unpackLevels({ cells: [600, 450], levels: text })).toBeNull();
    expect(unpackLevels({ cells: [2, 1], levels: packLevels(new Uint8Array([3, 16])) })).toBeNull();
  });
});
