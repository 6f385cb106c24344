import type { Leaf } from './leaves';

/** Code of a leaf that does not exist at a moment: its parent is gone. */
export const ABSENT = 1;

/**
 * Leaves as whole numbers: a figure as twice the number of its steps, everything else as an odd number that names a value
 * of a list. That list grows with the tape.
 */
export class Codes {
  /** The values by their numbers. */
  readonly values: Leaf[] = [];
  private readonly numbers = new Map<string, number>();

  /** The code of a leaf; a figure is rounded to a multiple of `step`. */
  of(leaf: Leaf, step: number): number {
    if (typeof leaf === 'number' && Number.isFinite(leaf)) return 2 * Math.round(leaf / step);
    const key = typeof leaf === 'string' ? `"${leaf}` : JSON.stringify(leaf);
    let number = this.numbers.get(key);
    if (number === undefined) this.numbers.set(key, (number = this.values.push(leaf)));
    return ABSENT + 2 * number;
  }
}

/** The leaf that a code stands for; `undefined` for one that is not there. */
export function leafOf(code: number, step: number, values: readonly Leaf[]): Leaf | undefined {
  if (code % 2 === 0) return inSteps(code / 2, step);
  return values[(code - ABSENT) / 2 - 1];
}

/** Without the dust of multiplying by 0.1. */
const inSteps = (steps: number, step: number): number => (step === 1 ? steps : steps / Math.round(1 / step));
