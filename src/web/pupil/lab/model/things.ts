import { lineOf, numbersIn } from '#python/numbers';
import type { RunSetup } from '#simulation/run-setup';

/** A number in a program that can vary. */
export interface ProgramNumber {
  readonly file: string;
  /** From 1. */
  readonly line: number;
  /** Its line, without the spaces around it. */
  readonly shown: string;
  /** Its place in the text of the file. */
  readonly from: number;
  readonly to: number;
  readonly isWhole: boolean;
}

/** The start of the robot, how used it is, and chance. */
export const OTHER_THINGS = ['start.x', 'start.y', 'start.heading', 'reality', 'seed'] as const;
export type OtherThing = (typeof OTHER_THINGS)[number];

/** Something that can vary, with its value now. */
export interface Thing {
  /** Its name, as the command line has it. */
  readonly name: string;
  readonly now: number;
  /** `null`: it is none of a program. */
  readonly number: ProgramNumber | null;
}

/** A thing that varies, with its first and last value. */
export interface Range {
  readonly name: string;
  readonly from: number;
  readonly to: number;
  readonly step: number;
}

/** The value of a number as a program has it; `null`: it is none on the line of numbers. */
function valueOf(text: string): number | null {
  const isMinus = text.startsWith('-');
  const value = Number(text.replace(/^-\s*/, '').replaceAll('_', ''));
  if (!Number.isFinite(value)) return null;
  return isMinus ? -value : value;
}

/** The numbers in the programs of the first device, in their order. */
export function numberThings({ devices: [{ files }] }: Pick<RunSetup, 'devices'>): readonly Thing[] {
  return Object.entries(files)
    .filter(([file]) => file.endsWith('.py'))
    .flatMap(([file, text]) => {
      const numbers = numbersIn(text);
      return numbers.flatMap((at): readonly Thing[] => {
        const now = valueOf(at.text);
        if (now === null) return [];
        const inLine = numbers.filter(({ line }) => line === at.line);
        const place = inLine.length > 1 ? `.${inLine.indexOf(at) + 1}` : '';
        const { line, from, to } = at;
        const number = {
          ...{ file, line, from, to },
          shown: lineOf(text, line),
          isWhole: /^-?\s*[\d_]+$/.test(at.text),
        };
        return [{ name: `${file}:${line}${place}`, now, number }];
      });
    });
}

/** The other things of a run that can vary. */
export function otherThings({ scene, reality, seed }: Pick<RunSetup, 'scene' | 'reality' | 'seed'>): readonly Thing[] {
  const { at, heading } = scene.robot;
  const now = { 'start.x': at[0], 'start.y': at[1], 'start.heading': heading, reality, seed } as const;
  return OTHER_THINGS.map((name) => ({ name, now: now[name], number: null }));
}

/** The first range that is offered for a thing, around its value now. */
export function firstRange({ name, now, number }: Thing): Range {
  if (name === 'reality') return { name, from: 0, to: 1, step: 0.05 };
  if (name === 'seed') return { name, from: 1, to: 20, step: 1 };
  if (number === null) {
    const [wide, step] = name === 'start.heading' ? [20, 2] : [40, 4];
    return { name, from: Math.round(now) - wide, to: Math.round(now) + wide, step };
  }
  const size = Math.abs(now);
  if (size === 0) return { name, from: 0, to: 10, step: 1 };
  const unit = 10 ** Math.floor(Math.log10(size)) / 2;
  const near = (value: number): number => exact(Math.round(value / unit) * unit);
  const [least, most] = [near(size * 0.6), near(size * 1.4)];
  const step = niceStep((most - least) / 50);
  const [low, high, by] =
    number.isWhole && size < 12
      ? [Math.max(0, size - 5), size + 5, 1]
      : [least, most, number.isWhole ? Math.max(1, step) : step];
  return now < 0 ? { name, from: -high, to: -low, step: by } : { name, from: low, to: high, step: by };
}

/**
 * A range for the program as it is now: its number is known by its line, which may have moved.
 *
 * @param then the program with which its number was named
 * @returns `null`: which number it was can no longer be told
 */
export function followed(range: Range, then: Pick<RunSetup, 'devices'>, now: Pick<RunSetup, 'devices'>): Range | null {
  const [before, after] = [numberThings(then), numberThings(now)];
  const thing = before.find(({ name }) => name === range.name);
  if (!thing?.number) return range;
  const { file, shown } = thing.number;
  const here = after.find(({ name }) => name === range.name)?.number;
  if (here?.shown === shown) return range;
  const place = /\.\d+$/.exec(range.name.slice(file.length))?.[0] ?? '';
  const equal = (things: readonly Thing[]): readonly Thing[] =>
    things.filter(({ name, number }) => number?.file === file && number.shown === shown && name === `${file}:${number.line}${place}`); // prettier-ignore
  const [moved, ...others] = equal(after);
  if (moved !== undefined && others.length === 0 && equal(before).length === 1) return { ...range, name: moved.name };
  return here && shapeOf(here.shown) === shapeOf(shown) ? range : null;
}

/** A line whatever its numbers are. */
const shapeOf = (line: string): string =>
  numbersIn(line).reduceRight((text, { from, to }) => `${text.slice(0, from)}#${text.slice(to)}`, line);

/** The same number without the trace of a division. */
const exact = (value: number): number => Number(value.toPrecision(12));

/** The next of 1, 2, 5, 10, 20 … that is not smaller. */
function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return exact(([1, 2, 5, 10].find((times) => times * power >= least * 0.999) ?? 10) * power);
}

/** A range as `readSweep` reads it. */
export const rangeText = ({ name, from, to, step }: Range): string => `${name}=${from}..${to}/${step}`;

/** Number of values in a range; 0: it has none. */
export function countOf({ from, to, step }: Range): number {
  if (!(step > 0) || ![from, to, step].every(Number.isFinite)) return 0;
  return Math.floor(Math.abs(to - from) / step + 1e-9) + 1;
}
