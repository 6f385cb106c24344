import { describe, expect, it } from 'vitest';

import type { Parcours } from '../client/types';
import { wishes } from './wishes';

/** The calls of the client for an attribute's value. */
async function said(name: string, value: string | null): Promise<readonly unknown[]> {
  const calls: unknown[] = [];
  const note =
    (method: string) =>
    (...args: readonly unknown[]): Promise<void> =>
      Promise.resolve(void calls.push(method, ...args));
  const client = new Proxy({}, { get: (_, method) => note(String(method)) }) as Parcours;
  await wishes[name]?.(client, value);
  return calls;
}

describe('an attribute that changes while the page is there', () => {
  it('shows other parts, and all of them when it is gone or names none', async () => {
    expect(await said('show', 'arena, board')).toEqual(['setSettings', { parts: ['board', 'arena'] }]);
    const all = ['setSettings', { parts: ['bar', 'code', 'board', 'arena', 'tools', 'console'] }];
    for (const value of [null, '', 'all', 'nonsense']) expect(await said('show', value)).toEqual(all);
  });

  it('changes the language to one that the page has, and else leaves it', async () => {
    expect(await said('lang', 'it-CH')).toEqual(['setSettings', { language: 'it' }]);
    expect(await said('lang', 'es')).toEqual([]);
    expect(await said('lang', null)).toEqual([]);
  });

  it('goes back to how it was at first when the attribute is gone', async () => {
    expect(await said('theme', null)).toEqual(['setSettings', { theme: 'system' }]);
    expect(await said('muted', null)).toEqual(['setSettings', { muted: false }]);
    expect(await said('speed', null)).toEqual(['setSpeed', 1]);
    expect(await said('robot', null)).toEqual(['setRobot', { robot: 'auto' }]);
    expect(await said('board', null)).toEqual(['setRobot', { device: 'auto' }]);
    expect(await said('seed', null)).toEqual(['setSeed', 1]);
    expect(await said('reality', null)).toEqual(['setReality', 0]);
    expect(await said('snapshot-hz', null)).toEqual(['subscribe', { snapshotHz: 0 }]);
  });

  it('asks for no more pictures than the page gives, and for none where the number is none', async () => {
    const hz = async (value: string): Promise<unknown> => (await said('snapshot-hz', value))[1];
    for (const [value, snapshotHz] of [
      ['12.5', 12.5],
      ['1e9', 60],
      ['Infinity', 60],
      ['-3', 0],
      ['many', 0],
    ] as const)
      expect(await hz(value)).toEqual({ snapshotHz });
  });

  it('takes numbers as they are written', async () => {
    expect(await said('speed', '0.25')).toEqual(['setSpeed', 0.25]);
    expect(await said('speed', 'max')).toEqual(['setSpeed', 'max']);
    expect(await said('seed', '42')).toEqual(['setSeed', 42]);
    expect(await said('muted', '')).toEqual(['setSettings', { muted: true }]);
  });
});
