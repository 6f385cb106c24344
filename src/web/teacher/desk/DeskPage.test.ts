// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';

import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { shelfOf } from '../shelf/use-shelf';
import { seriesDraft } from '../series/series-draft';
import DeskPage from './DeskPage.vue';

beforeAll(() => loadTexts('de'));
beforeEach(() => document.body.replaceChildren());

describe('the page for teachers', () => {
  it('has nothing to go on with before anything was made', async () => {
    mountOn(createPage(), DeskPage);
    await flushPromises();
    expect(isThere('desk-left')).toBe(false);
  });

  it('begins with what was left: the task and the series that are being made, each a tap away', async () => {
    const page = createPage();
    page.work.setTask({ version: 1, id: 'A' });
    seriesDraft(page).change({ title: 'Linien' });
    seriesDraft(page).add([{ project: page.work.work.value.project } as never]);
    mountOn(page, DeskPage);
    await flushPromises();
    expect(textOf(byId('left-menu-make-series'))).toBe('LinienEntwurf · Aufgaben: 1');
    await tap('left-menu-task');
    expect(page.router.page.value?.name).toBe('task');
  });

  it('searches cards, own tasks and the help, and leads to each of them', async () => {
    const page = createPage();
    const { files, scene } = page.work.work.value.project;
    await shelfOf(page).keep({
      kind: 'task',
      project: { files, scene: { ...scene, name: 'Um die Säule' }, course: null },
    });
    mountOn(page, DeskPage);
    await flushPromises();
    await write(byId('desk-search'), 'Arbeitsblatt');
    await vi.waitFor(() => expect(isThere('found-menu-worksheet')).toBe(true));
    expect(isThere('menu-task')).toBe(false);
    await write(byId('desk-search'), 'säule');
    expect(textOf(byId('desk-found'))).toContain('Um die Säule');
    await write(byId('desk-search'), 'Rückblick');
    await vi.waitFor(() => expect(textOf(byId('desk-found'))).toContain('Rückblick'), 20_000);
    await write(byId('desk-search'), 'xyzzyx');
    expect(textOf(byId('desk-found'))).toBe('Nichts gefunden. Versuche es mit einem kürzeren Wort.');
    await write(byId('desk-search'), '');
    expect(textOf(byId('desk-tasks'))).toContain('Meine Aufgaben1');
    await tap('desk-tasks');
    expect(page.router.page.value?.name).toBe('tasks');
  });
});
