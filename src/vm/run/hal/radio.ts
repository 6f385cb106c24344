import type { Board } from '#board/board';
import type { RadioConfig, RadioMessage } from '#board/radio';
import { textOf, wholeOf } from '../arguments';
import type { Machine, Syscall, SyscallTable } from '../syscall';

const NOTHING_WAITS = -1;
const OFF = -2;
const UNKNOWN = -1;
const OUT_OF_RANGE = -2;
const TICKS_MASK = 0x3fffffff; // MicroPython on 32 bits: ticks wrap at 2³⁰

/** modradio.c, mod_radio_config; the highest power is 7 as documented (8 in that code). */
const LIMITS: Readonly<Record<string, readonly [setting: keyof RadioConfig, min: number, max: number]>> = {
  length: ['length', 1, 251],
  queue: ['queue', 1, 254],
  channel: ['channel', 0, 83],
  power: ['power', 0, 7],
  data_rate: ['dataRate', 0, 2],
  address: ['address', -0x80000000, 0xffffffff],
  group: ['group', 0, 255],
};

/**
 * The radio.
 *
 * - radio_on(), radio_off(), radio_forget() · radio_is_on() · radio_buffer() → bytes the device takes from the heap
 * - radio_set(name, value) → 0, −1 unknown, −2 out of range; nothing changes before radio_apply(); radio_discard()
 * - radio_send(address, length) → False while it is off
 * - radio_waiting() → length of the oldest message, −1 none, −2 off
 * - radio_take(address, room) → takes the oldest message; its length; −1 if there is none or it does not fit
 * - radio_rssi(), radio_time() → of the message taken last: dBm, µs · radio_copy(to, from, bytes)
 */
export function createRadioCalls(machine: Machine, board: Board): SyscallTable {
  const { radio } = board;
  const { callUs, radioPacketUs } = board.type.costsUs;
  let last: RadioMessage | null = null;
  const plain = (act: () => void): Syscall => {
    return () => {
      machine.spend(callUs);
      act();
      return null;
    };
  };
  return {
    radio_on: plain(() => radio.on()),
    radio_off: plain(() => radio.off()),
    radio_forget: plain(() => radio.forget()),
    radio_is_on: () => radio.isOn,
    radio_buffer: () => radio.bufferBytes,
    ...configCalls(machine, board),
    radio_send: (address, length) => {
      machine.spend(callUs);
      if (!radio.isOn) return false;
      const bytes = machine.memory(wholeOf(address) ?? 0, wholeOf(length) ?? 0).slice();
      machine.spend(radioPacketUs);
      radio.send(bytes);
      return true;
    },
    radio_waiting: () => {
      machine.spend(callUs);
      if (!radio.isOn) return OFF;
      return radio.oldest?.bytes.length ?? NOTHING_WAITS;
    },
    radio_take: (address, room) => {
      const message = radio.oldest;
      if (!message || message.bytes.length > (wholeOf(room) ?? 0)) return NOTHING_WAITS;
      last = radio.take();
      machine.memory(wholeOf(address) ?? 0, message.bytes.length).set(message.bytes);
      return message.bytes.length;
    },
    radio_copy: (to, from, length) => {
      const bytes = wholeOf(length) ?? 0;
      machine.memory(wholeOf(to) ?? 0, bytes).set(machine.memory(wholeOf(from) ?? 0, bytes));
      return null;
    },
    radio_rssi: () => last?.rssiDbm ?? 0,
    radio_time: () => Math.max(0, (last?.timeUs ?? 0) - machine.startUs) & TICKS_MASK,
  };
}

function configCalls(machine: Machine, board: Board): SyscallTable {
  const { radio } = board;
  let changes: { -readonly [K in keyof RadioConfig]?: number } = {};
  return {
    radio_set: (name, value) => {
      const limit = Object.hasOwn(LIMITS, textOf(name)) ? LIMITS[textOf(name)] : undefined;
      if (!limit) return UNKNOWN;
      const [setting, min, max] = limit;
      const number = wholeOf(value) ?? NaN;
      if (!(number >= min && number <= max)) return OUT_OF_RANGE;
      changes[setting] = setting === 'address' ? number >>> 0 : number;
      return 0;
    },
    radio_apply: () => {
      machine.spend(board.type.costsUs.callUs);
      radio.configure(changes);
      changes = {};
      return null;
    },
    radio_discard: () => {
      changes = {};
      return null;
    },
  };
}
