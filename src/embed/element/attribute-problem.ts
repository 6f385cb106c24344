import { LANGUAGES } from '#core/languages';
import { SPEEDS } from '#simulation/pace';
import { ParcoursError } from '../client/parcours-error';
import type { Abilities } from '../client/types';
import { limits } from '../parcours/limits';
import { PARTS } from '../simulator';

export const THEMES = ['system', 'light', 'dark'] as const;
export const LOADINGS = ['lazy', 'eager'] as const;

/** The fault of a value, as the end of a sentence; `null`: none. */
type Check = (value: string, page: Abilities) => string | null;

const oneOf = (value: string, known: readonly (string | number)[]): string | null =>
  known.some((one) => String(one) === value) ? null : `is not one of ${known.join(', ')}`;

const within =
  (min: number, max: number, isWhole = false): Check =>
  (value) => {
    const number = value.trim() === '' ? NaN : Number(value);
    const fits = number >= min && number <= max && (!isWhole || Number.isInteger(number));
    return fits ? null : `is no ${isWhole ? 'whole number' : 'number'} within ${min} … ${max}`;
  };

/** A page that does not say which courses it has is not asked. */
const course: Check = (value, { courses }) => (courses === undefined ? null : oneOf(value, courses));

const checks: Readonly<Record<string, Check>> = {
  show: (value) => {
    const known = [...PARTS, 'all'];
    const names = value.split(/[\s,]+/).filter((name) => name !== '');
    return names.map((name) => oneOf(name, known)).find((problem) => problem !== null) ?? null;
  },
  lang: (value) => oneOf(value.slice(0, 2).toLowerCase(), LANGUAGES),
  theme: (value) => oneOf(value, THEMES),
  speed: (value) => oneOf(value, SPEEDS),
  robot: (value, { robots }) => oneOf(value, ['auto', 'none', ...robots]),
  board: (value, { devices }) => oneOf(value, ['auto', ...devices]),
  seed: within(1, 9999, true),
  reality: within(0, 1),
  world: course,
  task: course,
  loading: (value) => oneOf(value, LOADINGS),
  'snapshot-hz': within(0, limits.snapshotHz),
};

/** The attributes that can be wrong, besides the address and the project. */
export const CHECKED: readonly string[] = Object.keys(checks);

/**
 * The fault of an attribute.
 *
 * @param value as it stands in the element; `null` and `''`: left out
 * @param page what the page knows
 * @returns `null` if there is none
 */
export function attributeProblem(name: string, value: string | null, page: Abilities): ParcoursError | null {
  const problem = value === null || value === '' ? null : checks[name]?.(value, page);
  return typeof problem === 'string' ? wrongAttribute(name, `${JSON.stringify(value)} ${problem}.`) : null;
}

/** The error of an attribute. */
export const wrongAttribute = (name: string, what: string): ParcoursError =>
  new ParcoursError('wrong-attribute', `${name}: ${what}`, name);
