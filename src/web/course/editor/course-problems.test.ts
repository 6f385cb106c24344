// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { SceneObject } from '#scene/scene';

import { editingPage, press, samples } from '../../app/testing/editing';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
import CourseProblems from './CourseProblems.vue';
import { useCourseProblems } from './use-course-problems';
import { useWaiting } from './use-waiting';

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => void vi.useRealTimers());

/** The problems of a course that is edited; `settle` waits until the course has been checked for them. */
async function building(objects: readonly SceneObject[]) {
  const page = await editingPage(objects);
  const places: unknown[] = [];
  const found = page.scope.run(() => useCourseProblems(page))!;
  const waiting = page.scope.run(() => useWaiting(page))!;
  const mounted = mountOn(page, CourseProblems, { found, onShow: (at: unknown) => places.push(at) });
  const settle = async () => {
    await nextTick(); // the last change has been noticed
    vi.advanceTimersByTime(500);
    await vi.dynamicImportSettled();
    await nextTick();
  };
  const texts = () => found.problems.value.map(({ text }) => text);
  /** Opens the list. */
  const list = async () => {
    document.querySelector<HTMLElement>('[data-testid="problems"]')?.click();
    await vi.dynamicImportSettled();
    await nextTick();
    return [...document.querySelectorAll('[role="menuitem"]')].map((row) => textOf(row));
  };
  return { ...page, mounted, places, settle, texts, list, waiting };
}

/** A block in the middle of a wall. */
const stuck = { ...samples.block, at: [200, 100] } as const;

describe('the problems of a course', () => {
  it('are found a moment after the last change', async () => {
    const { editor, settle, texts } = await building([samples.wall]);
    await settle();
    expect(texts()).toEqual([]);
    editor.commit({ type: 'add', objects: [stuck] });
    await nextTick();
    expect(texts()).toEqual([]); // half-finished work is not a problem yet
    await settle();
    expect(texts()).toEqual(['Block 1 steckt in etwas anderem: Wand 1.']);
  });

  it('are mended by a tap, as one step that can be taken back', async () => {
    const { settle, texts, steps, editor, scene, list } = await building([samples.wall, stuck]);
    await settle();
    const before = scene().objects;
    expect(await list()).toEqual(['Block 1 steckt in etwas anderem: Wand 1.', 'Block zur Seite']);
    await press('Block zur Seite: Block 1 steckt in etwas anderem: Wand 1.');
    await settle();
    expect([texts(), steps()]).toEqual([[], 1]);
    editor.undo();
    expect(scene().objects).toEqual(before);
  });

  it('are listed with what a tap does about each, and all mended in one step', async () => {
    const { settle, texts, steps, list } = await building([samples.wall, stuck, { ...samples.checkpoint, number: 4 }]);
    await settle();
    expect(await list()).toEqual([
      'Alles beheben',
      'Kontrollpunkt 1 fehlt: Nach der Lücke kommt 4.',
      'Neu nummerieren',
      'Block 1 steckt in etwas anderem: Wand 1.',
      'Block zur Seite',
    ]);
    document.querySelector<HTMLElement>('[data-testid="mend-all"]')?.click();
    await settle();
    expect([texts(), steps()]).toEqual([[], 1]);
  });

  it('are gone when they have been mended', async () => {
    const { editor, settle, texts } = await building([samples.wall, stuck]);
    await settle();
    expect(texts()).toHaveLength(1);
    editor.commit({ type: 'remove', ids: ['block'] });
    await settle();
    expect(texts()).toEqual([]);
  });

  it('name nothing that is gone, not even for a moment', async () => {
    const { editor, settle, texts } = await building([samples.wall, stuck]);
    await settle();
    editor.commit({ type: 'remove', ids: ['wall'] });
    expect(texts()).toEqual([]);
  });

  it('show their place, and select what is meant where things are being selected', async () => {
    const { editor, settle, places, list } = await building([samples.wall, stuck]);
    await settle();
    const show = async () => {
      await list();
      await press('Block 1 steckt in etwas anderem: Wand 1.', '[role="menuitem"]');
    };
    await show();
    expect(places).toMatchObject([{ x: 200, y: 100 }]);
    expect(editor.selection.value.ids).toEqual([]);
    editor.choose('select');
    await show();
    expect(editor.selection.value.ids).toContain('block');
  });
});

describe('changes during a run', () => {
  it('that the next start takes up are named', async () => {
    const page = await building([samples.wall]);
    await startRun(page);
    await show(page);
    page.mode.enter('build');
    page.editor.commit({ type: 'remove', ids: ['wall'] });
    await page.settle();
    expect(page.waiting.value).toBe('Wand: gilt erst, wenn du neu startest.');
    page.editor.undo();
    expect(page.waiting.value).toBe('');
  });

  it('are refused with a word when the course is full', async () => {
    const full = Array.from({ length: 2000 }, (_, i) => ({ ...samples.wall, id: `w${String(i)}` }));
    const { editor, notices, ids } = await building(full);
    expect(editor.commit({ type: 'add', objects: [samples.block] })).toBe(false);
    await nextTick();
    expect([ids().length, notices.current.value?.key]).toEqual([2000, 'notice.courseFull']);
  });
});
