import { platformName } from '../hand-in/platform-name';

/**
 * The names of hand-ins as people read them: without what a learning platform adds. Where two would be alike, the later one has
 * a number.
 */
export function shownNames(names: readonly string[]): readonly string[] {
  const own = new Set(names.filter((name) => platformName(name) === null));
  return names.map((name) => {
    const pupil = platformName(name)?.pupil;
    if (pupil === undefined) return name;
    let shown = pupil;
    for (let number = 2; own.has(shown); number += 1) shown = `${pupil} (${number})`;
    own.add(shown);
    return shown;
  });
}

/**
 * The order of names as a language sorts them, and as people count: Bérard before Bonnet, 9 before 10. What is alike to the
 * language is in the order of its letters' numbers, so that the same names always stand in the same order.
 */
export function nameOrder(language: string): (one: string, other: string) => number {
  // eslint-disable-next-line no-restricted-globals -- no run depends on the order of names
  const { compare } = new Intl.Collator(language, { numeric: true });
  return (one, other) => compare(one, other) || (one < other ? -1 : one > other ? 1 : 0);
}
