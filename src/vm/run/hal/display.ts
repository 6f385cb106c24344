import type { Board } from '#board/board';
import { bytesOf } from '#board/display/glyph';
import { textOf, wholeOf } from '../arguments';
import type { Machine, SyscallTable, Value, Wait } from '../syscall';
import { pictureAt } from './image';

const SIDE = 5;
const LIT = 9;
const BAD_PLACE = -1;
const BAD_BRIGHTNESS = -2;

/**
 * The display. A picture is given by the address of its buffer (image.ts); pixels beyond 5 × 5 are cut off, missing
 * pixels are dark.
 *
 * - display_show_image(address): at once, and stays
 * - display_show_text(text, delayMs, loop, clear) → whether something moves now; one character that neither loops nor
 *   clears is shown at once, an empty text only ends what was moving
 * - display_begin(), then display_add_image(address), read whenever it is due, display_add_text(text) → False at a text of more or less than one byte, then display_run(delayMs, loop, clear, callback) → whether something moves now; a callback is queued when it has ended,
 *   unless something else has replaced it: display_moves_on() tells the callback whether that still holds
 * - display_turn() → which picture or animation this is, counted from the start
 * - display_scroll(text, delayMs, loop, monospace) · display_clear(): at the next tick · display_blank(): at once, and
 *   what moves goes on
 * - display_wait() waits until the present animation is over; callbacks wait, too, and a Ctrl-C ends it (drv_display.c,
 *   wait_for_event)
 * - display_set_pixel(x, y, value), display_get_pixel(x, y) → value, −1 (no such place), −2 (brightness)
 * - display_on() → None or the device's words · display_off() · display_is_on() → bool · display_rotate(quarterTurns)
 * - glyph(character, address): writes 25 pixels
 */
export function createDisplayCalls(machine: Machine, board: Board): SyscallTable {
  const stage = createStage(machine, board);
  return { ...atOnce(machine, board, stage), ...sequences(machine, board, stage), ...pixels(machine, board) };
}

/** Shared by the calls that show something. */
interface Stage {
  /** A new picture or animation replaces the previous one; costs the call. */
  readonly begin: () => void;
  /** Number of pictures and animations so far. */
  readonly turn: () => number;
  /** The pixels of an image, 5 × 5; valid until the image changes. */
  readonly image: (address: Value | undefined) => Uint8Array;
}

function createStage(machine: Machine, board: Board): Stage {
  let turn = 0;
  return {
    begin: () => {
      machine.spend(board.type.costsUs.showUs);
      turn++;
    },
    turn: () => turn,
    image: (address) => {
      const { width, height, pixels } = pictureAt(machine, address);
      return width === SIDE && height === SIDE ? pixels : cut(pixels, width, height);
    },
  };
}

function atOnce(machine: Machine, board: Board, stage: Stage): SyscallTable {
  const { display } = board;
  const show = (frame: Uint8Array): null => {
    stage.begin();
    display.show(frame);
    return null;
  };
  return {
    display_show_image: (address) => show(stage.image(address)),
    display_show_text: (text, delayMs, loop, clear) => {
      const given = textOf(text);
      if (given === '') {
        display.stopAnimation();
        return false;
      }
      const characters = given.length === 1 && given < '\x80' ? [given] : [...bytesOf(given)];
      if (characters.length === 1 && loop !== true && clear !== true) {
        show(display.glyph(given));
        return false;
      }
      stage.begin();
      const frames = characters.map((character) => display.glyph(character));
      display.showFrames(frames, { delayMs: wholeOf(delayMs) ?? 0, loop: loop === true, clear: clear === true });
      return display.isAnimating;
    },
    display_clear: () => {
      stage.begin();
      display.clear();
      return null;
    },
    display_blank: () => {
      machine.spend(board.type.costsUs.showUs);
      display.blank();
      return null;
    },
    display_wait: (): Wait => ({
      untilUs: display.isAnimating ? Infinity : machine.clock.nowUs,
      deaf: true,
      ready: () => !display.isAnimating,
      result: () => {
        display.stopAnimation();
        return null;
      },
    }),
  };
}

function sequences(machine: Machine, board: Board, stage: Stage): SyscallTable {
  const { display } = board;
  /** Each is read when it is due: images may change meanwhile. */
  let frames: (() => Uint8Array)[] = [];
  /** The animation whose end has queued a callback. */
  let dueAfter = -1;
  return {
    display_begin: () => {
      frames = [];
      display.stopAnimation();
      return null;
    },
    display_add_image: (address) => {
      frames.push(() => stage.image(address));
      return null;
    },
    display_add_text: (text) => {
      const [character = '', ...more] = bytesOf(textOf(text));
      if (character === '' || more.length > 0) return false;
      frames.push(() => display.glyph(character));
      return true;
    },
    display_run: (delayMs, loop, clear, callback) => {
      stage.begin();
      const next = wholeOf(callback) ?? -1;
      const turn = stage.turn();
      const film = frames;
      const frameAt = (place: number): Uint8Array => film[place]?.() ?? new Uint8Array(SIDE * SIDE);
      display.showFilm(
        { length: film.length, frameAt },
        {
          delayMs: wholeOf(delayMs) ?? 0,
          loop: loop === true,
          clear: clear === true,
          onOver: () => {
            if (next < 0) return;
            dueAfter = turn;
            machine.schedule(next);
          },
        },
      );
      frames = [];
      return display.isAnimating;
    },
    display_turn: () => stage.turn(),
    display_moves_on: () => stage.turn() === dueAfter,
    display_scroll: (text, delayMs, loop, monospace) => {
      stage.begin();
      const options = { delayMs: wholeOf(delayMs) ?? 0, loop: loop === true, monospace: monospace === true };
      display.scroll(textOf(text), options);
      return null;
    },
  };
}

function pixels(machine: Machine, board: Board): SyscallTable {
  const { display } = board;
  const { callUs } = board.type.costsUs;
  const isInside = (x: Value | undefined, y: Value | undefined): boolean =>
    Number(x) >= 0 && Number(x) < SIDE && Number(y) >= 0 && Number(y) < SIDE;
  return {
    display_set_pixel: (x, y, value) => {
      machine.spend(callUs);
      if (!isInside(x, y)) return BAD_PLACE;
      const brightness = Number(value);
      if (!(brightness >= 0 && brightness <= LIT)) return BAD_BRIGHTNESS;
      display.setPixel(Number(x), Number(y), brightness);
      return 0;
    },
    display_get_pixel: (x, y) => {
      machine.spend(callUs);
      return isInside(x, y) ? display.getPixel(Number(x), Number(y)) : BAD_PLACE;
    },
    display_on: () => {
      machine.spend(callUs);
      return display.on();
    },
    display_off: () => {
      machine.spend(callUs);
      display.off();
      return null;
    },
    display_rotate: (quarterTurns) => {
      machine.spend(callUs);
      display.rotate(wholeOf(quarterTurns) ?? 0);
      return null;
    },
    display_is_on: () => {
      machine.spend(callUs);
      return display.isOn;
    },
    glyph: (character, address) => {
      machine.memory(wholeOf(address) ?? 0, SIDE * SIDE).set(display.glyph(textOf(character)));
      return null;
    },
  };
}

function cut(pixels: Uint8Array, width: number, height: number): Uint8Array {
  const frame = new Uint8Array(SIDE * SIDE);
  for (let y = 0; y < Math.min(height, SIDE); y++) {
    frame.set(pixels.subarray(y * width, y * width + Math.min(width, SIDE)), y * SIDE);
  }
  return frame;
}
