import { describe, expect, it } from 'vitest';

import { SpacedPresses } from './spaced-presses';

/** Presses of one button, with what the run was told and when. */
function pressed() {
  const presses = new SpacedPresses();
  const told: [atMs: number, down: boolean][] = [];
  let nowMs = 0;
  return {
    presses,
    told,
    set: (...changes: boolean[]) => {
      for (const down of changes) presses.set('a', down, () => told.push([nowMs, down]));
    },
    pictures: (untilMs: number, everyMs: number) => {
      for (nowMs += everyMs; nowMs <= untilMs; nowMs += everyMs) presses.advance(nowMs * 1000);
      nowMs -= everyMs;
    },
    downs: () => told.map(([, down]) => down),
  };
}

/** What the board needs to notice a change: 44 ms after letting go, less after a press. */
const NOTICED_MS = 44;

describe('presses of a host', () => {
  it('are told at once, down and up, when they last long enough', () => {
    const { set, pictures, told } = pressed();
    set(true);
    pictures(160, 16);
    set(false);
    expect(told).toEqual([[0, true], [160, false]]); // prettier-ignore
  });

  it('in one breath are told one after the other, each long enough to be noticed', () => {
    const { presses, set, pictures, told, downs } = pressed();
    set(true, false, true, false);
    expect(told).toEqual([[0, true]]);
    pictures(640, 16);
    expect(downs()).toEqual([true, false, true, false]);
    const gapsMs = told.slice(1).map(([atMs], index) => atMs - told[index]![0]);
    expect(Math.min(...gapsMs)).toBeGreaterThan(NOTICED_MS);
    expect(presses.isWaiting).toBe(false);
  });

  it('at full speed wait for a picture that surely knows of the change: the one under way may be older', () => {
    const { set, pictures, told } = pressed();
    set(true, false);
    pictures(2000, 1000); // the first may be from before the press, the second is not: from then on time counts
    expect(told).toEqual([[0, true]]);
    pictures(3000, 1000);
    expect(told).toEqual([[0, true], [3000, false]]); // prettier-ignore
  });

  it('stay as they are while simulated time stands still', () => {
    const { set, presses, told } = pressed();
    set(true, false);
    for (let times = 0; times < 50; times += 1) presses.advance(20_000);
    expect(told).toHaveLength(1);
  });

  it('that say nothing new are left out, and far too many are lost in pairs: the last state counts', () => {
    const { set, pictures, downs } = pressed();
    set(true, true, false, false);
    pictures(500, 16);
    expect(downs()).toEqual([true, false]);
    for (let times = 0; times < 500; times += 1) set(true, false);
    pictures(20_000, 16);
    expect(downs().length).toBeLessThan(30);
    expect(downs().at(-1)).toBe(false);
  });

  it('go on blindly where no pictures come', () => {
    const { presses, set, downs } = pressed();
    set(true, false, true);
    presses.advanceBlindly();
    expect(downs()).toEqual([true, false]);
    presses.advanceBlindly();
    expect(downs()).toEqual([true, false, true]);
  });

  it('are settled when the run is over: what waited last is done, and in the next run everything is news', () => {
    const { presses, set, downs } = pressed();
    set(true, false, true, false);
    presses.settle();
    expect(downs()).toEqual([true, false]);
    set(true);
    presses.settle();
    set(true);
    expect(downs()).toEqual([true, false, true, true]);
  });
});
