import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

describe('serial syscalls', () => {
  it('read what a person typed and write to the console while the line is on USB', () => {
    const { call, put, port, sent, memory } = createHalBench();
    port.feed('ab\nc');
    expect([call('uart_waiting'), call('uart_line')]).toEqual([4, 3]);
    call('uart_read', 50, 3);
    expect([...memory.subarray(50, 53)]).toEqual([97, 98, 10]);
    call('uart_write', put([104, 105], 10), 2);
    expect(sent()).toBe('hi');
  });

  it('read and write on pins instead; 1042 µs a byte at 9600 baud', () => {
    const { bench, call, timed, put, port, sent } = createHalBench();
    const heard: number[] = [];
    bench.board.wire('P0').onSerial(({ bytes }) => heard.push(...bytes));
    port.feed('typed');
    call('uart_init', 9600, 0, 1);
    bench.board.wire('P1').serial({ bytes: Uint8Array.of(7), baud: 9600 });
    expect(call('uart_waiting')).toBe(1);
    expect(timed('uart_write', put([1, 2], 10), 2).us).toBe(5 + 2083);
    expect([heard, sent()]).toEqual([[1, 2], '']);
  });

  it('wait for the next byte 2 ms at 9600 baud, 1 ms at 115200, not at all before the first init', () => {
    const { bench, call, timed } = createHalBench();
    expect(timed('uart_more')).toEqual({ value: false, us: 0 });
    call('uart_init', 9600, -1, 1);
    expect(timed('uart_more')).toEqual({ value: false, us: 2000 });
    call('uart_init', 115_200, -1, 1);
    expect(timed('uart_more')).toEqual({ value: false, us: 1000 });
    bench.clock.at(bench.clock.nowUs + 300, () =>
      bench.board.wire('P1').serial({ bytes: Uint8Array.of(7), baud: 115_200 }),
    );
    expect(timed('uart_more')).toEqual({ value: true, us: 300 });
  });

  it('go on with the same wait after a callback', () => {
    const { call, timed, interrupted } = createHalBench();
    call('uart_init', 9600, -1, 1);
    expect(interrupted(500, 'uart_more')).toBeNull();
    expect(timed('uart_more')).toEqual({ value: false, us: 1500 });
  });
});
