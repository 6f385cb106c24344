import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

describe('serial_input', () => {
  it('echoes what is typed, rubs out with backspace, and ends at Return', () => {
    const { call, port, sent } = createHalBench();
    port.feed('hallp\x7fo\r\n');
    expect(call('serial_input')).toBe('hallo');
    expect(sent()).toBe('hallp\b\x1b[Ko\r\n');
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
    expect(call('serial_input', false)).toBe('abc');
  });

  it('answers 4 for Ctrl-D on an empty line', () => {
    const { call, port } = createHalBench();
    port.feed('\x04');
    expect(call('serial_input')).toBe(4);
  });
});
