/**
 * An I2C EEPROM with two address bytes, such as the 24LC32.
 *
 *      write  [high, low]          selects a place
 *      write  [high, low, data …]  writes from there on, within one page
 *      read   n bytes              from the selected place on; the selection moves along and wraps
 *
 * Source: Microchip 24LC32A data sheet, "Page Write" and "Sequential Read". Simplified: a write takes no time, where the
 * chip does not answer for up to 5 ms.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';

/** Bytes in it, and in one page: 24LC32A. */
export const EEPROM_BYTES = 4096;
export const EEPROM_PAGE_BYTES = 32;

/** Makes the device, full of zeros. */
export function createEeprom(): I2cTarget {
  const bytes = new Uint8Array(EEPROM_BYTES);
  let selected = 0;
  return {
    write: ([high, low, ...data]) => {
      if (high === undefined || low === undefined) return;
      const address = ((high << 8) | low) % EEPROM_BYTES;
      const page = address - (address % EEPROM_PAGE_BYTES);
      data.forEach((byte, i) => (bytes[page + ((address - page + i) % EEPROM_PAGE_BYTES)] = byte));
      selected = page + ((address - page + data.length) % EEPROM_PAGE_BYTES);
    },
    read: (count) =>
      Uint8Array.from({ length: count }, () => {
        const byte = bytes[selected] ?? 0;
        selected = (selected + 1) % EEPROM_BYTES;
        return byte;
      }),
  };
}
