import type { Board } from '#board/board';
import type { Pin } from '#board/wires/pin';
import type { Level } from '#board/wires/wire';
import type { Stop } from '#core/stop';
import { entryOf, numberOf, textOf, wholeOf } from '../arguments';
import { pinsByNumber } from './pins';
import type { Machine, SyscallTable, Value, Wait } from '../syscall';

const TICKS_PERIOD = 0x40000000; // MicroPython extmod/modtime.c on 32 bits: ticks wrap at 2³⁰
const NO_NUMBER = -1;
/** Shorter pauses are spent at once; in longer ones the program can be suspended. Chosen: one ms. */
const SHORT_PAUSE_US = 1000;
const DAY_MS = 86_400_000;
const RUN_EVERY_GRID_US = 6000; // micropython-microbit-v2 main.cpp: timers are served every 6 ms

/**
 * Time on the simulated clock.
 *
 * - ticks_us(), ticks_ms() → wrap at 2³⁰ · running_time() → ms; all since the last reset
 * - sleep_us(us): without callbacks
 * - sleep_ms(ms), sleep_s(s) → 0 when slept to the end, −1 for no number and for negative numbers (a
 *   number of more than 32 bits may arrive as one), otherwise (a callback came in between) a moment for
 *   sleep_until(moment), which answers in the same way
 * - run_every(callback, days, ms): queues the callback on the 6 ms grid · run_every_stop(): ends all of them
 * - set_irq(on) → the previous value; while off no callback is queued
 * - pulse(n, level, timeoutUs): see `createPulseCalls`
 */
export function createTimeCalls(machine: Machine, board: Board): SyscallTable {
  return { ...clockCalls(machine, board), ...callbackCalls(machine), ...createPulseCalls(machine, board) };
}

const inUs = (ms: number | null): number | null => (ms === null ? null : ms * 1000);

function clockCalls(machine: Machine, board: Board): SyscallTable {
  const { clock } = machine;
  const { callUs } = board.type.costsUs;
  const runningUs = (): number => clock.nowUs - machine.startUs;
  const ms = (): number => Math.floor(runningUs() / 1000);
  const sleepUntil = (untilUs: number): Wait => ({
    untilUs,
    // As text: an int at the boundary has 32 bits, a float 24 of them, and a moment of long runs more.
    result: () => (clock.nowUs >= untilUs ? 0 : String(untilUs)),
  });
  const sleep = (us: number | null): Value | Wait => {
    machine.spend(callUs);
    if (us === null) return NO_NUMBER;
    if (us < 0) return NO_NUMBER;
    return us > 0 ? sleepUntil(clock.nowUs + us) : 0;
  };
  const whole = (value: Value | undefined): number | null => {
    const number = numberOf(value);
    return number === null ? null : Math.trunc(number);
  };
  return {
    ticks_us: () => {
      machine.spend(callUs);
      // Not a bit mask: the microseconds of two hours have more than 32 bits.
      return runningUs() % TICKS_PERIOD;
    },
    ticks_ms: () => {
      machine.spend(callUs);
      return ms() % TICKS_PERIOD;
    },
    running_time: () => {
      machine.spend(callUs);
      return ms();
    },
    sleep_ms: (value) => sleep(inUs(whole(value))),
    sleep_s: (value) => {
      const seconds = numberOf(value);
      // In single precision: 0.7 s are 700 ms, though the single next to 0.7 is a little less.
      return sleep(inUs(seconds === null ? null : Math.trunc(Math.fround(Math.fround(seconds) * 1000))));
    },
    sleep_us: (value) => {
      // A busy loop, during which no callback comes: mphalport.c, mp_hal_delay_us.
      const us = Math.max(whole(value) ?? 0, 0);
      machine.spend(callUs + Math.min(us, SHORT_PAUSE_US));
      if (us <= SHORT_PAUSE_US) return null;
      return { untilUs: clock.nowUs + us - SHORT_PAUSE_US, solid: true, result: () => null };
    },
    sleep_until: (moment) => sleepUntil(Number(textOf(moment))),
  };
}

