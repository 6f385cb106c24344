import { describe, expect, it } from 'vitest';
import { createRegisterMachine, liveRegisters, memoryRegisters, textRegisters } from './i2c-registers';

/** Four registers from 0x02 with a memory, one at 0x10 that counts its readings, a text at 0xFD. */
function machine() {
  const written: number[][] = [];
  let readings = 0;
  const target = createRegisterMachine([
    memoryRegisters(0x02, 4, (bytes) => written.push([...bytes])),
    liveRegisters(0x10, 1, () => ++readings),
    textRegisters(0xfd, 'V1'),
  ]);
  const write = (...bytes: number[]): void => target.write(Uint8Array.from(bytes));
  const read = (count: number): number[] => [...target.read(count)];
  return { write, read, written };
}

describe('A register machine on the I2C bus', () => {
  it('keeps what is written and gives it back from the selected register on', () => {
    const { write, read } = machine();
    write(0x02, 10, 11, 12, 13);
    write(0x03);
    expect(read(2)).toEqual([11, 12]);
    expect(read(1)).toEqual([13]);
  });

  it('tells its owner once per transfer, with all contents, and only about registers that were written', () => {
    const { write, written } = machine();
    write(0x04, 7);
    write(0x00, 1, 2, 3, 4);
    write(0x04);
    write(0x20, 5);
    write();
    expect(written).toEqual([
      [0, 0, 7, 0],
      [3, 4, 7, 0],
    ]);
  });

  it('asks a live register anew at each reading and lets nobody write it', () => {
    const { write, read } = machine();
    write(0x10, 99);
    write(0x10);
    expect(read(1)).toEqual([1]);
    write(0x10);
    expect(read(2)).toEqual([2, 0]);
  });

  it('gives the length of a text, then its letters', () => {
    const { write, read } = machine();
    write(0xfd);
    expect(read(3)).toEqual([2, 'V'.charCodeAt(0), '1'.charCodeAt(0)]);
  });

  it('reads 0 where nothing is, and goes on from 255 to 0', () => {
    const { write, read } = machine();
    write(0xff, 65, 66, 67, 42);
    write(0xfe);
    expect(read(6)).toEqual(['V'.charCodeAt(0), '1'.charCodeAt(0), 0, 0, 42, 0]);
  });

  it('starts at register 0', () => {
    expect(machine().read(3)).toEqual([0, 0, 0]);
  });
});
