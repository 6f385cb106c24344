import { describe, expect, it } from 'vitest';
import { createEeprom } from './eeprom';

function eeprom() {
  const chip = createEeprom();
  const write = (...bytes: readonly number[]) => chip.write(Uint8Array.from(bytes));
  const readFrom = (address: number, count: number) => {
    write(address >> 8, address & 0xff);
    return [...chip.read(count)];
  };
  return { write, readFrom, read: (count: number) => [...chip.read(count)] };
}

describe('an EEPROM', () => {
  it('is full of zeros at first', () => expect(eeprom().readFrom(0, 3)).toEqual([0, 0, 0]));

  it('keeps bytes at a place of two bytes and gives them one after the other', () => {
    const { write, readFrom, read } = eeprom();
    write(0x01, 0x02, 7, 8);
    expect(readFrom(0x0102, 1)).toEqual([7]);
    expect(read(1)).toEqual([8]);
  });

  it('goes on at the beginning of the page of 32 bytes when a write passes its end', () => {
    const { write, readFrom } = eeprom();
    write(0, 31, 1, 2);
    expect(readFrom(31, 2)).toEqual([1, 0]);
    expect(readFrom(0, 1)).toEqual([2]);
  });

  it('reads on from the first byte behind the last one, number 4095', () => {
    const { write, readFrom } = eeprom();
    write(0, 0, 5);
    expect(readFrom(4095, 2)).toEqual([0, 5]);
  });

  it('ignores half an address', () => {
    const { write, readFrom } = eeprom();
    write(0, 0, 5);
    write(0);
    expect(readFrom(0, 1)).toEqual([5]);
  });
});
