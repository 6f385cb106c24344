import { describe, expect, it } from 'vitest';
import { createHalBench } from './testing/hal-bench';

describe('serial_input', () => {
  it('echoes what is typed, rubs out with backspace, and ends at Return', () => {
    const { call, port, sent } = createHalBench();
    port.feed('hallp\x7fo\r\n');
    expect(call('serial_input')).toBe('hallo');
    expect(sent()).toBe('hallp\b \bo\n');
  });

  it('takes Return and newline as one end of line, two newlines as two', () => {
    const { call, port } = createHalBench();
    port.feed('a\r\nb\n\n');
    expect([call('serial_input'), call('serial_input'), call('serial_input')]).toEqual(['a', 'b', '']);
  });

  it('waits for the rest of a line and keeps what was typed before a callback', () => {
    const { bench, call, interrupted, port } = createHalBench();
    port.feed('ab');
    expect(interrupted(1000, 'serial_input')).toBeNull();
    bench.clock.at(5000, () => port.feed('c\r'));
    expect(call('serial_input')).toBe('abc');
  });

  it('answers 4 for Ctrl-D on an empty line', () => {
    const { call, port } = createHalBench();
    port.feed('\x04');
    expect(call('serial_input')).toBe(4);
  });
});

describe('serial bytes', () => {
  it('counts, finds the line and reads', () => {
    const { call, memory, port } = createHalBench();
    port.feed('abc\nde');
    expect([call('serial_waiting'), call('serial_line')]).toEqual([6, 4]);
    call('serial_read', 10, 4);
    expect([...memory.subarray(10, 14)]).toEqual([97, 98, 99, 10]);
    expect([call('serial_waiting'), call('serial_line')]).toEqual([2, 2]);
  });

  it('takes 87 µs a byte at 115,200 baud and 1042 µs at 9600', () => {
    const { call, put, sent, timed } = createHalBench();
    expect(timed('serial_write', put([104, 105]), 2).us).toBe(179);
    call('serial_init', 9600);
    expect(timed('serial_write', put([104, 105]), 2).us).toBe(2088);
    expect(sent()).toBe('hihi');
  });
});
