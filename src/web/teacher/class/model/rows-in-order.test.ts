import { describe, expect, it } from 'vitest';

import { unreadable, type CheckResult } from '#check/result';

import type { Row } from './class-model';
import { inOrder, isToLookAt, stateOf, type Filter, type Order } from './rows-in-order';

const world = (atMs: number | null, touches: number): CheckResult['worlds'][number] => ({
  ...{ id: 'visible', hidden: false, passed: atMs !== null, reason: null, atMs, touches },
  ...{ held: [], missed: {}, hash: '', trail: [], trailMs: [] },
});
const row = (name: string, points: number, atMs: number | null, touches = 0): Row => ({
  ...{ name, shown: name },
  handIn: null,
  note: '',
  result: {
    ...{ passed: atMs !== null, points, stars: null, checks: [], remarks: [], twin: '' },
    worlds: [world(atMs, touches)],
  },
});
const waiting: Row = { name: 'Zoe', shown: 'Zoe', handIn: null, result: null, note: '' };
const broken: Row = {
  name: 'Tim',
  shown: 'Tim',
  handIn: null,
  note: '',
  result: unreadable([], { code: 'zip', params: {} }),
};
const rows = [row('Änne', 3, 9000), row('Ada', 1, null, 2), row('Anna 10', 2, 4000), row('Anna 9', 2, 4000), broken, waiting]; // prettier-ignore
const names = (filter: Filter, order: Order): readonly string[] =>
  inOrder(rows, filter, order, 'de').map(({ name }) => name);

describe('the hand-ins of a class', () => {
  it('are in the order of their names, as people count and as the language sorts', () => {
    expect(names('all', { by: 'name', isDown: false })).toEqual(['Ada', 'Anna 9', 'Anna 10', 'Änne', 'Tim', 'Zoe']);
    expect(names('all', { by: 'name', isDown: true })[0]).toBe('Zoe');
  });

  it('are in the order of a column, those that are equal by their names', () => {
    expect(names('all', { by: 'points', isDown: false }).slice(0, 4)).toEqual(['Änne', 'Anna 9', 'Anna 10', 'Ada']);
    expect(names('all', { by: 'time', isDown: false }).slice(0, 3)).toEqual(['Anna 9', 'Anna 10', 'Änne']);
    expect(names('all', { by: 'touches', isDown: true })[0]).toBe('Ada');
    expect(names('all', { by: 'result', isDown: false }).slice(-2)).toEqual(['Tim', 'Zoe']);
  });

  it('are shown by what became of them', () => {
    const byName: Order = { by: 'name', isDown: false };
    expect(names('passed', byName)).toEqual(['Anna 9', 'Anna 10', 'Änne']);
    expect(names('failed', byName)).toEqual(['Ada']);
    expect(names('unread', byName)).toEqual(['Tim']);
    expect(names('look', byName)).toEqual(['Tim']);
  });

  it('wait, have passed or not, or cannot be read', () => {
    expect([waiting, broken, rows[0]!, rows[1]!].map(stateOf)).toEqual(['waiting', 'unread', 'passed', 'failed']);
    expect(isToLookAt(waiting)).toBe(false);
  });
});
