import { numbersIn, writtenNumber, type NumberAt } from '#python/numbers';
import type { Change } from './change';
import { replaced, type Program } from './program';

/** A number of a program. */
export interface NumberPlace {
  readonly value: number;
  readonly line: number;
  /** Its beginning in the text. */
  readonly from: number;
  /** The program's change to another value; `null`: it would be the same. */
  readonly to: (value: number) => Change | null;
  /** A value as it can be written in its place: of a whole number a whole one. */
  readonly near: (value: number) => number;
}

/** The numbers of a program. */
export const numbersOf = (program: Program): readonly NumberPlace[] =>
  numbersIn(program.source.text)
    .filter(({ value }) => Number.isFinite(value))
    .map((at) => ({
      ...{ value: at.value, line: at.line, from: at.from },
      near: (wanted) => (Number.isInteger(at.value) ? Math.round(wanted) : rounded(wanted)),
      to: (wanted) => (wanted === at.value ? null : toNumber(program, at, wanted)),
    }));

const toNumber = (program: Program, at: NumberAt, wanted: number): Change | null => {
  const part = { from: at.from, to: at.to, by: writtenNumber(program.source.text, at, wanted) };
  return replaced(program, 'number', [part], wanted > at.value ? 'more' : 'less');
};

/** To three digits. */
const rounded = (value: number): number => Number(value.toPrecision(3));

/** Factors of the coarse steps, in the order in which they are tried. Chosen: a slip is seldom beyond ten times. */
const FACTORS = [2, 0.5, 1.4, 0.7, 0.1, 10, 1.2, 0.85, 3, 0.33, 5, 0.2] as const;
/** For small whole numbers, which count something. */
const STEPS = [1, -1, 2, -2, 3, -3, 4] as const;
/** Instead of 0. */
const FROM_ZERO = [1, 10, 50, 100, 500, 1000, -50] as const;

/** Whole numbers up to this count something. */
const SMALL = 12;

/** Number of coarse steps that are tried before other kinds of changes. Chosen: most slips are among them. */
export const FIRST_STEPS = 6;

/** Values of the first, coarse steps away from a number. */
export function coarseValues({ value, near }: NumberPlace): readonly number[] {
  if (value === 0) return FROM_ZERO;
  const isSmall = Number.isInteger(value) && Math.abs(value) <= SMALL;
  const scaled = FACTORS.map((factor) => near(value * factor));
  const stepped = STEPS.map((step) => value + step);
  const values = isSmall ? [...stepped.slice(0, 4), ...scaled, ...stepped.slice(4), 0, -value] : [...scaled, -value];
  return [...new Set(values)].filter((one) => one !== value);
}

/** A value that was tried, and how far the run got. */
export interface Tried {
  readonly value: number;
  readonly score: number;
}

/** The next value to try between two that were, and how promising it is; `null`: they are as near as makes a difference. */
export interface Between {
  readonly value: number;
  readonly score: number;
  /** How far apart the two are. */
  readonly ratio: number;
}

/** Chosen: two such values make a robot do the same to the eye. */
const NEAREST = 1.015;

/** Factors beyond which a gap is only halved if the run gets farther there. Chosen: most slips are within. */
const FARTHEST = [0.4, 2.5] as const;

/** Halves the gaps between values that were tried: the middles, the most promising first. */
export function between({ near, value: before }: NumberPlace, tried: readonly Tried[]): readonly Between[] {
  const scoreBefore = tried.find(({ value }) => value === before)?.score ?? -Infinity;
  const inOrder = [...tried].sort((one, other) => one.value - other.value);
  const found = inOrder.flatMap((low, place): readonly Between[] => {
    const high = inOrder[place + 1];
    if (high === undefined) return [];
    const value = near((low.value + high.value) / 2);
    const [small, large] = [Math.abs(low.value), Math.abs(high.value)].sort((one, other) => one - other);
    const isCrossing = low.value < 0 !== high.value < 0;
    const ratio = isCrossing ? 2 : (large ?? 1) / Math.max(small ?? 1, 1e-9);
    if (value <= low.value || value >= high.value || ratio < NEAREST) return [];
    const isFar = before !== 0 && !(value / before > FARTHEST[0] && value / before < FARTHEST[1]);
    if (isFar && Math.max(low.score, high.score) <= scoreBefore) return [];
    return [{ value, score: Math.max(low.score, high.score), ratio: Math.min(ratio, 10) }];
  });
  return found.sort((one, other) => other.score - one.score || other.ratio - one.ratio);
}
