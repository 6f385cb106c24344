import type { Board } from '#board/board';
import { wholeOf } from '../arguments';
import { pinsByNumber } from './pins';
import type { Machine, SyscallTable, Value } from '../syscall';

const OFF = -1;

/**
 * The SPI bus. A transfer costs its time on the bus; the bytes count as exchanged when it is over.
 *
 * - spi_hold(n) → None, or the mode that holds the pin · spi_init(clock, mosi, miso, Hz, mode): pins by number, held
 *   before
 * - spi_is_on() → bool
 * - spi_transfer(address to send, address to receive or 0, bytes) → 0 or −1 (off)
 */
export function createSpiCalls(machine: Machine, board: Board): SyscallTable {
  const { spi } = board;
  const { callUs } = board.type.costsUs;
  const pins = pinsByNumber(board);
  const at = (n: Value | undefined) => pins[wholeOf(n) ?? -1];
  return {
    spi_hold: (n) => at(n)?.acquire('spi') ?? null,
    spi_init: (clock, mosi, miso, hz, mode) => {
      machine.spend(callUs);
      const [clockPin, mosiPin, misoPin] = [at(clock), at(mosi), at(miso)];
      if (!clockPin || !mosiPin || !misoPin) return OFF;
      spi.init({ clock: clockPin, mosi: mosiPin, miso: misoPin }, wholeOf(hz) ?? 0, wholeOf(mode) ?? 0);
      return 0;
    },
    spi_is_on: () => spi.isOn,
    spi_transfer: (from, to, count) => {
      if (!spi.isOn) return OFF;
      const sent = machine.memory(wholeOf(from) ?? 0, wholeOf(count) ?? 0).slice();
      machine.spend(callUs + spi.transferUs(sent.length));
      const received = spi.transfer(sent);
      const target = wholeOf(to) ?? 0;
      if (target) machine.memory(target, received.length).set(received);
      return 0;
    },
  };
}
