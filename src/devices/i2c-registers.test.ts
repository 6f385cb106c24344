import { describe, expect, it } from 'vitest';
import {
  createRegisterMachine,
  liveRegisters,
  memoryRegisters,
  textRegisters,
  type RegisterOptions,
} from './i2c-registers';

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

describe('A register machine that keeps the register it was told', () => {
  it('reads from there each time: a flag that is asked for once more, without its number', () => {
    let flag = 1;
    const target = createRegisterMachine([liveRegisters(87, 1, () => flag--)], { staysSelected: true });
    target.write(Uint8Array.of(87));
    expect([target.read(1)[0], target.read(1)[0]]).toEqual([1, 0]);
  });

  it('reads from there after data as well: [76, 1], then two bytes', () => {
    const speeds = liveRegisters(76, 2, (offset) => 65 + offset);
    const after = (options?: RegisterOptions): number[] => {
      const target = createRegisterMachine([speeds], options);
      target.write(Uint8Array.of(76, 1));
      return [...target.read(2)];
    };
    expect(after()).toEqual([66, 0]);
    expect(after({ staysSelected: true })).toEqual([65, 66]);
  });
});

describe('A text with more letters than registers', () => {
  /** From 50 on, a text of 14 letters; a number each in 60 to 65. */
  function longText() {
    const text = textRegisters(50, 'MBT0050-EN-3.0', 10);
    const target = createRegisterMachine([text, liveRegisters(60, 6, (offset) => 200 + offset)]);
    return (register: number, ...counts: number[]): number[] => {
      target.write(Uint8Array.of(register));
      return counts.flatMap((count) => [...target.read(count)]);
    };
  }
  const letters = [...new TextEncoder().encode('MBT0050-EN-3.0')];

  it('is read whole from its length or its first letter on, at once or byte by byte, and then come the registers behind', () => {
    const read = longText();
    expect(read(50, 17)).toEqual([14, ...letters, 205, 0]);
    expect(read(51, 14)).toEqual(letters);
    expect(read(51, ...Array<number>(15).fill(1))).toEqual([...letters, 205]);
  });

  it('leaves the registers over which it runs their own meaning when they are selected', () => {
    const read = longText();
    expect(read(60, 6)).toEqual([200, 201, 202, 203, 204, 205]);
    expect(read(64, 1)).toEqual([204]);
  });
});
