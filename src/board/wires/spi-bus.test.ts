import { describe, expect, it } from 'vitest';
import type { SpiTarget } from './spi-bus';
import { createBench } from '../testing/bench';

/** A chip that remembers what it got and answers the byte before. */
function echo(): SpiTarget & { readonly got: number[] } {
  const got: number[] = [];
  return {
    got,
    transfer: (sent) => {
      got.push(sent);
      return got[got.length - 2] ?? 0x5a;
    },
  };
}

function bench() {
  const table = createBench();
  const { board } = table;
  const wires = { clock: board.wire('P13'), mosi: board.wire('P15'), miso: board.wire('P14') };
  const pins = { clock: board.pin('pin13'), mosi: board.pin('pin15'), miso: board.pin('pin14') };
  return { ...table, spi: board.spi, wires, pins };
}

describe('the SPI bus', () => {
  it('Q1: is off until it is initialised', () => {
    const { spi, pins } = bench();
    expect(spi.isOn).toBe(false);
    expect(() => spi.transfer(Uint8Array.of(1))).toThrow('SPI is off');
    spi.init(pins, 1_000_000, 0);
    expect(spi.isOn).toBe(true);
  });

  it('Q2: exchanges a byte with a byte; the levels of the wires do not move', () => {
    const { spi, pins, wires, record } = bench();
    const chip = echo();
    spi.attach(wires, chip);
    spi.init(pins, 1_000_000, 0);
    const seen = record('P13');
    expect([...spi.transfer(Uint8Array.of(1, 2, 3))]).toEqual([0x5a, 1, 2]);
    expect(chip.got).toEqual([1, 2, 3]);
    expect(seen).toEqual([]);
  });

  it('Q2: rests with the clock high in modes 2 and 3', () => {
    const { spi, pins, wires } = bench();
    spi.init(pins, 1_000_000, 3);
    expect([wires.clock.level, wires.mosi.level]).toEqual([1, 0]);
  });

  it('Q3: a wish for 20, 5, 1 MHz, 300 and 1 kHz gives 8, 4, 1 MHz, 250 and 125 kHz', () => {
    const { spi, pins } = bench();
    const got = [20_000_000, 5_000_000, 1_000_000, 300_000, 1000].map((wish) => {
      spi.init(pins, wish, 0);
      return spi.frequencyHz / 1000;
    });
    expect(got).toEqual([8000, 4000, 1000, 250, 125]);
    expect(spi.transferUs(10)).toBe(640);
  });

  it('Q4: where no chip answers the level of the wire is read: 0, or 255 with a pull-up outside', () => {
    const { spi, pins, board } = bench();
    spi.init(pins, 1_000_000, 0);
    expect([...spi.transfer(Uint8Array.of(9, 9))]).toEqual([0, 0]);
    board.wire('P14').connect('resistor').pull('up');
    expect([...spi.transfer(Uint8Array.of(9))]).toEqual([255]);
  });

  it('Q4: where two chips answer a low bit wins, and one that is not selected leaves the wire alone', () => {
    const { spi, pins, wires } = bench();
    spi.init(pins, 1_000_000, 0);
    spi.attach(wires, { transfer: () => 0b1100 });
    spi.attach(wires, { transfer: () => null });
    const detach = spi.attach(wires, { transfer: () => 0b0110 });
    expect([...spi.transfer(Uint8Array.of(0))]).toEqual([0b0100]);
    detach();
    expect([...spi.transfer(Uint8Array.of(0))]).toEqual([0b1100]);
  });

  it('Q5: a chip on other wires hears nothing', () => {
    const { spi, pins, board } = bench();
    const chip = echo();
    spi.attach({ clock: board.wire('P0'), mosi: board.wire('P1'), miso: null }, chip);
    spi.init(pins, 1_000_000, 0);
    spi.transfer(Uint8Array.of(1));
    spi.init({ ...pins, clock: board.pin('pin0'), mosi: board.pin('pin1') }, 1_000_000, 0);
    spi.transfer(Uint8Array.of(2));
    expect(chip.got).toEqual([2]);
  });
});
