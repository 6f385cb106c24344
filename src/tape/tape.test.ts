import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { isSame } from '#core/same';
import { Simulation } from '#simulation/simulation';
import { convoyOf } from '#simulation/testing/convoy';
import { parseTape, setupAsKept, tapeToText } from './file';
import { momentOf } from './moment';
import { differences, OutputHashes, resultOf, type TapeResult } from './result';
import type { Tape } from './tape';

let firmware: WebAssembly.Module;
let text: string;

/** Runs a set-up for a second and takes down what it comes to. */
async function run(setup: Tape['setup'], press = false): Promise<{ simulation: Simulation; result: TapeResult }> {
  const output = new OutputHashes(setup.devices.length);
  const simulation = await Simulation.create(setup, firmware, {
    print: (printed, device) => output.add(printed, device),
  });
  simulation.advanceTo(300_000);
  if (press) simulation.input({ type: 'button', button: 'a', down: true }, 'robot 1');
  simulation.advanceTo(1_000_000);
  return { simulation, result: resultOf(simulation, output) };
}

beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
  const setup = convoyOf(3);
  const { simulation, result } = await run(setup, true);
  const recorded = { ...setup, inputs: simulation.inputLog };
  text = tapeToText({
    madeBy: '0.0.0',
    physics: 2,
    setup: recorded,
    untilUs: 1_000_000,
    untilProgramEnds: false,
    result,
  });
});

/** The recording, or a failure of the test. */
function read(changed = text): { readonly tape: Tape; readonly changes: readonly string[] } {
  const parsed = parseTape(changed);
  if ('problem' in parsed) throw new Error(parsed.problem);
  return parsed;
}

const problemOf = (changed: string): string => {
  const parsed = parseTape(changed);
  return 'problem' in parsed ? parsed.problem : '';
};

describe('a recorded run', () => {
  it('is run again from its file, inputs and all, and comes to the same', async () => {
    const { tape, changes } = read();
    expect(changes).toEqual([]);
    expect(tape.setup.inputs).toEqual([
      { timeUs: 304_000, device: 'robot 1', action: { type: 'button', button: 'a', down: true } },
    ]);
    const { result } = await run(tape.setup);
    expect(differences(tape.result, result)).toEqual([]);
    expect(tapeToText(tape)).toBe(text);
  });

  it('tells in what a repetition differs', async () => {
    const { tape } = read();
    const { result } = await run({ ...tape.setup, seed: 6 });
    expect(differences(tape.result, result).join(' ')).toMatch(
      /robot 1, output \(hash\): [0-9a-f]{64} in the recording, /,
    );
  });

  it('says with which physics it was made; a file without is from the first', () => {
    expect(read().tape.physics).toBe(2);
    const old = text.replace(/ *"physics": .*\n/, '');
    expect(old).not.toBe(text);
    expect(read(old)).toMatchObject({ tape: { physics: 1 }, changes: [] });
    expect(problemOf(text.replace('"physics": 2', '"physics": "x"'))).toContain('physics: must be a number from 0');
  });

  it('has whole µs, also from pages that once wrote fractions', () => {
    const { untilUs, result } = read().tape;
    const old = text
      .replace(/"untilUs": \d+/, `"untilUs": ${String(untilUs)}.9998`)
      .replace(/"simulatedUs":\d+/, `"simulatedUs":${String(result.simulatedUs)}.9998`);
    expect(old.match(/\.9998/g)).toHaveLength(2);
    expect(read(old).tape).toEqual(read().tape);
  });

  it('tells that a program, or something else, was changed since', () => {
    expect(read(text.replace('range(400)', 'range(401)')).changes).toEqual([
      'The program of "remote" was changed since the recording.',
    ]);
    expect(read(text.replace('"seed":5', '"seed":6')).changes).toEqual([
      'The set-up (course, settings or inputs) was changed since the recording.',
    ]);
  });

  it('says in a sentence why a file is none', () => {
    expect(problemOf('{"format": "parcours-project"}')).toContain('This is no recorded run');
    expect(problemOf('no')).toContain('The recording file is not JSON: line 1');
    expect(problemOf(text.slice(0, 2000))).toContain('The recording file is not JSON');
    expect(problemOf(text.replace('"version": 1', '"version": 2'))).toBe(
      'The recording is of version 2, this Parcours reads up to 1. Update Parcours.',
    );
    expect(problemOf(text.replace('"version": 1', '"version": "x"'))).toBe(
      'version: "x" is no version of a recording.',
    );
    expect(problemOf(text.replace(/"result": .*\n/, '"result": {},\n'))).toContain('result: is missing or damaged');
    expect(problemOf(text.replace(/"hashes": .*/, '"hashes": 1'))).toContain('hashes: is missing');
    expect(problemOf(text.replace('"robot":"none"', '"robot":7'))).toContain(
      'setup.devices[0].robot: 7 does not belong here',
    );
    expect(problemOf(text.replace('"button":"a"', '"button":"c"'))).toContain(
      'setup.inputs[0].action.button: "c" does not belong here',
    );
    expect(problemOf(text.replace('"type":"button"', '"type":"fly"'))).toContain('setup.inputs[0].action.type: "fly"');
  });

  it('gives its set-up all the same where only what comes behind it is damaged, or newer', () => {
    const whole = read().tape.setup;
    const faultOf = (changed: string): readonly unknown[] => {
      const parsed = parseTape(changed);
      return 'problem' in parsed ? [parsed.fault, parsed.setup && isSame(parsed.setup, whole)] : [];
    };
    expect(faultOf(text.slice(0, text.indexOf('"result"') + 30))).toEqual(['damaged', true]);
    expect(faultOf(text.replace(/"result": .*\n/, '"result": {},\n'))).toEqual(['damaged', true]);
    expect(faultOf(text.replace('"version": 1', '"version": 2'))).toEqual(['newer', true]);
    expect(faultOf(text.slice(0, 2000))).toEqual(['damaged', null]);
    expect(faultOf(text.replace('"robot":"none"', '"robot":7'))).toEqual(['damaged', null]);
    expect(faultOf('{"format": "parcours-project"}')).toEqual(['no-tape', null]);
    expect(setupAsKept(whole)).toEqual(whole);
  });

  it('shows a moment: time, line, stack, variables, robot, of any device', async () => {
    const { simulation } = await run(read().tape.setup);
    const moment = momentOf(simulation, 1);
    expect(moment).toMatchObject({
      file: 'main.py',
      stack: [{ function: '<module>', file: 'main.py', locals: {} }],
      robot: { type: 'maqueen-lite' },
    });
    expect(moment.globals['me']).toEqual({ type: 'int', text: '0' });
    expect(Object.keys(moment.globals).sort()).toEqual(['me', 'near', 'text', 'word']);
    expect(momentOf(simulation, 0).robot).toBeNull();
    expect(() => momentOf(simulation, 9)).toThrow('no device 9');
  });
});
