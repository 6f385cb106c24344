import { describe, expect, it } from 'vitest';
import { createHalBench, type HalBench } from '../testing/hal-bench';

/** Reads like an open file: from its own position on. */
const reader = (hal: HalBench, name: string): ((unit: number, count: number) => string) => {
  const file = Number(hal.call('file_open', name, false));
  let place = 0;
  return (unit, count) => {
    const bytes = Number(hal.call('file_span', file, place, unit, count));
    hal.call('file_read', file, place, 0, bytes);
    place += bytes;
    return new TextDecoder().decode(hal.memory.slice(0, bytes));
  };
};

describe('file syscalls', () => {
  it('reads by bytes, characters and lines', () => {
    const hal = createHalBench({ 'a.txt': 'eins\nzwei\näöü' });
    const take = reader(hal, 'a.txt');
    expect(take(2, -1)).toBe('eins\n');
    expect(take(0, 2)).toBe('zw');
    expect(take(2, 1)).toBe('e');
    expect(take(1, 4)).toBe('i\näö');
    expect(take(1, -1)).toBe('ü');
    expect(take(2, -1)).toBe('');
  });

  it('writes a new file and tells its size', () => {
    const hal = createHalBench();
    const file = hal.call('file_open', 'b', true);
    expect(hal.call('file_write', file, hal.put([1, 2, 3]), 3)).toBe(3);
    hal.call('file_close', file);
    expect([hal.call('file_size', 'b'), hal.call('file_name', 0), hal.call('file_name', 1)]).toEqual([3, 'b', null]);
  });

  it('answers −2 for a file that is not there and −9 for one that was removed', () => {
    const hal = createHalBench({ a: 'x' });
    expect([hal.call('file_open', 'b', false), hal.call('file_size', 'b'), hal.call('file_remove', 'b')]).toEqual([
      -2, -2, -2,
    ]);
    const file = hal.call('file_open', 'a', false);
    expect(hal.call('file_remove', 'a')).toBe(0);
    expect(hal.call('file_span', file, 0, 0, 1)).toBe(-9);
  });

  it('answers −28 when the board is full', () => {
    const hal = createHalBench();
    const file = hal.call('file_open', 'a', true);
    expect(hal.call('file_write', file, 0, 20_000)).toBe(20_000);
    expect(hal.call('file_write', file, 0, 5000)).toBe(-28);
  });
});
