import { describe, expect, it } from 'vitest';

import { hostAt } from '../testing/host-at';
import type { Abilities } from '../client/types';
import { attributeProblem } from './attribute-problem';

/** The abilities that a page reports. */
const page = hostAt().ask('hello')?.['abilities'] as Abilities;

/** The error of an attribute's value, in words. */
const said = (name: string, value: string | null): string | null =>
  attributeProblem(name, value, page)?.message ?? null;

describe('the value of an attribute', () => {
  it.each([
    ['show', 'arena,zzz', 'show: "arena,zzz" is not one of bar, code, board, arena, tools, console, all.'],
    ['lang', 'xx', 'lang: "xx" is not one of de, fr, it, en.'],
    ['theme', 'pink', 'theme: "pink" is not one of system, light, dark.'],
    ['speed', '3', 'speed: "3" is not one of 0.25, 0.5, 1, 2, 4, 8, max.'],
    ['robot', 'cat', 'robot: "cat" is not one of auto, none, maqueen-lite.'],
    ['board', 'Oxocard', 'board: "Oxocard" is not one of auto, microbit-v2.'],
    ['seed', '0', 'seed: "0" is no whole number within 1 … 9999.'],
    ['seed', '1.5', 'seed: "1.5" is no whole number within 1 … 9999.'],
    ['reality', '2', 'reality: "2" is no number within 0 … 1.'],
    ['reality', ' ', 'reality: " " is no number within 0 … 1.'],
    ['task', 'nope', 'task: "nope" is not one of push.'],
    ['world', 'nope', 'world: "nope" is not one of push.'],
    ['loading', 'soon', 'loading: "soon" is not one of lazy, eager.'],
    ['snapshot-hz', '9999', 'snapshot-hz: "9999" is no number within 0 … 60.'],
    ['snapshot-hz', 'many', 'snapshot-hz: "many" is no number within 0 … 60.'],
  ])('%s="%s" makes no sense, and the error says what would', (name, value, words) => {
    expect(said(name, value)).toBe(words);
  });

  it('is an error with a code and the name of the attribute if it makes no sense', () => {
    const problem = attributeProblem('speed', '3', page);
    expect(problem).toMatchObject({ name: 'ParcoursError', code: 'wrong-attribute', path: 'speed' });
  });

  it.each([
    ...[
      ['show', 'board arena'],
      ['show', 'all'],
      ['lang', 'de-CH'],
      ['lang', 'FR'],
      ['theme', 'dark'],
      ['speed', '0.25'],
    ],
    ...[
      ['speed', 'max'],
      ['robot', 'none'],
      ['robot', 'maqueen-lite'],
      ['board', 'auto'],
      ['seed', '9999'],
    ],
    ...[
      ['reality', '0.5'],
      ['task', 'push'],
      ['loading', 'eager'],
      ['snapshot-hz', '12.5'],
      ['title', 'anything'],
    ],
  ])('%s="%s" is all right', (name, value) => {
    expect(said(name, value)).toBeNull();
  });

  it('is all right if it is left out or empty', () => {
    for (const value of [null, ''])
      for (const name of ['show', 'speed', 'seed', 'task']) expect(said(name, value)).toBeNull();
  });

  it('is not asked for where the page does not say which courses it has', () => {
    const { courses, ...older } = page;
    expect(courses).toEqual(['push']);
    expect(attributeProblem('task', 'nope', older)).toBeNull();
  });
});
