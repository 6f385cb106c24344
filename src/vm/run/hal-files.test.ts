import { describe, expect, it } from 'vitest';
import { createHalBench, type HalBench } from './testing/hal-bench';

const take = (hal: HalBench, handle: number, unit: number, count: number): string => {
  const bytes = Number(hal.call('file_span', handle, unit, count));
  hal.call('file_read', handle, 0, bytes);
  return new TextDecoder().decode(hal.memory.slice(0, bytes));
};

describe('file syscalls', () => {
  it('reads by bytes, characters and lines', () => {
    const hal = createHalBench({ 'a.txt': 'eins\nzwei\näöü' });
    const handle = Number(hal.call('file_open', 'a.txt', false));
    expect(take(hal, handle, 2, -1)).toBe('eins\n');
    expect(take(hal, handle, 0, 2)).toBe('zw');
    expect(take(hal, handle, 2, 1)).toBe('e');
    expect(take(hal, handle, 1, 4)).toBe('i\näö');
    expect(take(hal, handle, 1, -1)).toBe('ü');
    expect(take(hal, handle, 2, -1)).toBe('');
  });

  it('writes a new file and tells its size', () => {
    const hal = createHalBench();
    const handle = hal.call('file_open', 'b', true);
    expect(hal.call('file_write', handle, hal.put([1, 2, 3]), 3)).toBe(3);
    expect(hal.call('file_span', handle, 0, 1)).toBe(-9);
    hal.call('file_close', handle);
    expect([hal.call('file_size', 'b'), hal.call('file_name', 0), hal.call('file_name', 1)]).toEqual([3, 'b', null]);
  });

  it('answers −2 for a file that is not there and −9 for one that was removed', () => {
    const hal = createHalBench({ a: 'x' });
    expect([hal.call('file_open', 'b', false), hal.call('file_size', 'b'), hal.call('file_remove', 'b')]).toEqual([
      -2, -2, -2,
    ]);
    const handle = hal.call('file_open', 'a', false);
    expect(hal.call('file_remove', 'a')).toBe(0);
    expect(hal.call('file_span', handle, 0, 1)).toBe(-9);
  });

  it('answers −28 when the board is full', () => {
    const hal = createHalBench();
    const handle = hal.call('file_open', 'a', true);
    expect(hal.call('file_write', handle, 0, 20_000)).toBe(20_000);
    expect(hal.call('file_write', handle, 0, 5000)).toBe(-28);
  });
});
