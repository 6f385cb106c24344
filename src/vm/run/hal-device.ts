import type { Board } from '#board/board';
import type { Rng } from '#core/rng';
import { textOf, wholeOf } from './arguments';
import type { Machine, SyscallTable } from './syscall';

const UNIQUE_ID_BYTES = 8; // micropython-microbit-v2 modmachine.c: two words of the chip's device number

/**
 * The rest of the board.
 *
 * - sensor(id) → its value (ids: board/sensors.ts) · unique_id(address): writes 8 bytes, the same for the same seed
 */
export function createDeviceCalls(machine: Machine, board: Board, rng: Rng): SyscallTable {
  const chance = rng.fork('unique-id');
  const uniqueId = Uint8Array.from({ length: UNIQUE_ID_BYTES }, () => chance.u32() & 0xff);
  const known = new Set(board.sensors.ids);
  return {
    sensor: (id) => {
      machine.spend(board.type.costsUs.callUs);
      return known.has(textOf(id)) ? board.sensors.get(textOf(id)) : null;
    },
    unique_id: (address) => {
      machine.spend(board.type.costsUs.callUs);
      machine.memory(wholeOf(address) ?? 0, UNIQUE_ID_BYTES).set(uniqueId);
      return null;
    },
  };
}
