// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { samples } from '#intake/testing/samples';

import { mountOn } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { setLanguage } from '../../kit/i18n';
import { bringTo } from '../../session/layout/brought-file';
import TournamentPage from './TournamentPage.vue';
import { addText, tournamentOf } from './use-tournament';

const text = new TextDecoder().decode(samples.find(({ kind }) => kind === 'tournament')!.bytes);
let page: TestPage;
beforeEach(async () => {
  await setLanguage('en');
  page = createPage();
});

describe('the page of a tournament', () => {
  it('plays one again that was opened elsewhere, before it was shown or while it is', async () => {
    bringTo(page, 'tournament', text);
    mountOn(page, TournamentPage);
    const model = tournamentOf(page);
    expect([model.programs.value.length, model.told.value, model.count.value]).toEqual([2, [], 1]);
    bringTo(page, 'tournament', text);
    await nextTick();
    expect(model.count.value).toBe(2);
  });

  it('says what is wrong with one that cannot be read', () => {
    bringTo(page, 'tournament', text.replace('"version": 1', '"version": 9'));
    mountOn(page, TournamentPage);
    expect(document.querySelector('[role=alert]')?.textContent).toContain('newer');
  });

  it('plays one again that is pasted where links are added', async () => {
    const model = tournamentOf(page);
    expect(await addText(page, model, text, () => undefined)).toBe(true);
    expect(model.told.value).toEqual([]);
  });

  it('says what is wrong with one that is pasted and cannot be read', async () => {
    mountOn(page, TournamentPage);
    const field = document.querySelector<HTMLTextAreaElement>('[data-testid=class-links]')!;
    field.value = text.replace('"version": 1', '"version": 9');
    field.dispatchEvent(new Event('input'));
    field.form?.dispatchEvent(new Event('submit'));
    await nextTick();
    expect([...document.querySelectorAll('[role=alert]')].map((one) => one.textContent)).toEqual([
      expect.stringContaining('newer'),
    ]);
  });

  it('takes no more programs than its file can have', async () => {
    mountOn(page, TournamentPage);
    const model = tournamentOf(page);
    const programs = (count: number) =>
      Array.from({ length: count }, (_, at) => ({ name: `${at}`, shown: `${at}`, files: {}, problem: null }));
    const said = async (count: number): Promise<string | null | undefined> => {
      model.programs.value = programs(count);
      await nextTick();
      return document.querySelector('[data-testid=tournament-set-up] [role=status]')?.textContent;
    };
    expect(await said(200)).toBe('Programs: 200 · Matches: 39800');
    expect(await said(201)).toBe('Too many programs: at most 200.');
    model.setTurns(2);
    expect(await said(200)).toBe('Too many matches: at most 50000.');
  });
});
