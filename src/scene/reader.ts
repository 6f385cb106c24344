import { shown, type SceneProblem, type SceneProblemCode } from './problem';
import type { Point } from './scene';

/** An unchecked JSON object. */
export type Fields = Readonly<Record<string, unknown>>;

/** Bounds of a number, both included. */
export interface Range {
  readonly min: number;
  readonly max: number;
}

/** Maximum number of listed problems: nobody reads more, and a hostile file must not cost memory. */
const MAX_PROBLEMS = 20;

/**
 * Reads an unchecked value piece by piece and collects what is wrong with it. Every reading function gives
 * a usable stand-in when the value is not, so that one pass finds all problems.
 */
export class Reader {
  private readonly found: SceneProblem[] = [];

  /** The problems found so far, at most 20, in the order in which they were found. */
  get problems(): readonly SceneProblem[] {
    return this.found;
  }

  /** True when more problems would not be listed. */
  get isFull(): boolean {
    return this.found.length >= MAX_PROBLEMS;
  }

  /** Notes a problem; `what` ends the sentence "place: …". */
  report(
    code: SceneProblemCode,
    path: string,
    value: unknown,
    what: string,
    params: Readonly<Record<string, string | number>> = {},
  ): void {
    if (this.isFull) return;
    this.found.push({
      code,
      path,
      value: value === undefined ? '' : shown(value),
      params,
      message: path === '' ? what : `${path}: ${what}`,
    });
  }

  /** An object; each property that is not among the known ones is a problem. */
  fields(value: unknown, path: string, known: readonly string[]): Fields {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) {
      this.wrongType(value, path, 'an object { … }');
      return {};
    }
    for (const key of Object.keys(value)) {
      if (this.isFull) break;
      if (known.includes(key)) continue;
      this.report(
        'unknown-property',
        join(path, shownKey(key)),
        undefined,
        `unknown property. Known here: ${known.join(', ')}.`,
        {
          known: known.join(', '),
        },
      );
    }
    return value as Fields;
  }

  /** A text of at most this many characters. */
  text(value: unknown, path: string, maxCharacters: number, ifMissing?: string): string {
    if (value === undefined && ifMissing !== undefined) return ifMissing;
    if (typeof value !== 'string') {
      this.wrongType(value, path, 'a text in quotes');
      return '';
    }
    if (value.length > maxCharacters) {
      this.report('too-long', path, value, `${value.length} characters are too many; the limit is ${maxCharacters}.`, {
        length: value.length,
        max: maxCharacters,
      });
      return '';
    }
    return value;
  }

  /** A finite number within the range. */
  number(value: unknown, path: string, range: Range, ifMissing?: number): number {
    if (value === undefined && ifMissing !== undefined) return ifMissing;
    if (typeof value !== 'number') {
      this.wrongType(value, path, 'a number');
      return range.min;
    }
    if (!(value >= range.min && value <= range.max)) {
      const bounds = { min: range.min, max: range.max };
      this.report('out-of-range', path, value, `${shown(value)} is not within ${range.min} … ${range.max}.`, bounds);
      return range.min;
    }
    return value === 0 ? 0 : value; // no negative zero: it would not survive the file
  }

  /** A whole number within the range. */
  whole(value: unknown, path: string, range: Range, ifMissing?: number): number {
    const number = this.number(value, path, range, ifMissing);
    if (Number.isInteger(number)) return number;
    this.report('not-whole', path, value, `${shown(value)} must be a whole number.`);
    return range.min;
  }

  /** `true` or `false`. */
  flag(value: unknown, path: string, ifMissing: boolean): boolean {
    if (value === undefined) return ifMissing;
    if (typeof value === 'boolean') return value;
    this.wrongType(value, path, 'true or false');
    return ifMissing;
  }

  /** A pair of whole numbers. */
  point(value: unknown, path: string, range: Range, ifMissing?: Point): Point {
    if (value === undefined && ifMissing !== undefined) return ifMissing;
    if (!Array.isArray(value) || value.length !== 2) {
      this.wrongType(value, path, 'two numbers [x, y]');
      return [range.min, range.min];
    }
    return [this.whole(value[0], `${path}[0]`, range), this.whole(value[1], `${path}[1]`, range)];
  }

  /** A list with at least `min` and at most `max` entries. */
  list(value: unknown, path: string, bounds: Range): readonly unknown[] {
    if (!Array.isArray(value)) {
      this.wrongType(value, path, 'a list [ … ]');
      return [];
    }
    if (value.length < bounds.min || value.length > bounds.max) {
      const code = value.length > bounds.max ? 'too-many' : 'out-of-range';
      const what = `${value.length} entries; there may be ${bounds.min} … ${bounds.max}.`;
      this.report(code, path, undefined, what, { count: value.length, min: bounds.min, max: bounds.max });
      return [];
    }
    return value;
  }

  /** One of the words; `ifMissing` also stands in for an unknown one. */
  word<const W extends string>(value: unknown, path: string, words: readonly W[], ifMissing: W): W {
    if (value === undefined) return ifMissing;
    const word = words.find((candidate) => candidate === value);
    if (word !== undefined) return word;
    this.report('unknown-value', path, value, `${shown(value)} is unknown. Known: ${words.join(', ')}.`, {
      known: words.join(', '),
    });
    return ifMissing;
  }

  /** Notes that a value is missing or of another kind than the `wanted` one. */
  wrongType(value: unknown, path: string, wanted: string): void {
    if (value === undefined) this.report('missing', path, undefined, `is missing; it must be ${wanted}.`, { wanted });
    else this.report('wrong-type', path, value, `must be ${wanted}, not ${shown(value)}.`, { wanted });
  }
}

/** The place of a property inside the place of its object. */
export const join = (path: string, key: string): string => (path === '' ? key : `${path}.${key}`);

const shownKey = (key: string): string => (/^[\w-]{1,40}$/.test(key) ? key : shown(key));
