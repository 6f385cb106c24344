import type { Board } from '#board/board';
import type { VmException } from './report';

/** Image.SAD: micropython-microbit-v2 microbit_constimage.c (MIT, 2015 Mark Shannon). */
const SAD = Uint8Array.from('0000001010000000111010001', (led) => (led === '1' ? 9 : 0));
const SAD_US = 1_000_000; // micropython-microbit-v2 main.c: one second
const SCROLL_DELAY_MS = 150; // the default of display.scroll

/**
 * Shows an uncaught exception as the board does when nobody watches its console: a sad face for a second, then
 * "line 3 NameError name 'x' isn't defined" scrolls by. Nothing of Python runs for it.
 */
export function showError(board: Board, { type, message, line }: VmException): void {
  const words = [line === null ? '' : `line ${line}`, type, message].filter((word) => word !== '');
  board.display.on();
  board.display.show(SAD);
  board.clock.at(board.clock.nowUs + SAD_US, () =>
    board.display.scroll(words.join(' '), { delayMs: SCROLL_DELAY_MS, loop: false, monospace: false }),
  );
}
