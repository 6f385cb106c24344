import { readFileSync } from 'node:fs';

import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';
import { createVm } from '#vm/run/vm';

import type { Print } from './example';

const PROGRAM = `from microbit import *
for n in range(3):
    display.show(n)
    sleep(500)
    print(n, running_time())
`;

/** vm: MicroPython on a micro:bit that lies on the table. Two simulated seconds pass as fast as they can. */
export function main(print: Print): void {
  const clock = new Clock();
  const board = new Board(microbitV2, clock);
  const vm = createVm({
    firmware: new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm')),
    board,
    clock,
    files: { 'main.py': PROGRAM },
    libraries: {},
    seed: 1,
    write: (text) => {
      if (text.trim() !== '') print(text.trim());
    },
  });
  vm.resume(3_000_000);
  print(`${board.display.pixels.filter((level) => level > 0).length} LEDs are on`);
}
