import type { Board } from '#board/board';
import { textOf, wholeOf } from './arguments';
import type { Machine, SyscallTable, Value, Wait } from './syscall';

const SIDE = 5;
const LIT = 9;
const BAD_PLACE = -1;
const BAD_BRIGHTNESS = -2;

/**
 * The display. A picture is given as 25 bits (the built-in images: first row in the highest bits, lit means 9) or as
 * the address of its pixels, its width and height; what lies beyond 5 × 5 is cut off, what is missing is dark.
 *
 * - display_show_bits(bits), display_show_image(address, w, h): at once, and stay
 * - display_show_text(text, delayMs, loop, clear) → whether something moves now; one character that neither loops nor
 *   clears is shown at once, no text at all only ends what was moving
 * - display_begin(), then display_add_bits(bits), display_add_image(address, w, h), display_add_text(text), then
 *   display_run(delayMs, loop, clear) → whether something moves now
 * - display_scroll(text, delayMs, loop, monospace) · display_clear()
 * - display_busy() waits until the animation of now is over or replaced → True when a callback came in between
 * - display_set_pixel(x, y, value), display_get_pixel(x, y) → value, −1 (no such place), −2 (brightness)
 * - display_on() → None or the device's words · display_off() · display_is_on() → bool
 * - glyph(character, address): writes 25 pixels
 */
export function createDisplayCalls(machine: Machine, board: Board): SyscallTable {
  return { ...pictures(machine, board), ...pixels(machine, board) };
}

function pictures(machine: Machine, board: Board): SyscallTable {
  const { display } = board;
  const { callUs } = board.type.costsUs;
  const builtIn = new Map<number, Uint8Array>();
  let frames: Uint8Array[] = [];
  let animation = 0;
  const unpacked = (bits: Value | undefined): Uint8Array => {
    const key = wholeOf(bits) ?? 0;
    const frame = builtIn.get(key) ?? unpack(key);
    builtIn.set(key, frame);
    return frame;
  };
  const imageAt = (address: Value | undefined, w: Value | undefined, h: Value | undefined): Uint8Array => {
    const [width, height] = [wholeOf(w) ?? 0, wholeOf(h) ?? 0];
    return cut(machine.memory(wholeOf(address) ?? 0, width * height), width, height);
  };
  const showAtOnce = (frame: Uint8Array): null => {
    machine.spend(callUs);
    animation++;
    display.show(frame);
    return null;
  };
  const add = (frame: Uint8Array): null => {
    frames.push(frame);
    return null;
  };
  const run = (delayMs: Value | undefined, loop: Value | undefined, clear: Value | undefined): boolean => {
    machine.spend(callUs);
    animation++;
    display.showFrames(frames, { delayMs: wholeOf(delayMs) ?? 0, loop: loop === true, clear: clear === true });
    frames = [];
    return display.isAnimating;
  };
  return {
    display_show_bits: (bits) => showAtOnce(unpacked(bits)),
    display_show_image: (address, w, h) => showAtOnce(imageAt(address, w, h)),
    display_show_text: (text, delayMs, loop, clear) => {
      const characters = [...textOf(text)];
      const [first] = characters;
      if (first === undefined) {
        display.stopAnimation();
        return false;
      }
      if (characters.length === 1 && loop !== true && clear !== true) {
        showAtOnce(display.glyph(first));
        return false;
      }
      frames = characters.map((character) => display.glyph(character));
      return run(delayMs, loop, clear);
    },
    display_begin: () => {
      frames = [];
      display.stopAnimation();
      return null;
    },
    display_add_bits: (bits) => add(unpacked(bits)),
    display_add_image: (address, w, h) => add(imageAt(address, w, h)),
    display_add_text: (text) => add(display.glyph(textOf(text))),
    display_run: run,
    display_scroll: (text, delayMs, loop, monospace) => {
      machine.spend(callUs);
      animation++;
      const options = { delayMs: wholeOf(delayMs) ?? 0, loop: loop === true, monospace: monospace === true };
      display.scroll(textOf(text), options);
      return null;
    },
    display_clear: () => {
      machine.spend(callUs);
      animation++;
      display.clear();
      return null;
    },
    display_busy: (): Wait => {
      const awaited = animation;
      const isOver = (): boolean => animation !== awaited || !display.isAnimating;
      return { untilUs: isOver() ? machine.clock.nowUs : Infinity, ready: isOver, result: () => !isOver() };
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

function unpack(bits: number): Uint8Array {
  return Uint8Array.from({ length: SIDE * SIDE }, (_, i) => ((bits >> (SIDE * SIDE - 1 - i)) & 1) * LIT);
}

function cut(pixels: Uint8Array, width: number, height: number): Uint8Array {
  const frame = new Uint8Array(SIDE * SIDE);
  for (let y = 0; y < Math.min(height, SIDE); y++) {
    frame.set(pixels.subarray(y * width, y * width + Math.min(width, SIDE)), y * SIDE);
  }
  return frame;
}
