import { describe, expect, it } from 'vitest';
import { I2cBus, type I2cTarget } from './i2c-bus';
import { createBench } from '../testing/bench';

/** A chip that remembers what it got and always sends the same. */
function chipThatSends(...answer: number[]): I2cTarget & { readonly got: number[][] } {
  const got: number[][] = [];
  return { got, write: (bytes) => void got.push([...bytes]), read: () => Uint8Array.from(answer) };
}

const motors = 0x10;

describe('the I2C bus', () => {
  it('I1: an address nobody owns is not acknowledged, and costs its address byte only', () => {
    const { i2c } = createBench().board;
    expect(i2c.write(motors, Uint8Array.of(0, 0, 50))).toEqual({
      acknowledged: false,
      durationUs: 100,
      bytes: new Uint8Array(0),
    });
    expect(i2c.read(motors, 5)).toEqual({ acknowledged: false, durationUs: 100, bytes: new Uint8Array(0) });
    expect(i2c.writeUs(motors, 0)).toBe(100);
  });

  it('I2: two chips cannot have the same address, and addresses end at 127', () => {
    const bus = new I2cBus();
    bus.attach(motors, chipThatSends());
    expect(() => bus.attach(motors, chipThatSends())).toThrow('I2C address 16 is taken.');
    expect(() => bus.attach(128, chipThatSends())).toThrow('I2C address 128 is not within 0 … 127.');
    expect(() => bus.attach(1.5, chipThatSends())).toThrow(RangeError);
  });

  it('I3: a read gives as many bytes as were asked for, missing ones as 255', () => {
    const bus = new I2cBus();
    bus.attach(motors, chipThatSends(1, 2));
    expect([...bus.read(motors, 4).bytes]).toEqual([1, 2, 255, 255]);
    expect([...bus.read(motors, 1).bytes]).toEqual([1]);
  });

  it('I4: three bytes at 100 kHz take 370 µs: four times nine bits and the gap', () => {
    const { i2c } = createBench().board;
    const chip = chipThatSends();
    i2c.attach(motors, chip);
    expect(i2c.writeUs(motors, 3)).toBe(370);
    expect(i2c.write(motors, Uint8Array.of(0, 1, 50))).toMatchObject({ acknowledged: true, durationUs: 370 });
    expect(i2c.readUs(motors, 3)).toBe(370);
    expect(chip.got).toEqual([[0, 1, 50]]);
  });

  it('I5: a wish for 1 MHz, 399 kHz, 250 kHz and 5 kHz gives 400, 250, 250 and 100 kHz', () => {
    const { i2c } = createBench().board;
    const got = [1_000_000, 399_000, 250_000, 5_000].map((wish) => {
      i2c.setFrequency(wish);
      return i2c.frequencyHz;
    });
    expect(got).toEqual([400_000, 250_000, 250_000, 100_000]);
  });

  it('I5: at 400 kHz three bytes take 100 µs', () => {
    const { i2c } = createBench().board;
    i2c.setFrequency(400_000);
    expect(i2c.transferUs(3)).toBe(100);
  });

  it('I6: an empty write takes 1 ms when a chip answers', () => {
    const { i2c } = createBench().board;
    i2c.attach(motors, chipThatSends());
    expect(i2c.write(motors, new Uint8Array(0))).toMatchObject({ acknowledged: true, durationUs: 1000 });
  });

  it('I7: a chip that was detached answers no more', () => {
    const bus = new I2cBus();
    const detach = bus.attach(motors, chipThatSends());
    expect(bus.answers(motors)).toBe(true);
    detach();
    expect(bus.answers(motors)).toBe(false);
    bus.attach(motors, chipThatSends());
    detach();
    expect(bus.answers(motors)).toBe(true);
  });

  it('I8: led over other wires it hears the chips there, and only those', () => {
    const { board } = createBench();
    const { i2c } = board;
    const [outside, inside] = [chipThatSends(1), chipThatSends(2)];
    const wires = { scl: board.wire('P1'), sda: board.wire('P2') };
    i2c.attach(motors, inside);
    i2c.attach(motors, outside, wires);
    i2c.useWires(wires);
    expect([...i2c.read(motors, 1).bytes]).toEqual([1]);
    i2c.useWires({ scl: wires.sda, sda: wires.scl });
    expect(i2c.answers(motors)).toBe(false);
    i2c.useWires(null);
    expect([...i2c.read(motors, 1).bytes]).toEqual([2]);
  });
});
