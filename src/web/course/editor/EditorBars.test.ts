// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { SceneObject } from '#scene/scene';

import { editingPage, press, samples } from '../../app/testing/editing';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
import EditorBars from './EditorBars.vue';

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => void vi.useRealTimers());

/**
 * The row below the arena while the course is edited; `settle` waits until the course has been checked for problems.
 */
async function bars(objects: readonly SceneObject[], props: object = {}, more: Parameters<typeof editingPage>[1] = {}) {
  const page = await editingPage(objects, more);
  const places: unknown[] = [];
  const given = { isAlone: false, isTold: true, isQuiet: false, onShow: (at: unknown) => places.push(at), ...props };
  const mounted = mountOn(page, EditorBars, given);
  const settle = async () => {
    await nextTick(); // the last change has been noticed
    vi.advanceTimersByTime(500);
    await vi.dynamicImportSettled();
    await nextTick();
  };
  const text = () => textOf(document.querySelector('.bar p'));
  return { ...page, mounted, places, settle, text };
}

/** A block in the middle of a wall. */
const stuck = { ...samples.block, at: [200, 100] } as const;

describe('the row below the arena', () => {
  it('says what is not right with the course, a moment after the last change', async () => {
    const { editor, settle, text } = await bars([samples.wall]);
    await settle();
    expect(text()).toBe('');
    editor.commit({ type: 'add', objects: [stuck] });
    await nextTick();
    expect(text()).toBe(''); // half-finished work is not a problem yet
    await settle();
    expect(text()).toBe('Block 1 steckt in etwas anderem: Wand 1.');
  });

  it('mends it by a tap, as one step that can be taken back', async () => {
    const { settle, text, steps, editor, scene } = await bars([samples.wall, stuck]);
    await settle();
    const before = scene().objects;
    await press('Block zur Seite: Block 1 steckt in etwas anderem: Wand 1.');
    await settle();
    expect([text(), steps()]).toEqual(['', 1]);
    editor.undo();
    expect(scene().objects).toEqual(before);
  });

  it('lists several with what a tap does about each, and mends all of them in one step', async () => {
    const { settle, text, steps } = await bars([samples.wall, stuck, { ...samples.checkpoint, number: 4 }]);
    await settle();
    await press('2 Hinweise');
    await vi.dynamicImportSettled();
    await nextTick();
    const rows = [...document.querySelectorAll('[role="menuitem"]')].map((row) => textOf(row));
    expect(rows).toEqual([
      'Alles beheben',
      'Kontrollpunkt 1 fehlt: Nach der Lücke kommt 4.',
      'Neu nummerieren',
      'Block 1 steckt in etwas anderem: Wand 1.',
      'Block zur Seite',
    ]);
    document.querySelector<HTMLElement>('[data-testid="mend-all"]')?.click();
    await settle();
    expect([text(), steps()]).toEqual(['', 1]);
  });

  it('is a sign with a number where somebody only drives', async () => {
    const { mounted, settle } = await bars([samples.wall, stuck], { isQuiet: true });
    await settle();
    expect(mounted.get('[data-testid="problems"]').classes()).toContain('bar--quiet');
    expect(mounted.get('[data-testid="all-problems"]').text()).toBe('1');
  });

  it('is quiet again when it has been mended', async () => {
    const { editor, settle, text } = await bars([samples.wall, stuck]);
    await settle();
    expect(text()).not.toBe('');
    editor.commit({ type: 'remove', ids: ['block'] });
    await settle();
    expect(text()).toBe('');
  });

  it('names nothing that is gone, not even for a moment', async () => {
    const { editor, settle, text } = await bars([samples.wall, stuck]);
    await settle();
    expect(text()).not.toBe('');
    editor.commit({ type: 'remove', ids: ['wall'] });
    await nextTick();
    expect(text()).toBe('');
  });

  it('is quiet for whoever only drives', async () => {
    const { settle, text } = await bars([samples.wall, stuck], { isTold: false });
    await settle();
    expect(text()).toBe('');
  });

  it('shows the place, and selects what is meant where things are being selected', async () => {
    const { editor, settle, places } = await bars([samples.wall, stuck]);
    await settle();
    await press('Zeigen: Block 1 steckt in etwas anderem: Wand 1.');
    expect(places).toHaveLength(1);
    expect(places[0]).toMatchObject({ x: 200, y: 100 });
    expect(editor.selection.value.ids).toEqual([]);
    editor.choose('select');
    await press('Zeigen: Block 1 steckt in etwas anderem: Wand 1.');
    expect(editor.selection.value.ids).toContain('block');
  });

  it('tells what the course asks for where it has the row to itself', async () => {
    const { text, editor } = await bars([], { isAlone: true }, { description: 'Fahr ins Ziel.' });
    expect(text()).toBe('Aufgabe Fahr ins Ziel.');
    editor.commit({ type: 'course', changes: { description: '' } });
    await nextTick();
    expect(text()).toBe('Aufgabe Keine. Füge ein Ziel hinzu oder begrenze die Zeit.');
  });

  it('says what waits for the next start, before anything else', async () => {
    const page = await bars([samples.wall, stuck]);
    await page.settle();
    await startRun(page);
    await show(page);
    page.editor.commit({ type: 'remove', ids: ['wall'] });
    await page.settle();
    expect(page.text()).toBe('Wand: gilt erst, wenn du neu startest.');
    page.editor.undo();
    await nextTick();
    expect(page.text()).not.toContain('gilt erst');
  });

  it('warns when the course is full and nothing was done', async () => {
    const full = Array.from({ length: 2000 }, (_, i) => ({ ...samples.wall, id: `w${String(i)}` }));
    const { editor, notices, ids } = await bars(full, { isTold: false });
    expect(editor.commit({ type: 'add', objects: [samples.block] })).toBe(false);
    await nextTick();
    expect([ids().length, notices.current.value?.key]).toEqual([2000, 'notice.courseFull']);
  });
});
