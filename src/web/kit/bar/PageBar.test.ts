// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { showLanguage } from '../i18n';
import { closePageBar, showPageBar } from './page-bar';
import type { PageMessage } from './page-message';

const same = (text: string) => ({ de: text, fr: `${text} (fr)`, it: text, en: text });
const message = (kind: PageMessage['kind'], text: string, actions: PageMessage['actions'] = []): PageMessage => ({
  kind,
  text: same(text),
  close: same('Später'),
  actions,
});
const shown = (): string | undefined => document.querySelector('.page-bar p')?.textContent ?? undefined;
const kinds: readonly PageMessage['kind'][] = ['update', 'no-storage'];
const press = async (testId: string): Promise<void> => {
  document.querySelector<HTMLElement>(`[data-testid="${testId}"]`)?.click();
  await nextTick();
};

describe('a message about the page itself', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(async () => {
    for (const kind of kinds) closePageBar(kind);
    showLanguage('de');
    await flushPromises();
    vi.useRealTimers();
  });

  it('is told to screen readers politely', async () => {
    showPageBar(message(kinds[0]!, 'Ohne Speicher'));
    await nextTick();
    expect(shown()).toBe('Ohne Speicher');
    expect(document.querySelector('.page-bar-place')?.getAttribute('role')).toBe('status');
  });

  it('goes after twelve seconds if it asks nothing', async () => {
    showPageBar(message(kinds[0]!, 'Ohne Speicher'));
    vi.advanceTimersByTime(11_999);
    await nextTick();
    expect(shown()).toBe('Ohne Speicher');
    vi.advanceTimersByTime(1);
    await nextTick();
    expect(shown()).toBeUndefined();
  });

  it('waits for an answer if it asks something', async () => {
    showPageBar(message(kinds[0]!, 'Neue Fassung', [{ text: same('Neu laden'), run: () => undefined }]));
    vi.advanceTimersByTime(3_600_000);
    await nextTick();
    expect(shown()).toBe('Neue Fassung');
    await press('page-bar-close');
    expect(shown()).toBeUndefined();
  });

  it('does what its button says, and goes', async () => {
    const done: string[] = [];
    showPageBar(message(kinds[0]!, 'Neue Fassung', [{ text: same('Neu laden'), run: () => void done.push('loaded') }]));
    await nextTick();
    await press('page-bar-act');
    expect(done).toEqual(['loaded']);
    expect(shown()).toBeUndefined();
  });

  it('is put in front if it is newer; behind it the older one waits', async () => {
    showPageBar(message(kinds[0]!, 'erste', [{ text: same('a'), run: () => undefined }]));
    showPageBar(message(kinds[1]!, 'zweite', [{ text: same('b'), run: () => undefined }]));
    await nextTick();
    expect(shown()).toBe('zweite');
    await press('page-bar-close');
    expect(shown()).toBe('erste');
  });

  it('takes the place of an older one of the same kind', async () => {
    showPageBar(message(kinds[0]!, 'alt', [{ text: same('a'), run: () => undefined }]));
    showPageBar(message(kinds[0]!, 'neu', [{ text: same('b'), run: () => undefined }]));
    await nextTick();
    expect(shown()).toBe('neu');
    await press('page-bar-close');
    expect(shown()).toBeUndefined();
  });

  it('speaks the language of the page', async () => {
    showLanguage('fr');
    showPageBar(message(kinds[0]!, 'Ohne Speicher'));
    await nextTick();
    expect(shown()).toBe('Ohne Speicher (fr)');
  });
});
