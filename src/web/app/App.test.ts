// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { controls } from '../kit/controls/controls';
import { noHost, type HostWish } from '../session/visit/host-view';
import { nothingKept } from '../session/work/model/keep-work';
import App from './App.vue';
import { downloads } from './testing/downloads';
import { named, setWindow, textOf } from './testing/mount-on';

const landmarks = (): readonly string[] =>
  [...document.querySelectorAll<HTMLElement>('header, main, nav, main > section')].flatMap((element) =>
    element.style.display === 'none' ? [] : [element.getAttribute('aria-label') ?? element.tagName.toLowerCase()],
  );

/** The whole page in a window of this width, as this host wishes it. */
async function opened(width: number, wish: Partial<HostWish> = {}, settings: object = {}) {
  localStorage.setItem('parcours.settings', JSON.stringify({ language: 'de', welcomed: true, ...settings }));
  setWindow(width, 800);
  const app = mount(App, {
    props: { opened: nothingKept, wish: { ...noHost, ...wish } },
    attachTo: document.body,
    global: { plugins: [controls] },
  });
  await flushPromises();
  return app;
}

beforeEach(() => {
  // A canvas that takes everything and shows nothing.
  const context = new Proxy({}, { get: (_, name) => (name === 'measureText' ? () => ({ width: 10 }) : () => context), set: () => true }); // prettier-ignore
  vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(context as never);
  vi.stubGlobal('Path2D', function Path2D() { return context; }); // prettier-ignore
});
afterEach(() => {
  vi.restoreAllMocks();
  history.replaceState(null, '', '/');
});

describe('the whole page', () => {
  it('has its four panes side by side on a large screen, below the bar', async () => {
    await opened(1400);
    expect(landmarks()).toEqual(['Steuerung', 'main', 'Programm', 'Mikrocomputer', 'Arena', 'Konsole']);
    expect(document.querySelectorAll('h1')).toHaveLength(1);
  });

  it('has them behind tabs on a phone, one in sight', async () => {
    await opened(390);
    await vi.waitFor(() => expect(landmarks()).toEqual(['Steuerung', 'main', 'Programm', 'Bereiche']), 20_000);
    named('Konsole', 'nav button').click();
    await nextTick();
    expect(landmarks()).toEqual(['Steuerung', 'main', 'Konsole', 'Bereiche']);
  });

  it('shows only what a host names; without the bar there is still a way to run', async () => {
    const settings = { parts: ['board'] } as const;
    await opened(1400, { settings });
    await vi.waitFor(() => expect(landmarks()).toEqual(['Steuerung', 'main', 'Mikrocomputer']), 20_000);
    expect(document.querySelector('[data-testid="menu"]')).toBeNull();
    named('Simulieren', 'button');
    expect(textOf(document.querySelector('h1.vh'))).toBe('Parcours');
  });

  it('is marked light or dark for its styles, and in its language', async () => {
    await opened(1400, {}, { theme: 'dark', language: 'fr' });
    await vi.waitFor(() => expect(document.documentElement.lang).toMatch(/^fr/), 20_000);
    expect(document.documentElement.dataset['theme']).toBe('dark');
    await vi.waitFor(() => expect(landmarks()[0]).toBe('Commandes'), 20_000);
  });

  it('says where files can be dropped while they are held over it', async () => {
    await opened(1400);
    const drag = (type: string) =>
      document.body.dispatchEvent(
        Object.assign(new Event(type, { bubbles: true, cancelable: true }), {
          dataTransfer: { types: ['Files'], files: [new File(['x = 1\n'], 'mine.py')] },
          relatedTarget: null,
        }),
      );
    drag('dragover');
    await nextTick();
    expect(textOf(document.querySelector('.drop'))).toBe('Dateien hier loslassen');
    drag('drop');
    await vi.waitFor(() => expect(document.body.textContent).toContain('mine.py ist geladen.'), 20_000);
    expect(document.querySelector('.drop')).toBeNull();
  });

  it('has the curves inside the console, which keeps its output meanwhile', async () => {
    await opened(1400);
    document.querySelector<HTMLElement>('[data-testid="console-fold"]')?.click();
    await nextTick();
    document.querySelector<HTMLElement>('[data-testid="tab-chart"]')?.click();
    await vi.waitFor(
      () => expect(document.querySelector('.pane-console [data-testid="chart"]')).not.toBeNull(),
      20_000,
    );
    expect(landmarks()).toContain('Konsole');
    document.querySelector<HTMLElement>('[data-testid="tab-console"]')?.click();
    await nextTick();
    expect(document.querySelector('[data-testid="chart"]')).toBeNull();
  });

  it('saves with Ctrl+S from anywhere, instead of the browser', async () => {
    const saved = downloads();
    await opened(1400);
    const press = new KeyboardEvent('keydown', { key: 's', ctrlKey: true, bubbles: true, cancelable: true });
    document.body.dispatchEvent(press);
    expect(press.defaultPrevented).toBe(true);
    await vi.waitFor(() => expect(textOf(document.querySelector('.notice p'))).toMatch(/\.parcours\.json ist gespeichert\.$/), 20_000); // prettier-ignore
    expect(saved.map(({ name }) => name)).toEqual([expect.stringMatching(/\.parcours\.json$/)]);
    vi.restoreAllMocks();
  });
});
