// @vitest-environment happy-dom
import { beforeAll, describe, expect, it, vi } from 'vitest';

import { givenTask } from '../locks/testing/given';
import { createPage, type TestPage } from '../../app/testing/page';
import { canTake, isStale, takeOver } from './act-on-run';
import type { Wish } from './model/lab-model';
import { labOf } from './use-lab';

const PROGRAM = 'from mbrobot import *\nforward()\ndelay(650)\nstop()\n';
const number: Wish = { kind: 'ranges', ranges: [{ name: 'main.py:3', from: 400, to: 900, step: 250 }] };
const start: Wish = { kind: 'ranges', ranges: [{ name: 'start.x', from: 100, to: 300, step: 100 }] };
const robots: Wish = { kind: 'robots' };

beforeAll(() => import('../locks/lock-task')); // its first coming takes a while on a busy machine

function emptyPage(): TestPage {
  sessionStorage.clear();
  localStorage.clear();
  return createPage();
}
/** A page on which a task with these locks is open, and a series of its runs that has been asked for. */
async function series(locks: object, wish: Wish) {
  const page = emptyPage();
  page.work.openProject(givenTask(PROGRAM, locks), null);
  await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
  const lab = labOf(page);
  void lab.begin(wish);
  return { page, lab };
}
const taken = ({ jump }: TestPage): string | undefined => jump.mending.value?.after;

describe('the values of a run', () => {
  it('are taken into the program, where they can be undone', async () => {
    const { page, lab } = await series({}, number);
    expect(canTake(page, lab, 2)).toBe(true);
    expect(takeOver(page, lab, 2)).toBe('undo');
    expect([taken(page), lab.taken.value]).toEqual([PROGRAM.replace('650', '900'), 2]);
  });

  it('stay out of a line, a course and a robot that a task locks', async () => {
    for (const [locks, wish] of [
      [{ lines: [3] }, number],
      [{ course: true }, start],
      [{ tools: ['hand'] }, start],
      [{ robot: true }, robots],
    ] as const) {
      const { page, lab } = await series(locks, wish);
      const { scene } = page.work;
      const before = [scene.value, page.settings.current.value];
      expect([canTake(page, lab, 2), takeOver(page, lab, 2)]).toEqual([false, null]);
      expect([scene.value, page.settings.current.value, taken(page), lab.taken.value]).toEqual([...before, undefined, null]); // prettier-ignore
    }
  });

  it('that are no number of the program are not undone in it', async () => {
    const one = await series({ lines: [3] }, start);
    expect(takeOver(one.page, one.lab, 1)).toBe('done');
    expect(one.page.work.scene.value.robot.at[0]).toBe(200);
    const other = await series({}, robots);
    expect(takeOver(other.page, other.lab, 6)).toBe('done');
    expect(other.page.settings.current.value).toMatchObject({ reality: 1, seed: 7 });
  });
});

describe('chance alone', () => {
  const chance: Wish = { kind: 'ranges', ranges: [{ name: 'seed', from: 1, to: 3, step: 1 }] };
  it('is taken over for a used robot; a new one on the page has always the first', async () => {
    const { page, lab } = await series({}, chance);
    expect([0, 1].map((place) => canTake(page, lab, place))).toEqual([true, false]);
    page.settings.change({ reality: 1 });
    await Promise.race([lab.begin(chance), Promise.resolve()]);
    expect([isStale(lab), takeOver(page, lab, 2)]).toEqual([false, 'done']);
    expect(page.settings.current.value).toMatchObject({ reality: 1, seed: 3 });
    expect(isStale(lab)).toBe(false);
  });

  it('is not taken over where the settings have no such number', async () => {
    const { page, lab } = await series({}, chance);
    page.settings.change({ reality: 1 });
    const { seed } = page.settings.current.value;
    await Promise.race([lab.begin({ kind: 'ranges', ranges: [{ name: 'seed', from: 0, to: 20_000, step: 4_000 }] }), Promise.resolve()]); // prettier-ignore
    expect([0, 1, 2, 3, 5].map((place) => canTake(page, lab, place))).toEqual([false, true, true, false, false]);
    expect([takeOver(page, lab, 5), page.settings.current.value.seed]).toEqual([null, seed]);
  });
});

describe('a series', () => {
  it('no longer holds with another robot or chance, unless they are what varies', async () => {
    for (const [wish, expected] of [
      [number, [true, true]],
      [robots, [false, false]],
      [{ kind: 'ranges', ranges: [{ name: 'reality', from: 0, to: 1, step: 0.5 }] }, [false, true]],
    ] as const) {
      const { page, lab } = await series({}, wish);
      expect(isStale(lab)).toBe(false);
      page.settings.change({ reality: 0.5 });
      const stale = [isStale(lab)];
      page.settings.change({ seed: 9 });
      expect([...stale, isStale(lab)]).toEqual(expected);
    }
  });

  it('has the chance of the command line for a new robot', () => {
    const page = emptyPage();
    page.settings.change({ reality: 0.5, seed: 9 });
    const lab = labOf(page);
    void lab.begin({ kind: 'ranges', ranges: [{ name: 'reality', from: 0, to: 1, step: 0.5 }] });
    expect([0, 1, 2].map((place) => lab.setupAt(place)?.seed)).toEqual([1, 9, 9]);
  });
});
