import type { Board } from '#board/board';
import type { Rng } from '#core/rng';
import { numberOf, wholeOf } from '../arguments';
import type { Machine, SyscallTable } from '../syscall';

const UNIQUE_ID_BYTES = 8; // micropython-microbit-v2 modmachine.c: two words of the chip's device number

const DEVICE_ID = 0x1000_0060;
/** nRF52833 product specification, FICR: the chip's data about itself, on both boards. */
const CHIP_WORDS: readonly (readonly [address: number, word: number])[] = [
  [0x1000_0010, 0x1000], // CODEPAGESIZE: bytes in a page of flash
  [0x1000_0014, 0x80], // CODESIZE: pages
  [0x1000_0100, 0x52833], // INFO.PART
  [0x1000_010c, 0x80], // INFO.RAM: kB
  [0x1000_0110, 0x200], // INFO.FLASH: kB
];

const wordOf = (bytes: Uint8Array, from: number): number => new DataView(bytes.buffer).getInt32(from, true);

/**
 * The rest of the board.
 *
 * - spend_scale(), spend_neopixel(): the cost of what the library does in Python, and the board in C or in Python of its
 *   own
 * - retype(object, type), given by their addresses: bytes become a str, which lies in memory in the same way (py/objstr.h)
 * - unique_id(address): writes 8 bytes, the same for the same seed
 * - chip_word(address) → the word of the chip's memory there as an int of 32 bits, None if it is not simulated
 */
export function createDeviceCalls(machine: Machine, board: Board, rng: Rng): SyscallTable {
  const chance = rng.fork('unique-id');
  const uniqueId = Uint8Array.from({ length: UNIQUE_ID_BYTES }, () => chance.u32() & 0xff);
  const chip: ReadonlyMap<number, number> = new Map([
    ...CHIP_WORDS,
    [DEVICE_ID, wordOf(uniqueId, 0)],
    [DEVICE_ID + 4, wordOf(uniqueId, 4)],
  ]);
  const { callUs, scaleUs, neopixelUs } = board.type.costsUs;
  return {
    spend_scale: () => {
      machine.spend(scaleUs);
      return null;
    },
    spend_neopixel: () => {
      machine.spend(neopixelUs);
      return null;
    },
    chip_word: (address) => {
      machine.spend(callUs);
      return chip.get(numberOf(address) ?? -1) ?? null;
    },
    retype: (object, type) => {
      const word = machine.memory(wholeOf(object) ?? 0, 4);
      new DataView(word.buffer, word.byteOffset).setInt32(0, wholeOf(type) ?? 0, true);
      return null;
    },
    unique_id: (address) => {
      machine.spend(callUs);
      machine.memory(wholeOf(address) ?? 0, UNIQUE_ID_BYTES).set(uniqueId);
      return null;
    },
  };
}
