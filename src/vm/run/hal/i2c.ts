import type { Board } from '#board/board';
import type { Pin } from '#board/wires/pin';
import { Errno, wholeOf } from '../arguments';
import { pinsByNumber } from './pins';
import type { Machine, SyscallTable, Value } from '../syscall';

const ADDRESS_MASK = 0x7f; // microbit_i2c.c hands on address << 1 in a byte
const LAST_ADDRESS = 0x77; // microbit_i2c.c: 0x78 … 0x7f are reserved

/**
 * The I2C bus. A transfer costs its time on the bus; the bytes count as received when it is over.
 *
 * - i2c_write(chip, address, bytes), i2c_read(chip, address, bytes) → 0 or −ENODEV (no chip answers)
 * - i2c_next(chip) → the next address after this one that answers, −1 for none
 * - i2c_init(Hz, scl, sda): pins by number
 */
export function createI2cCalls(machine: Machine, board: Board): SyscallTable {
  const { i2c } = board;
  const chipOf = (value: Value | undefined): number | null => {
    const whole = wholeOf(value);
    return whole === null ? null : whole & ADDRESS_MASK;
  };
  const pins = pinsByNumber(board);
  // Needs no mode and changes none, as on the device; the pins are pulled up (codal-nrf52 NRF52I2C.cpp).
  const useWires = (scl: Pin | undefined, sda: Pin | undefined): void => {
    if (!scl || !sda) return;
    if (scl.name === board.type.i2c.scl && sda.name === board.type.i2c.sda) return i2c.useWires(null);
    scl.holdInput('up');
    sda.holdInput('up');
    i2c.useWires({ scl: scl.wire, sda: sda.wire });
  };
  return {
    i2c_write: (chip, address, count) => {
      const to = chipOf(chip);
      if (to === null) return -Errno.ENODEV;
      const bytes = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0).slice();
      machine.spend(i2c.writeUs(to, bytes.length));
      return i2c.write(to, bytes).acknowledged ? 0 : -Errno.ENODEV;
    },
    i2c_read: (chip, address, count) => {
      const from = chipOf(chip);
      if (from === null) return -Errno.ENODEV;
      const target = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0);
      const { length } = target;
      machine.spend(i2c.readUs(from, length));
      const { acknowledged, bytes } = i2c.read(from, length);
      if (!acknowledged) return -Errno.ENODEV;
      target.set(bytes);
      return 0;
    },
    i2c_next: (after) => {
      for (let chip = Math.max(wholeOf(after) ?? 0, 0) + 1; chip <= LAST_ADDRESS; chip++) {
        machine.spend(i2c.writeUs(chip, 0));
        if (i2c.write(chip, new Uint8Array(0)).acknowledged) return chip;
      }
      return -1;
    },
    i2c_init: (hz, scl, sda) => {
      machine.spend(board.type.costsUs.callUs);
      useWires(pins[wholeOf(scl) ?? -1], pins[wholeOf(sda) ?? -1]);
      i2c.setFrequency(wholeOf(hz) ?? board.type.i2c.frequencyHz);
      return null;
    },
  };
}
