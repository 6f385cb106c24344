import { describe, expect, it } from 'vitest';
import { createPca9557 } from './pca9557';

/** The expander with these levels at its pins. */
function expander(levels = 0b1010_0001) {
  const chip = createPca9557(() => levels);
  const write = (...bytes: readonly number[]) => chip.write(Uint8Array.from(bytes));
  return { write, read: (count: number) => [...chip.read(count)] };
}

describe('PCA9557', () => {
  it('gives its pins to who only reads, the upper four turned round (register 2 starts with 0xF0)', () => {
    expect(expander().read(1)).toEqual([0b0101_0001]);
  });

  it('gives them again for every further byte: no register follows by itself', () => {
    expect(expander().read(3)).toEqual([0x51, 0x51, 0x51]);
  });

  it.each([
    [1, 0x00],
    [2, 0xf0],
    [3, 0xff],
  ])('starts with register %i = 0x%s', (register, value) => {
    const { write, read } = expander();
    write(register);
    expect(read(1)).toEqual([value]);
  });

  it('turns no pin round once register 2 is 0, and stays at the register that was named last', () => {
    const { write, read } = expander();
    write(2, 0);
    expect(read(1)).toEqual([0]);
    write(0);
    expect(read(1)).toEqual([0b1010_0001]);
  });

  it('gives the output level of a pin that was made an output, not turned round', () => {
    const { write, read } = expander();
    write(3, 0x7f);
    write(1, 0x80);
    write(0);
    expect(read(1)).toEqual([0b1101_0001]);
  });

  it('ignores a write to its inputs and an empty one, and looks at two bits of the command', () => {
    const { write, read } = expander();
    write(0, 0xff);
    write();
    write(0xfc);
    expect(read(1)).toEqual([0x51]);
  });
});
