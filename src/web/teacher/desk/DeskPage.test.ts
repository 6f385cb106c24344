// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';

import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
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

  it('searches cards, works and the help, and leads to each of them', async () => {
    const page = createPage();
    mountOn(page, DeskPage);
    await flushPromises();
    await write(byId('desk-search'), 'Arbeitsblatt');
    await vi.waitFor(() => expect(isThere('found-menu-worksheet')).toBe(true));
    expect(isThere('menu-task')).toBe(false);
    await write(byId('desk-search'), 'Eine Sekunde vorwärts');
    await vi.waitFor(() => expect(textOf(byId('desk-found'))).toContain('Eine Sekunde vorwärts'), 20_000);
    await write(byId('desk-search'), 'Rückblick');
    await vi.waitFor(() => expect(textOf(byId('desk-found'))).toContain('Rückblick'), 20_000);
    await write(byId('desk-search'), 'xyzzyx');
    expect(textOf(byId('desk-found'))).toBe('Nichts gefunden. Versuche es mit einem kürzeren Wort.');
    await write(byId('desk-search'), '');
    await tap('desk-works');
    expect(page.router.page.value?.name).toBe('works');
  });
});
