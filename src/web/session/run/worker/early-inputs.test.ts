import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import type { InputAction } from '#simulation/input';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';

import type { FromWorker } from './protocol';
import { Runner } from './runner';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/**
 * Output of a program in its first 300 ms, after these inputs before its start. @param pieceMs interval between the
 * worker's looks at the clock
 */
async function printed(program: string, early: readonly InputAction[], pieceMs = 1): Promise<string> {
  let wallMs = 0;
  const posted: FromWorker[] = [];
  const tasks: (() => void)[] = [];
  const runner = new Runner({
    post: (message) => posted.push(message),
    nowMs: () => wallMs,
    later: (task) => tasks.push(task),
    create: (...given) => Simulation.create(...given),
  });
  const setup = soloRun({ scene: defaultScene(), files: { 'main.py': program }, robot: 'none', board: 'auto', seed: 1, reality: 0 }); // prettier-ignore
  runner.receive({ type: 'prepare', firmware });
  runner.receive({ type: 'run', setup, speed: 1, paused: false });
  for (const action of early) runner.receive({ type: 'input', action });
  while (tasks.length === 0) await Promise.resolve();
  for (; wallMs < 300; wallMs += pieceMs) {
    tasks.shift()?.();
    runner.receive({ type: 'console-taken' });
  }
  return posted
    .map((message) => (message.type === 'console' ? message.output.map(({ text }) => text).join('') : ''))
    .join('');
}

const PRESSED = `
from microbit import *
while running_time() < 200:
    if button_a.is_pressed():
        sleep(150)
        print(button_a.was_pressed(), button_a.is_pressed(), pin_logo.is_touched())
        break`;
const press = (down: boolean): InputAction => ({ type: 'button', button: 'a', down });
const touch = (down: boolean): InputAction => ({ type: 'touch', pad: 'pinLogo', down });

describe('what is done before a program begins', () => {
  it('reaches it: a tap that was long over is seen, and is over', async () => {
    for (const pieceMs of [1, 7, 50])
      expect(await printed(PRESSED, [press(true), press(false), touch(true)], pieceMs)).toBe('True False True\n');
  });

  it('is read by its first question', async () => {
    const text: InputAction = { type: 'serial', text: 'Ada\n' };
    expect(await printed('print("Hello", input())', [text])).toContain('Hello Ada');
  });

  it('is felt by its first line', async () => {
    const dark: InputAction = { type: 'sensor', id: 'lightLevel', value: 7 };
    expect(await printed('from microbit import *\nprint(display.read_light_level())', [dark])).toBe('7\n');
  });

  it('interrupts it where it is Ctrl-C', async () => {
    expect(await printed('print("never")', [{ type: 'interrupt' }])).toContain('KeyboardInterrupt');
  });
});
