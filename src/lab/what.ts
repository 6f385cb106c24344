import { optionProblem, type Option } from '#core/option';
import { lineCount, lineOf, numbersOfLine, withNumber, type NumberAt } from '#python/numbers';
import { bareOptions } from '#robots/bare-options';
import { findRobot } from '#robots/index';
import type { RunSetup } from '#simulation/run-setup';
import { readNumbers } from './values';

/** A value of a thing that varies: a number, or the choice of an option. */
export type Value = number | string;

/** A thing that varies from run to run. */
export type What =
  /** A number in a program of the first device. */
  | { readonly kind: 'number'; readonly file: string; readonly at: NumberAt }
  | { readonly kind: 'seed' | 'reality' }
  /** A part of the first robot's start. */
  | { readonly kind: 'start'; readonly of: 'x' | 'y' | 'heading' }
  /** An option of the first robot. */
  | { readonly kind: 'option'; readonly id: string };

/** A thing that varies, as it was asked for, with its values. */
export interface Varied {
  /** Its name, as it was written. */
  readonly name: string;
  readonly what: What;
  readonly values: readonly Value[];
}

type Problem = { readonly problem: string };

/** The run that varies. */
export interface Base {
  readonly setup: RunSetup;
  /** The seed of a run that is not ideal, where the seed itself does not vary. */
  readonly usedSeed: number;
  /** The seed of an ideal one; left out: that of the set-up. */
  readonly idealSeed?: number;
  /** Another name of `main.py`: that of the file it was read from. Left out: it has none. */
  readonly mainName?: string;
}

/**
 * Reads `WHAT=VALUES`.
 *
 * @returns or a sentence that begins with the place
 */
export function readVaried(text: string, base: Base): Varied | Problem {
  const end = text.lastIndexOf('=');
  if (end < 1) return { problem: `"${text}" is not like main.py:5=500..900/50.` };
  const [name, values] = [text.slice(0, end).trim(), text.slice(end + 1).trim()];
  const what = readWhat(name, base);
  if ('problem' in what) return what;
  const read = what.kind === 'option' ? readChoices(values, what.id, base) : numbersFor(values, what);
  if ('problem' in read) return { problem: `${name}: ${read.problem}` };
  return { name, what, values: read.values };
}

const KNOWN = 'main.py:5, main.py:5.2, seed, reality, start.x, start.y, start.heading, option.ID';

function readWhat(name: string, base: Base): What | Problem {
  if (name === 'seed' || name === 'reality') return { kind: name };
  const [, of] = /^start\.(x|y|heading)$/.exec(name) ?? [];
  if (of === 'x' || of === 'y' || of === 'heading') return { kind: 'start', of };
  const [, id] = /^option\.(.+)$/.exec(name) ?? [];
  if (id !== undefined) return { kind: 'option', id };
  const [, file, line, place] = /^(.+):(\d+)(?:\.(\d+))?$/.exec(name) ?? [];
  if (file === undefined || line === undefined) return { problem: `${name}: is not known. There are ${KNOWN}.` };
  return numberNamed(name, { file, line: Number(line), place: place === undefined ? null : Number(place) }, base);
}

interface Named {
  readonly file: string;
  readonly line: number;
  /** From 1; `null`: the only one. */
  readonly place: number | null;
}

function numberNamed(name: string, { file, line, place }: Named, { setup, mainName }: Base): What | Problem {
  const { files } = setup.devices[0];
  const here = !Object.hasOwn(files, file) && file === mainName ? 'main.py' : file;
  const text = Object.hasOwn(files, here) ? files[here] : undefined;
  if (text === undefined) return { problem: `${name}: there is no file "${file}". There are ${Object.keys(files).join(', ')}.` }; // prettier-ignore
  if (line < 1 || line > lineCount(text)) return { problem: `${name}: ${file} has ${lineCount(text)} lines.` };
  const numbers = numbersOfLine(text, line);
  const shown = lineOf(text, line);
  if (numbers.length === 0)
    return { problem: `${name}: there is no number in this line${shown === '' ? ', it is empty.' : `: ${shown}`}` };
  const listed = numbers.map((one, index) => `${file}:${line}.${index + 1} is ${one.text}`).join(', ');
  const at = numbers[(place ?? 1) - 1];
  if (place === null && numbers.length > 1)
    return { problem: `${name}: which of ${numbers.length} numbers? ${listed}.` };
  if (at === undefined) return { problem: `${name}: there is no such number in this line: ${listed}.` };
  return { kind: 'number', file: here, at };
}

