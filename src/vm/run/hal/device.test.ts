import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

describe('device syscalls', () => {
  it('reads temperature and light; the room has 21 °C', () => {
    const { bench, call } = createHalBench();
    expect([call('temperature'), call('light_level')]).toEqual([21, 127]);
    bench.board.sensors.set('lightLevel', 10);
    expect(call('light_level')).toBe(10);
  });

  it('has an id of 8 bytes that depends on the seed alone', () => {
    const ids = [createHalBench(), createHalBench()].map(({ call, memory }) => {
      call('unique_id', 0);
      return [...memory.subarray(0, 9)];
    });
    expect(ids[0]).toEqual(ids[1]);
    expect(ids[0]?.[8]).toBe(0);
    expect(ids[0]?.slice(0, 8).some((byte) => byte > 0)).toBe(true);
  });

  it('knows what the chip says of itself, the same id included', () => {
    const { call, memory } = createHalBench();
    call('unique_id', 0);
    const id = new DataView(memory.buffer).getUint32(0, true);
    expect([0x1000_0060, 0x1000_0100, 0x1000_0110, 0x5000_0510].map((address) => call('chip_word', address))).toEqual([
      id,
      0x52833,
      512,
      null,
    ]);
  });
});
