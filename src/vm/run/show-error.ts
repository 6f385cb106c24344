import type { Board } from '#board/board';
import type { VmException } from './report';

const SCROLL_DELAY_MS = 150; // the default of display.scroll
const SAD_US = 1_000_000; // micropython-microbit-v2 main.c: one second

const picture = (leds: string): Uint8Array => Uint8Array.from(leds, (led) => (led === '1' ? 9 : 0));
/**
 * Image.SAD: micropython-microbit-v2 microbit_constimage.c.
 * @license micropython-microbit-v2 (pictures, melodies, pitches): MIT. Copyright (c) 2015-2020 Damien P. George.
 */
const SAD = picture('0000001010000000111010001');
const DARK = new Uint8Array(25);

/** The display's pictures of an error, until they are skipped. */
export interface Shown {
  readonly isOver: () => boolean;
  skip(): void;
}

/**
 * Shows an uncaught exception as the board does: a sad face for a second, then "line 3 NameError name 'x' isn't
 * defined" scrolls by. No Python runs for it.
 */
export function showError(board: Board, { type, message, line }: VmException): Shown {
  const words = [line === null ? '' : `line ${line}`, type, message].filter((word) => word !== '');
  board.display.on();
  board.display.show(SAD);
  let isSad = true;
  const stop = board.clock.at(board.clock.nowUs + SAD_US, () => {
    isSad = false;
    board.display.scroll(words.join(' '), { delayMs: SCROLL_DELAY_MS, loop: false, monospace: false });
  });
  return {
    isOver: () => !isSad && !board.display.isAnimating,
    skip: () => {
      stop();
      isSad = false;
      board.display.clear();
    },
  };
}

/** Duration of each picture of a panic, and of the dark between two. Chosen as in micropython-microbit-v2-simulator. */
const PANIC_MS = { picture: 600, dark: 60 } as const;

/** Shows a panic until the next reset: the sad face and the three digits of its number, over and over. */
export function showPanic(board: Board, code: number): void {
  const pictures = [
    SAD,
    ...Array.from(String(Math.abs(code) % 1000).padStart(3, '0'), (digit) => board.display.glyph(digit)),
  ];
  let next = 0;
  const show = (): void => {
    board.display.show(pictures[next++ % pictures.length] ?? SAD);
    board.clock.at(board.clock.nowUs + PANIC_MS.picture * 1000, () => {
      board.display.show(DARK);
      board.clock.at(board.clock.nowUs + PANIC_MS.dark * 1000, show);
    });
  };
  board.display.on();
  show();
}
