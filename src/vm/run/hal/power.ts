import type { Board } from '#board/board';
import type { Button } from '#board/sensors/button';
import type { Pin } from '#board/wires/pin';
import type { WakeSource } from '#board/power';
import { wholeOf } from '../arguments';
import type { ConsolePort } from '../console-port';
import { pinsByNumber } from './pins';
import type { Machine, SyscallTable, Wait } from '../syscall';

const CALLBACK_CAME = -1;
const TIME_IS_OVER = 0;
const WOKEN = 1;

/**
 * Deep sleep and off.
 *
 * - power_off() never comes back
 * - power_wake_clear(), power_wake_pin(n), power_wake_button(n): what will wake the board
 * - power_sleep(seconds, ms), without arguments: without end → 0 when the time is over, 1 when it was woken (by a source or by a byte from the computer), −1 if a callback came in
 *   between; power_sleep_on() answers in the same way
 */
export function createPowerCalls(machine: Machine, board: Board, port: ConsolePort): SyscallTable {
  const { power } = board;
  const { clock } = machine;
  const { callUs } = board.type.costsUs;
  const pins = pinsByNumber(board);
  const buttons = [board.buttonA, board.buttonB];
  let sources: WakeSource[] = [];
  let untilUs = Infinity;
  const sleep = (): Wait => {
    const wants = power.sleep([...sources, serialSource(port)]);
    let woken = false;
    const isOver = (): boolean => (woken ||= wants()) || clock.nowUs >= untilUs;
    return {
      untilUs: isOver() ? clock.nowUs : untilUs,
      ready: isOver,
      result: () => {
        const over = isOver();
        power.wake();
        if (!over) return CALLBACK_CAME;
        return woken ? WOKEN : TIME_IS_OVER;
      },
    };
  };
  return {
    power_off: (): Wait => {
      hush(board);
      board.radio.off();
      power.off();
      return { untilUs: Infinity, result: () => null };
    },
    power_wake_clear: () => {
      sources = [];
      return null;
    },
    power_wake_pin: (n) => {
      const pin = pins[wholeOf(n) ?? -1];
      if (pin) sources.push(pinSource(board, pin));
      return null;
    },
    power_wake_button: (n) => {
      const button = buttons[wholeOf(n) ?? -1];
      if (button) sources.push(buttonSource(button));
      return null;
    },
    power_sleep: (seconds, ms) => {
      machine.spend(callUs);
      const duration = (wholeOf(seconds) ?? Infinity) * 1000 + (wholeOf(ms) ?? 0);
      untilUs = clock.nowUs + duration * 1000;
      hush(board);
      return sleep();
    },
    power_sleep_on: () => sleep(),
  };
}

/** Asleep, the board makes no sound. */
function hush({ music, sound }: Board): void {
  music.stop();
  for (const source of ['effect', 'samples', 'speech'] as const) sound.silence(source);
}

/** A byte from the computer wakes the board: the chip behind the USB socket does so (codal-microbit-v2 v0.2.43 on). */
function serialSource(port: ConsolePort): WakeSource {
  return {
    arm: () => {
      const { received } = port;
      return () => port.received > received;
    },
  };
}

/** A button wakes the board while it is down, so a held button does not let it fall asleep. */
function buttonSource(button: Button): WakeSource {
  return { arm: () => () => button.isDown };
}

/** A pin wakes the board when its level changes or a finger touches it (chosen: the device uses one of the edges). */
function pinSource(board: Board, pin: Pin): WakeSource {
  const pad = board.touch.get(pin.type.name);
  return {
    arm: () => {
      const level = pin.wire.level;
      const finger = pad?.isDown ?? false;
      return () => pin.wire.level !== level || (!finger && (pad?.isDown ?? false));
    },
  };
}
