import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

describe('SPI syscalls', () => {
  const started = () => {
    const hal = createHalBench();
    const { board } = hal.bench;
    board.spi.attach(
      { clock: board.wire('P13'), mosi: board.wire('P15'), miso: board.wire('P14') },
      { transfer: (sent) => sent ^ 0xff },
    );
    for (const n of [13, 15, 14]) hal.call('spi_hold', n);
    hal.call('spi_init', 13, 15, 14, 1_000_000, 0);
    return hal;
  };

  it('exchange bytes in memory, 8 µs each at 1 MHz and 5 µs for the call', () => {
    const { put, timed, memory } = started();
    expect(timed('spi_transfer', put([1, 2, 3], 10), 20, 3)).toEqual({ value: 0, us: 29 });
    expect([...memory.subarray(20, 23)]).toEqual([254, 253, 252]);
  });

  it('only send when there is no address to receive at', () => {
    const { put, call, memory } = started();
    call('spi_transfer', put([1, 2], 10), 0, 2);
    expect(memory[0]).toBe(0);
  });

  it('answer −1 before the bus is initialised, and name who holds a pin', () => {
    const { call } = createHalBench();
    expect([call('spi_is_on'), call('spi_transfer', 10, 0, 1)]).toEqual([false, -1]);
    expect([call('spi_hold', 3), call('spi_hold', 13), call('spi_init', 99, 15, 14, 0, 0)]).toEqual([
      'display',
      null,
      -1,
    ]);
  });
});
