import { describe, expect, it } from 'vitest';
import type { Variable, Variables } from '#vm/debug/variables';
import { changesBetween, globalName, localName } from './changes';

const variables = (values: Readonly<Record<string, string>>): readonly Variable[] =>
  Object.entries(values).map(([name, text]) => ({ name, value: { type: 'int', text } }));
const call = (name: string, locals: Readonly<Record<string, string>>) => ({
  function: name,
  file: 'main.py',
  line: 1,
  locals: variables(locals),
});
const stop = (globals: Readonly<Record<string, string>>, ...stack: Variables['stack']): Variables => ({
  stack,
  globals: variables(globals),
});
const body = call('<module>', {});

describe('what has changed since the stop before', () => {
  it('is told with the value of then, and what is new as new', () => {
    const changes = changesBetween(stop({ n: '1', m: '5' }, body), stop({ n: '2', m: '5', x: '9' }, body));
    expect([...changes]).toEqual([
      [globalName('n'), '1'],
      [globalName('x'), null],
    ]);
  });

  it('is nothing at the first stop', () => {
    expect(changesBetween(null, stop({ n: '1' }, body)).size).toBe(0);
  });

  it('is told for the variables of a call that goes on, counted from the outermost', () => {
    const before = stop({}, call('f', { a: '1', b: '2' }), body);
    const now = stop({}, call('g', { a: '7' }), call('f', { a: '3', b: '2' }), body);
    expect([...changesBetween(before, now)]).toEqual([[localName(1, 'a'), '1']]);
  });

  it('is nothing in a call of another function in the same place', () => {
    expect(changesBetween(stop({}, call('f', { a: '1' }), body), stop({}, call('g', { a: '2' }), body)).size).toBe(0);
  });
});