/** Ranges of what is not a number in a program, with the words for them. */
const fits: Partial<Record<What['kind'], readonly [(value: number) => boolean, string]>> = {
  seed: [
    (value) => Number.isInteger(value) && value >= 0 && value <= 0xffffffff,
    'a whole number from 0 to 4294967295',
  ],
  reality: [(value) => value >= 0 && value <= 1, 'a number from 0 to 1'],
};

function numbersFor(text: string, { kind }: What): { readonly values: readonly number[] } | Problem {
  const read = readNumbers(text);
  if ('problem' in read) return read;
  const [isFit, words] = fits[kind] ?? [() => true, ''];
  const wrong = read.numbers.find((value) => !isFit(value));
  return wrong === undefined ? { values: read.numbers } : { problem: `${wrong} is not ${words}.` };
}

/** The choices of an option: listed, or by steps where they are numbers. */
function readChoices(text: string, id: string, { setup }: Base): { readonly values: readonly Value[] } | Problem {
  const [{ robot: robotId, board }] = setup.devices;
  const robot = findRobot(robotId);
  const options: readonly Option[] = robot?.options ?? bareOptions({ id: board });
  const numbers = /\.\./.test(text) ? readNumbers(text) : null;
  if (numbers !== null && 'problem' in numbers) return numbers;
  const values = numbers?.numbers.map(String) ?? text.split(',').map((one) => one.trim());
  for (const value of values) {
    const problem = optionProblem(options, { [id]: value });
    if (problem !== null)
      return { problem: `${robot === undefined || robot === null ? '' : `${robot.name}: `}${problem}` };
  }
  return { values: values.map((value) => (String(Number(value)) === value ? Number(value) : value)) };
}

/** The same run with these values, in the order of what varies. */
export function withValues(base: Base, varied: readonly Varied[], values: readonly Value[]): RunSetup {
  const { devices, scene, ...rest } = base.setup;
  const [first, ...others] = devices;
  const numberOf = (match: (what: What) => boolean): number | undefined => {
    const place = varied.findIndex(({ what }) => match(what));
    return place < 0 ? undefined : Number(values[place]);
  };
  const [x, y, heading] = (['x', 'y', 'heading'] as const).map((of) => numberOf((what) => what.kind === 'start' && what.of === of)); // prettier-ignore
  const { robot } = scene;
  const reality = numberOf(({ kind }) => kind === 'reality');
  const seed = numberOf(({ kind }) => kind === 'seed') ?? seedWith(base, reality);
  const at = [x ?? robot.at[0], y ?? robot.at[1]] as const;
  const options = varied.flatMap(({ what }, place) =>
    what.kind === 'option' ? [[what.id, String(values[place])] as const] : [],
  );
  return {
    ...rest,
    ...{ seed, reality: reality ?? rest.reality },
    scene: { ...scene, robot: { ...robot, at, heading: heading ?? robot.heading } },
    devices: [
      {
        ...first,
        files: filesWith(first.files, varied, values),
        ...(options.length > 0 && { robotOptions: { ...first.robotOptions, ...Object.fromEntries(options) } }),
      },
      ...others,
    ],
  };
}

function seedWith({ setup, usedSeed, idealSeed }: Base, reality: number | undefined): number {
  if (reality === undefined) return setup.seed;
  return reality > 0 ? usedSeed : (idealSeed ?? setup.seed);
}

/** The programs with other numbers, written from the end on: what comes before keeps its place. */
function filesWith(
  files: Readonly<Record<string, string>>,
  varied: readonly Varied[],
  values: readonly Value[],
): Readonly<Record<string, string>> {
  const changed = { ...files };
  const numbers = varied.flatMap(({ what }, place) =>
    what.kind === 'number' ? [{ ...what, value: Number(values[place]) }] : [],
  );
  for (const { file, at, value } of numbers.sort((one, other) => other.at.from - one.at.from))
    changed[file] = withNumber(changed[file] ?? '', at, value);
  return changed;
}
