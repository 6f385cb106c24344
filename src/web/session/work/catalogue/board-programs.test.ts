import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { modulesImportedBy } from '#python/imports';
import { defaultScene } from '#scene/scene';
import { chooseHardware, hardwareIds } from '#simulation/hardware';
import type { InputAction, InputEvent } from '#simulation/input';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { boardPrograms, isBoardProgram } from './board-programs';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const at = (ms: number, action: InputAction): InputEvent => ({ timeUs: ms * 1000, action });
const press = (ms: number, button: 'a' | 'b'): InputEvent[] => [
  at(ms, { type: 'button', button, down: true }),
  at(ms + 120, { type: 'button', button, down: false }),
];
const sense = (ms: number, id: string, value: number | string): InputEvent => at(ms, { type: 'sensor', id, value });

/** A pupil's first ten seconds with them. */
const HANDS: readonly InputEvent[] = [
  sense(500, 'lightLevel', 200),
  sense(500, 'temperature', 31),
  sense(500, 'compassHeading', 90),
  sense(1000, 'gesture', 'shake'),
  ...press(7000, 'a'),
  ...press(7600, 'b'),
  at(8000, { type: 'radio', text: 'Hi' }),
];

async function play(source: string, inputs: readonly InputEvent[] = HANDS): Promise<Simulation> {
  const files = { 'main.py': source };
  const scene = defaultScene();
  const hardware = chooseHardware({ scene, imports: modulesImportedBy(files), robot: 'none', board: 'auto' });
  if ('problem' in hardware) throw new Error(hardware.problem);
  const setup = { scene, files, ...hardwareIds(hardware), seed: 1, reality: 0, inputs };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  simulation.advanceTo(10_000_000);
  return simulation;
}

describe('the sample programs for the microcomputer alone', () => {
  it('are all listed, in every language', () => {
    const files = readdirSync('courses/board').filter((name) => name.endsWith('.py'));
    expect(boardPrograms.map(({ id }) => `${id}.py`).sort()).toEqual(files.sort());
    for (const { source } of boardPrograms) for (const language of LANGUAGES) expect(source[language]).toMatch(/^# /);
  });

  const all = boardPrograms.flatMap(({ id, source }) => LANGUAGES.map((language) => ({ id, text: source[language] })));
  it.each(all)('$id runs for ten seconds without an error', { timeout: 60_000 }, async ({ text }) => {
    const simulation = await play(text);
    expect(simulation.ended?.exception ?? null).toBeNull();
    expect(simulation.takeConsole()).not.toContain('Traceback');
  });

  it('keep to what the usual firmware knows: no f-strings', () => {
    for (const { text } of all) expect(text).not.toMatch(/\bf['"]/);
  });

  it('are known as ours, so that opening another one asks nothing', () => {
    expect(isBoardProgram(boardPrograms[0]!.source.en)).toBe(true);
    expect(isBoardProgram('print(1)')).toBe(false);
  });
});

describe('each sample program does what it says', () => {
  const program = (id: string): string => boardPrograms.find((entry) => entry.id === id)!.source.en;

  it('dice: a shake shows a number from 1 to 6', async () => {
    expect((await play(program('dice'))).takeConsole()).toMatch(/^Rolled: [1-6]\r?\n$/);
  });

  it('light: at 204 of 255, 20 of 25 lights are on, the lowest rows first', async () => {
    const { display } = (await play(program('light'), [sense(0, 'lightLevel', 204)])).snapshot();
    expect(display).toEqual([...Array(5).fill(0), ...Array(20).fill(9)]);
  });

  it('compass: heading east, the needle points to the left, where north is', async () => {
    const { display } = (await play(program('compass'), [sense(0, 'compassHeading', 90)])).snapshot();
    expect(display.slice(10, 15)).toEqual([9, 9, 9, 0, 0]); // the hand of nine o’clock
  });

  it('radio: what is sent to the program is written to the console', async () => {
    expect((await play(program('radio'))).takeConsole()).toMatch(/^Received: Hi\r?\n$/);
  });

  it('calliope: A switches both motors to 600 of 1023, the three lights shine', async () => {
    const snapshot = (await play(program('calliope'))).snapshot();
    expect(snapshot.board).toBe('calliope-mini-3');
    for (const duty of snapshot.motors) expect(duty).toBeCloseTo(600 / 1023, 2);
    expect(snapshot.motors).toHaveLength(2);
    expect(snapshot.rgb).toEqual([[0, 60, 0], [0, 0, 60], [60, 40, 0]]); // prettier-ignore
  });
});
