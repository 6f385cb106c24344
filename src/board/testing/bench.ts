import { Clock } from '#core/clock';
import { Board } from '../board';
import type { BoardType, FirmwareType } from '../boards/board-type';
import { microbitV2 } from '../boards/microbit-v2';
import type { WireEnd } from '../wires/wire';

/** A board on the table, without a program: a test drives its pins, presses its buttons and lets time pass. */
export interface Bench {
  readonly clock: Clock;
  readonly board: Board;
  /** Milliseconds since the start. */
  readonly nowMs: number;
  /** Lets time pass. */
  readonly passMs: (ms: number) => void;
  readonly passUs: (us: number) => void;
  /**
   * Lets time pass until a condition holds, and returns the ms since the start. It checks after every alarm.
   *
   * @throws Error if it still does not hold after `limitMs`
   */
  readonly waitUntil: (isSo: () => boolean, limitMs?: number) => number;
  /** Something outside that is connected to a wire. */
  readonly chip: (wire: string) => WireEnd;
  /** Logs what happens on a wire from now on: `['2 ms: 1', '5 ms: 0']`. */
  readonly record: (wire: string) => readonly string[];
  /** The picture on the LEDs, `.` for dark: `'.9.9.\n99999\n…'`. */
  readonly picture: () => string;
}

/** Puts a board on the table. */
export function createBench(type: BoardType = microbitV2, firmware?: FirmwareType): Bench {
  const clock = new Clock();
  const board = new Board(type, clock, firmware);
  return {
    clock,
    board,
    get nowMs() {
      return clock.nowUs / 1000;
    },
    passMs: (ms) => clock.advanceTo(clock.nowUs + ms * 1000),
    passUs: (us) => clock.advanceTo(clock.nowUs + us),
    waitUntil: (isSo, limitMs = 60_000) => waitUntil(clock, isSo, limitMs),
    chip: (wire) => board.wire(wire).connect('chip'),
    record: (wire) => record(board, wire),
    picture: () => pictureOf(board.display.pixels),
  };
}

function waitUntil(clock: Clock, isSo: () => boolean, limitMs: number): number {
  const limitUs = clock.nowUs + limitMs * 1000;
  while (!isSo()) {
    if (clock.nextAlarmUs > limitUs) throw new Error(`It did not come about within ${limitMs} ms.`);
    clock.advanceTo(clock.nextAlarmUs);
  }
  return clock.nowUs / 1000;
}

function record(board: Board, name: string): readonly string[] {
  const lines: string[] = [];
  const note = (what: string): void => void lines.push(`${board.clock.nowUs / 1000} ms: ${what}`);
  const wire = board.wire(name);
  wire.onLevel((level) => note(String(level)));
  wire.onPwm((pwm) => note(pwm ? `${pwm.dutyFraction * pwm.periodUs} of ${pwm.periodUs} µs high` : 'no PWM'));
  return lines;
}

function pictureOf(pixels: Uint8Array): string {
  const digits = [...pixels].map((value) => (value === 0 ? '.' : String(value))).join('');
  return digits.replaceAll(/.{5}(?!$)/g, '$&\n');
}
