import type { Board } from '#board/board';
import type { PinMode } from '#board/boards/board-type';
import type { Pin } from '#board/wires/pin';
import type { Pull } from '#board/wires/wire';
import { entryOf, numberOf, wholeOf } from '../arguments';
import type { Machine, SyscallTable, Value } from '../syscall';

const HELD = -1;
const OUT_OF_RANGE = -2;
const NO_NUMBER = -3;
const ANALOG_MAX = 1023; // microbit_pin.c: microbit_pin_write_analog
const MODES: readonly PinMode[] = [
  ...(['unused', 'read_digital', 'write_digital', 'write_analog', 'touch', 'music', 'audio'] as const),
  ...(['display', 'button', 'i2c', 'spi'] as const),
];
/** PULL_UP, PULL_DOWN, NO_PULL: microbithal.h. */
const PULLS: readonly Pull[] = ['up', 'down', 'none'];

/** The pins of a board by the numbers of the device (0 … 20, 30 the logo, 31 the speaker). */
export function pinsByNumber(board: Board): readonly (Pin | undefined)[] {
  const pins: Pin[] = [];
  for (const pin of board.pins.values()) pins[pin.number] = pin;
  return pins;
}

/**
 * Pins, touch pads and buttons. Pins are given by their numbers.
 *
 * - pin_read(n) → 0, 1 or −1 (held) · pin_write(n, level) → 0, −1 (held), −2 (not 0 or 1)
 * - pin_read_analog(n) → 0 … 1023 or −1 · pin_write_analog(n, value) → 0, −1, −2 (not 0 … 1023), −3 (no number)
 * - pin_modes() → the modes' names, separated by blanks · pin_mode(n) → text, pin_mode_place(n) → its place among them · pin_pull(n) → 0 up, 1 down, 2 none, or −1 · pin_set_pull(n, pull) → 0 or −1
 * - pin_period(n) → µs or −1 (no analog output) · pin_set_period(n, us): one that the hardware cannot do changes nothing, and the device says nothing
 * - touch_is(n), touch_was(n) → bool or None (held) · touch_count(n) → count or −1 · touch_set_kind(n, kind) → 0 or −1
 * - button_is(i), button_was(i) → bool · button_presses(i) → count; i: 0 is A, 1 is B
 * - ws2812_write(n, address, bytes)
 */
export function createPinCalls(machine: Machine, board: Board): SyscallTable {
  return {
    ...digital(machine, board),
    ...analog(machine, board),
    ...fingers(machine, board),
    ...stream(machine, board),
  };
}

function digital(machine: Machine, board: Board): SyscallTable {
  const pins = pinsByNumber(board);
  const { callUs } = board.type.costsUs;
  const at = (n: Value | undefined): Pin | undefined => entryOf(pins, n);
  return {
    pin_read: (n) => {
      machine.spend(callUs);
      const pin = at(n);
      if (!pin || pin.acquire('read_digital') !== null) return HELD;
      return pin.readDigital();
    },
    pin_write: (n, level) => {
      machine.spend(callUs);
      if (level !== 0 && level !== 1) return OUT_OF_RANGE;
      const pin = at(n);
      if (!pin || pin.acquire('write_digital') !== null) return HELD;
      pin.writeDigital(level);
      return 0;
    },
    pin_mode: (n) => {
      machine.spend(callUs);
      return at(n)?.mode ?? 'unused';
    },
    pin_mode_place: (n) => {
      machine.spend(callUs);
      return MODES.indexOf(at(n)?.mode ?? 'unused');
    },
    pin_modes: () => MODES.join(' '),
    pin_pull: (n) => {
      machine.spend(callUs);
      const pin = at(n);
      if (!pin || (pin.mode !== 'read_digital' && pin.mode !== 'button')) return HELD;
      return PULLS.indexOf(pin.reportedPull);
    },
    pin_set_pull: (n, value) => {
      machine.spend(callUs);
      const pin = at(n);
      if (!pin || pin.acquire('read_digital') !== null) return HELD;
      const pull = PULLS[wholeOf(value) ?? -1];
      if (pull) pin.setPull(pull);
      return 0;
    },
  };
}

function analog(machine: Machine, board: Board): SyscallTable {
  const pins = pinsByNumber(board);
  const { callUs, analogReadUs } = board.type.costsUs;
  const at = (n: Value | undefined): Pin | undefined => entryOf(pins, n);
  return {
    pin_read_analog: (n) => {
      machine.spend(analogReadUs);
      const pin = at(n);
      if (!pin || pin.acquire('unused') !== null) return HELD;
      return pin.readAnalog();
    },
    pin_write_analog: (n, value) => {
      machine.spend(callUs);
      const given = numberOf(value);
      if (given === null) return NO_NUMBER;
      const whole = Number.isInteger(given) ? given : Math.trunc(given + 0.5);
      if (whole < 0 || whole > ANALOG_MAX) return OUT_OF_RANGE;
      const pin = at(n);
      if (!pin || pin.acquire('write_analog') !== null) return HELD;
      pin.writeAnalog(whole);
      return 0;
    },
    pin_period: (n) => {
      machine.spend(callUs);
      return at(n)?.analogPeriodUs ?? -1;
    },
    pin_set_period: (n, us) => {
      machine.spend(callUs);
      at(n)?.setAnalogPeriodUs(wholeOf(us) ?? 0);
      return null;
    },
  };
}

function fingers(machine: Machine, board: Board): SyscallTable {
  const { callUs } = board.type.costsUs;
  const pads = new Map([...board.touch.values()].map((pad) => [pad.pin.number, pad]));
  const padAt = (n: Value | undefined) => pads.get(wholeOf(n) ?? -1);
  const button = (i: Value | undefined) => (i === 1 ? board.buttonB : board.buttonA);
  // Like the device: a pad in button mode is read without being taken.
  const isHeld = (pin: Pin): boolean => pin.mode !== 'button' && pin.acquire('touch') !== null;
  return {
    touch_is: (n) => {
      machine.spend(callUs);
      const pad = padAt(n);
      return !pad || isHeld(pad.pin) ? null : pad.isTouched();
    },
    touch_set_kind: (n, kind) => {
      machine.spend(callUs);
      const pad = padAt(n);
      if (!pad || isHeld(pad.pin)) return HELD;
      pad.kind = kind === 0 ? 'resistive' : 'capacitive';
      return 0;
    },
    touch_was: (n) => {
      machine.spend(callUs);
      const pad = padAt(n);
      if (!pad || isHeld(pad.pin)) return null;
      pad.isTouched();
      return pad.wasTouched();
    },
    touch_count: (n) => {
      machine.spend(callUs);
      const pad = padAt(n);
      if (!pad || isHeld(pad.pin)) return HELD;
      pad.isTouched();
      return pad.takeTouches();
    },
    button_is: (i) => {
      machine.spend(callUs);
      return button(i).isPressed();
    },
    button_was: (i) => {
      machine.spend(callUs);
      return button(i).wasPressed();
    },
    button_presses: (i) => {
      machine.spend(callUs);
      return button(i).takePresses();
    },
  };
}

function stream(machine: Machine, board: Board): SyscallTable {
  const pins = pinsByNumber(board);
  const { ws2812ByteUs, ws2812SetupUs } = board.type.costsUs;
  return {
    ws2812_write: (n, address, count) => {
      const bytes = machine.memory(wholeOf(address) ?? 0, wholeOf(count) ?? 0).slice();
      machine.spend(Math.round(ws2812SetupUs + ws2812ByteUs * bytes.length));
      entryOf(pins, n)?.sendStream(bytes);
      return null;
    },
  };
}
