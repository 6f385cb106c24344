import { memoOf } from '#core/memo';
import type { Pupil } from './school-class';

/** Vowels that some write with an e behind them, and what is one letter to some and two to others. */
const SAME: readonly (readonly [RegExp, string])[] = [
  [/ß/g, 'ss'],
  [/æ|ä|ae/g, 'a'],
  [/œ|ö|ø|oe/g, 'o'],
  [/ü|ue/g, 'u'],
  [/ł/g, 'l'],
  [/đ/g, 'd'],
];

/** The words of a name in a form that all spellings of it have: small letters without marks, in the order of the alphabet. */
export function wordsOfName(name: string): readonly string[] {
  const plain = SAME.reduce((text, [sign, letter]) => text.replace(sign, letter), name.normalize('NFC').toLowerCase());
  return plain
    .normalize('NFD')
    .replace(/[\p{M}'’]/gu, '')
    .split(/[^\p{L}]+/u)
    .filter((word) => word !== '')
    .toSorted();
}

/** True if a word, or its first letter alone, stands for another one. */
const standsFor = (word: string, other: string): boolean => word === other || (word.length === 1 && other.startsWith(word)); // prettier-ignore

/** True if each word of one name stands for another word of the other name. */
function isWithin(part: readonly string[], whole: readonly string[]): boolean {
  const left = [...whole];
  return part
    .toSorted((a, b) => b.length - a.length)
    .every((word) => {
      const at = left.findIndex((other) => standsFor(word, other));
      if (at >= 0) left.splice(at, 1);
      return at >= 0;
    });
}

/** The words of each name that a pupil is known by. */
export const wordsOfPupil = memoOf(({ name, also }: Pupil) => [name, ...also].map(wordsOfName));

/**
 * Finds whose name stands on a hand-in: `meier_ada`, `Ada M.`, `Ada Meier_1023_file`, or a name that they are known by.
 *
 * @returns `null` for nobody, or if it may be several
 */
export function findPupil(pupils: readonly Pupil[], name: string): Pupil | null {
  const words = wordsOfName(name);
  // Numbers instead of names.
  if (words.length === 0) return pupils.find((pupil) => [pupil.name, ...pupil.also].includes(name)) ?? null;
  const only = (is: (own: readonly string[]) => boolean): Pupil | null | undefined => {
    const found = pupils.filter((pupil) => wordsOfPupil(pupil).some((own) => own.length > 0 && is(own)));
    return found.length > 1 ? null : found[0];
  };
  const whole = words.join(' ');
  const isEqual = (own: readonly string[]): boolean => own.join(' ') === whole;
  const isAround = (own: readonly string[]): boolean => own.length > 1 && isWithin(own, words);
  // Initials alone, such as of a file called a.py, are nobody's.
  const isPart = (own: readonly string[]): boolean => words.some(({ length }) => length > 1) && isWithin(words, own);
  const found = [isEqual, isAround, isPart];
  for (const is of found) {
    const pupil = only(is);
    if (pupil !== undefined) return pupil;
  }
  return null;
}

/** An id for a further pupil: the words of the name, with a number where somebody has them. */
export function freePupilId(pupils: readonly Pick<Pupil, 'id'>[], name: string): string {
  const own = wordsOfName(name).join('-') || 'pupil';
  for (let number = 1; ; number += 1) {
    const id = number === 1 ? own : `${own}-${String(number)}`;
    if (!pupils.some((pupil) => pupil.id === id)) return id;
  }
}
