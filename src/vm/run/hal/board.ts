import type { Board } from '#board/board';
import type { Pin } from '#board/wires/pin';
import { entryOf, ownOf, textOf } from '../arguments';
import type { SyscallTable } from '../syscall';

/** Python names of the classes of pins: micropython-microbit-v2 microbit_pin.c. */
type PinClass = 'touch' | 'analog' | 'digital' | 'touch-only';

/**
 * Describes the board, so that the library can build its modules. None of these calls costs time.
 *
 * - board_module(i) → the i-th Python name of the board's module, None after the last
 * - board_pin(i) → "name number class" of the i-th pin (class: touch, analog, digital, touch-only), None after the last
 * - board_role(role) → the number of the pin for `scl`, `sda`, `rgb`, −1 for none
 * - board_rgb_count() → RGB LEDs soldered to the board
 * - board_has(feature or change) → bool · board_text(what) → banner, sysname, nodename, release, version, machine, sysVersion
 * - board_micropython(i) → part i of MicroPython's version
 */
export function createBoardCalls(board: Board): SyscallTable {
  const { type, firmware } = board;
  const pins = [...board.pins.values()];
  const texts: Readonly<Record<string, string>> = {
    ...firmware.uname,
    banner: firmware.banner,
    sysVersion: firmware.sysVersion,
  };
  const features: readonly string[] = [...firmware.features, ...firmware.changes];
  const roles: Readonly<Record<string, string | undefined>> = {
    scl: type.i2c.scl,
    sda: type.i2c.sda,
    rgb: type.rgb?.pin,
  };
  return {
    board_module: (place) => entryOf(type.modules, place) ?? null,
    board_pin: (place) => {
      const pin = entryOf(pins, place);
      return pin ? `${pin.name} ${pin.number} ${classOf(pin)}` : null;
    },
    board_role: (role) => {
      const name = ownOf(roles, role);
      return name === undefined ? -1 : board.pin(name).number;
    },
    board_rgb_count: () => type.rgb?.count ?? 0,
    board_has: (feature) => features.includes(textOf(feature)),
    board_text: (what) => ownOf(texts, what) ?? '',
    board_micropython: (place) => entryOf(firmware.micropython, place) ?? 0,
  };
}

function classOf(pin: Pin): PinClass {
  const { digital, analog, touch } = pin.type;
  if (!digital) return 'touch-only';
  if (touch !== null) return 'touch';
  return analog ? 'analog' : 'digital';
}
