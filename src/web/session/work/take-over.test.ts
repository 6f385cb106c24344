// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { defaultScene } from '#scene/scene';

import { createPage } from '../../app/testing/page';
import { stamped, workToText, type Previous, type Work } from './storage/history';
import { stubDatabase } from './storage/testing/memory-database';
import { copiesOf } from './storage/tab-storage';
import { programsOf } from './programs/own-programs';
import { takeOver } from './take-over';

const work = (text: string, previous: readonly Previous[] = [], course: string | null = null): Work => ({
  project: { files: [{ name: 'main.py', text }], scene: { ...defaultScene(), name: text }, course },
  open: 'main.py',
  previous,
});
const earlier = (text: string, atMs: number): Previous => ({ name: text, atMs, project: work(text).project });
const leave = (tab: string, savedMs: number, what: Work): void =>
  localStorage.setItem(`parcours.copy.${tab}`, stamped(workToText(what), savedMs));
const textsOf = ({ work }: ReturnType<typeof createPage>): readonly (readonly [string | undefined, number])[] =>
  work.work.value.previous.map(({ project, atMs }) => [project.files[0]?.text, atMs]);

beforeEach(() => {
  localStorage.clear();
  sessionStorage.setItem('parcours.tab', 'mine');
  stubDatabase();
});
afterEach(() => void vi.unstubAllGlobals());

describe('what closed tabs have left', () => {
  it('is among the earlier works, newest first, with theirs, and each once', async () => {
    leave('one', 5000, work('a', [earlier('b', 3000)]));
    leave('two', 4000, work('c', [earlier('b', 3000)]));
    const page = createPage();
    page.work.work.value = { ...page.work.work.value, previous: [earlier('mine', 3500)] };
    await takeOver(page, 9000);
    expect(textsOf(page)).toEqual([['a', 5000], ['c', 4000], ['mine', 3500], ['b', 3000]]); // prettier-ignore
  });

  it('is not what is open here, nor what a tab shows that is still open', async () => {
    leave('mine', 5000, work('a'));
    leave('open', 5000, work('b'));
    leave('closed', 5000, work('c'));
    const held = { held: [{ name: 'parcours.tab.open' }] };
    const page = createPage();
    vi.stubGlobal('navigator', { locks: { query: () => Promise.resolve(held) } });
    page.work.openProject(work('c').project, null);
    leave('last', 6000, work('d'));
    await takeOver(page, 9000);
    expect(textsOf(page)).toEqual([['d', 6000]]);
  });

  it('is the later copy of both places, and the last program of its course', async () => {
    const { entries } = stubDatabase();
    leave('one', 5000, work('old', [], 'forward-maqueen'));
    const text = stamped(workToText(work('new', [], 'forward-maqueen')), 6000);
    entries.set('work.one', { name: 'work.one', text, usedMs: 6000 });
    const page = createPage();
    await takeOver(page, 9000);
    expect(textsOf(page)).toEqual([['new', 6000]]);
    expect(programsOf(page.work, 'forward-maqueen').last?.files[0]?.[0]?.text).toBe('new');
  });

  it('is nobody’s on a page that keeps nothing, and what cannot be read is left out', async () => {
    leave('one', 5000, work('a'));
    localStorage.setItem('parcours.copy.two', '{');
    const hosted = createPage({ keepsWork: false });
    await takeOver(hosted, 9000);
    expect(textsOf(hosted)).toEqual([]);
    const page = createPage();
    await takeOver(page, 9000);
    expect(textsOf(page)).toEqual([['a', 5000]]);
  });

  it('stays under the name of a tab until the list that is stored has it; then the five newest copies do', async () => {
    const copies = (): readonly string[] => copiesOf(localStorage).map(([tab]) => tab);
    for (const place of [1, 2, 3, 4, 5, 6, 7]) leave(`tab ${String(place)}`, place, work(`work ${String(place)}`));
    const page = createPage();
    await takeOver(page, 9000);
    expect([textsOf(page).length, copies().length]).toEqual([7, 7]);
    const later = createPage();
    later.work.work.value = { ...later.work.work.value, previous: page.work.work.value.previous };
    await takeOver(later, 9000);
    expect([textsOf(later).length, copies()]).toEqual([7, ['tab 3', 'tab 4', 'tab 5', 'tab 6', 'tab 7']]);
  });

  it('is not what was deleted here', async () => {
    leave('one', 5000, work('a'));
    const page = createPage();
    await takeOver(page, 9000);
    page.work.deleteWorks(page.work.work.value.previous);
    const later = createPage();
    later.work.work.value = page.work.work.value;
    await takeOver(later, 9000);
    expect([textsOf(later), later.work.work.value.deleted?.length]).toEqual([[], 1]);
  });
});
