import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

const benchWithChip = () => {
  const hal = createHalBench();
  const written: number[][] = [];
  hal.bench.board.i2c.attach(0x10, {
    write: (bytes) => written.push([...bytes, hal.bench.clock.nowUs]),
    read: (count) => Uint8Array.from({ length: count }, (_, i) => i + 1),
  });
  return { ...hal, written };
};

describe('I2C syscalls', () => {
  it('writes two bytes at 100 kHz in 280 µs; they count when the transfer is over', () => {
    const { put, timed, written } = benchWithChip();
    expect(timed('i2c_write', 0x10, put([7, 8]), 2)).toEqual({ value: 0, us: 280 });
    expect(written).toEqual([[7, 8, 280]]);
  });

  it('is faster at 400 kHz', () => {
    const { call, put, timed } = benchWithChip();
    call('i2c_init', 400_000);
    expect(timed('i2c_write', 0x10, put([7, 8]), 2).us).toBe(78);
  });

  it('reads into memory', () => {
    const { call, memory } = benchWithChip();
    expect(call('i2c_read', 0x10, 100, 3)).toBe(0);
    expect([...memory.subarray(100, 104)]).toEqual([1, 2, 3, 0]);
  });

  it('answers −19 after the address alone when nobody is there, and for an address that is no number', () => {
    const { call, timed } = benchWithChip();
    expect(timed('i2c_write', 0x11, 0, 5)).toEqual({ value: -19, us: 100 });
    expect(timed('i2c_read', 0x11, 0, 5)).toEqual({ value: -19, us: 100 });
    expect(call('i2c_write', 'a', 0, 1)).toBe(-19);
  });

  it('finds the one chip there is, and takes 1 ms to see it', () => {
    const { call, timed } = benchWithChip();
    expect(timed('i2c_next', 0x07)).toEqual({ value: 0x10, us: 8 * 100 + 1000 });
    expect(call('i2c_next', 0x10)).toBe(-1);
  });

  it('leads the bus over other pins, by their numbers, and back', () => {
    const { bench, call } = benchWithChip();
    call('i2c_init', 100_000, 1, 2);
    expect([call('i2c_read', 0x10, 100, 1), bench.board.pin('pin1').mode]).toEqual([-19, 'unused']);
    expect(bench.board.wire('P1').level).toBe(1);
    call('i2c_init', 100_000, 19, 20);
    expect(call('i2c_read', 0x10, 100, 1)).toBe(0);
  });
});