function callbackCalls(machine: Machine): SyscallTable {
  const { clock } = machine;
  let isOn = true;
  let stops: Stop[] = [];
  machine.onEnd(() => stops.forEach((stop) => stop()));
  const repeat = (callback: number, periodUs: number): void => {
    // From whole ms on: drv_softtimer.c, with the board's own clock.
    let dueUs = clock.nowUs - ((clock.nowUs - machine.startUs) % 1000);
    let stop: Stop = () => undefined;
    const next = (): void => {
      dueUs += periodUs;
      const ticks = Math.max(Math.ceil(dueUs / RUN_EVERY_GRID_US), Math.floor(clock.nowUs / RUN_EVERY_GRID_US) + 1);
      stop = clock.at(ticks * RUN_EVERY_GRID_US, () => {
        if (isOn) machine.schedule(callback);
        next();
      });
    };
    next();
    stops.push(() => stop());
  };
  return {
    run_every: (callback, days, ms) => {
      repeat(wholeOf(callback) ?? 0, Math.max((wholeOf(days) ?? 0) * DAY_MS + (wholeOf(ms) ?? 0), 0) * 1000);
      return null;
    },
    run_every_stop: () => {
      for (const stop of stops) stop();
      stops = [];
      return null;
    },
    set_irq: (on) => {
      const before = isOn;
      isOn = wholeOf(on) !== 0;
      return before;
    },
  };
}

/** A current measurement. */
interface Pulse {
  /** Start of the present phase: waiting for the level, then measuring its length. */
  sinceUs: number;
  measuring: boolean;
  answer: number | null;
}

const TOO_LONG = -1;
const NEVER_BEGAN = -2;

/**
 * machine.time_pulse_us, exact to the µs: pulse(n, level, timeoutUs) → length of the pulse, −2 if it did not begin in
 * time, −1 if it did not end in time. A level that is already there counts as begun. It is a busy loop, during which no
 * callback comes. Source: MicroPython extmod/machine_pulse.c.
 */
function createPulseCalls(machine: Machine, board: Board): SyscallTable {
  const { clock } = machine;
  const { callUs } = board.type.costsUs;
  const pins = pinsByNumber(board);
  let stop: Stop = () => undefined; // nothing else runs during a measurement, so there is only one
  machine.onEnd(() => stop());
  const measure = (pin: Pin, wanted: Level, timeoutUs: number): Wait => {
    // The device also measures on a held pin.
    const level = pin.acquire('read_digital') === null ? pin.readDigital() : pin.wire.level;
    const pulse: Pulse = { sinceUs: clock.nowUs, measuring: level === wanted, answer: null };
    const endUs = (): number => pulse.sinceUs + timeoutUs; // later once the level has come
    const isOver = (): boolean => pulse.answer !== null || clock.nowUs >= endUs();
    stop = pin.wire.onLevel((now) => {
      if (isOver()) return;
      if (pulse.measuring && now !== wanted) pulse.answer = clock.nowUs - pulse.sinceUs;
      if (!pulse.measuring && now === wanted) {
        pulse.measuring = true;
        pulse.sinceUs = clock.nowUs;
      }
    });
    return {
      get untilUs() {
        return endUs();
      },
      solid: true,
      ready: isOver,
      result: () => {
        stop();
        return pulse.answer ?? (pulse.measuring ? TOO_LONG : NEVER_BEGAN);
      },
    };
  };
  return {
    pulse: (n, level, timeoutUs) => {
      machine.spend(callUs);
      const pin = entryOf(pins, n);
      return pin ? measure(pin, level === true ? 1 : 0, Math.max(wholeOf(timeoutUs) ?? 0, 0)) : NEVER_BEGAN;
    },
  };
}
