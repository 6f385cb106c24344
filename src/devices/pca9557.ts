/**
 * PCA9557: eight pins behind I2C, read as one byte.
 *
 *      write  [command]         selects a register by the two lowest bits
 *      write  [command, data]   writes it
 *      read   n bytes           the same register n times; after a start the inputs
 *
 *      register  access  holds
 *      0         R       the pins; those that are inputs turned round where register 2 has a 1
 *      1         RW      levels of the pins that are outputs; at the start 0
 *      2         RW      inputs to be turned round; at the start 0xF0
 *      3         RW      1 = input; at the start 0xFF
 *
 * Source: NXP PCA9557 data sheet, 7.2 and 7.3; that a register stays selected: Texas Instruments PCA9557 data sheet,
 * "Control Register and Command Byte".
 */
import type { I2cTarget } from '#board/wires/i2c-bus';

const [INPUT, OUTPUT, POLARITY, CONFIGURATION] = [0, 1, 2, 3] as const;

/**
 * Makes the device.
 *
 * @param levels of what is connected to its pins, one per bit; asked for every byte that is read from register 0
 */
export function createPca9557(levels: () => number): I2cTarget {
  const registers = Uint8Array.of(0, 0x00, 0xf0, 0xff);
  const at = (register: number): number => registers[register] ?? 0;
  let selected = INPUT as number;
  const pins = (): number => {
    const inputs = at(CONFIGURATION);
    return ((levels() ^ at(POLARITY)) & inputs) | (at(OUTPUT) & ~inputs & 0xff);
  };
  return {
    write: ([command, ...data]) => {
      if (command === undefined) return; // an address probe
      selected = command & 3;
      for (const byte of data) if (selected !== INPUT) registers[selected] = byte;
    },
    read: (count) => Uint8Array.from({ length: count }, () => (selected === INPUT ? pins() : at(selected))),
  };
}
