// @vitest-environment happy-dom
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { byId, isThere, pressKey, tap } from '../../app/testing/find';
import { leavePage, mountOn, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import { loadTexts, showLanguage } from '../../kit/i18n';
import { LANGUAGES } from '../../kit/i18n/texts';
import { openLayer } from '../../kit/overlays/overlays';
import firstWords from '../words';
import FirstSteps from './FirstSteps.vue';
import TourBubble from './TourBubble.vue';

const STEPS = ['code', 'run', 'arena', 'console', 'stop', 'tools', 'course', 'help'] as const;

/** Puts a control on the page at this place, in px: happy-dom has no layout. */
function place(html: string, left = 100, top = 50): HTMLElement {
  document.body.insertAdjacentHTML('beforeend', html);
  const element = document.body.lastElementChild as HTMLElement;
  element.getBoundingClientRect = () => new DOMRect(left, top, 200, 40);
  return element;
}
/** The tour over a page. */
async function tour(prepare: (page: TestPage) => void = () => undefined) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  prepare(page);
  page.tour.open();
  const bubble = mountOn(page, TourBubble);
  await nextTick();
  await nextTick();
  return { page, bubble };
}
const step = (): string => byId('tour').dataset['step'] ?? '';
const next = (): Promise<void> => tap('tour-next');

beforeEach(() => setWindow(1400, 800));
afterEach(() => void vi.useRealTimers());

describe('the tour', () => {
  it('begins at the program and leads through eight steps to the help', async () => {
    const { page } = await tour();
    const seen: string[] = [];
    for (let at = 1; at <= STEPS.length; at += 1) {
      seen.push(step());
      expect(textOf(byId('tour').querySelector('.num'))).toBe(`${String(at)} von 8`);
      await next();
    }
    expect(seen).toEqual(STEPS);
    expect(page.tour.isOpen.value).toBe(false);
  });

  it('has the microcomputer in the arena’s place where there is no arena', async () => {
    await tour((page) => page.settings.change({ showArena: false }));
    const seen: string[] = [];
    for (let at = 0; at < 7; at += 1) {
      seen.push(step());
      await next();
    }
    expect(seen).toEqual(['code', 'run', 'board', 'console', 'stop', 'course', 'help']);
  });

  it('goes back, but not before its beginning', async () => {
    await tour();
    expect(isThere('tour-back')).toBe(false);
    await next();
    await tap('tour-back');
    expect(step()).toBe('code');
  });

  it('goes on where it was left', async () => {
    await tour((page) => page.settings.change({ tourStep: 'stop' }));
    expect(step()).toBe('stop');
  });

  it('begins anew at a step that is unknown', async () => {
    await tour((page) => page.settings.change({ tourStep: 'gone' }));
    expect(step()).toBe('code');
  });

  it('puts a screen reader on each new bubble, which has its title and its words', async () => {
    await tour();
    for (let at = 0; at < 3; at += 1) {
      expect(document.activeElement).toBe(byId('tour'));
      const by = (name: string): string => textOf(document.getElementById(byId('tour').getAttribute(name)!));
      expect(by('aria-labelledby')).toBe(firstWords.steps[STEPS[at]!].title.de);
      expect(by('aria-describedby')).toContain(firstWords.steps[STEPS[at]!].text.de);
      await next();
    }
  });

  it.each(LANGUAGES)('speaks the language of the page: %s', async (language) => {
    await loadTexts(language);
    showLanguage(language);
    await tour((page) => page.settings.change({ language }));
    expect(byId('tour').querySelector('h2')?.textContent).toBe(firstWords.steps.code.title[language]);
    expect(textOf(byId('tour-next'))).toBe(firstWords.tour.next[language]);
  });

  it('is left with Escape, and says where it waits', async () => {
    const { page } = await tour((it) => it.settings.change({ tourStep: 'arena' }));
    expect(await pressKey('Escape')).toBe(true);
    expect(page.tour.isOpen.value).toBe(false);
    expect(page.settings.current.value.tourStep).toBe('arena');
    expect(page.notices.current.value?.values?.['text']).toBe(firstWords.tour.left.de);
  });

  it('is left with its button alike', async () => {
    const { page } = await tour();
    await tap('tour-leave');
    expect(page.tour.isOpen.value).toBe(false);
    expect(page.settings.current.value.tourStep).toBe('code');
  });

  it('leaves Escape to the program, and to what was opened later', async () => {
    const { page } = await tour();
    document.body.insertAdjacentHTML('beforeend', '<div class="cm-editor"><button id="in-editor"></button></div>');
    expect(await pressKey('Escape', document.querySelector('#in-editor'))).toBe(false);
    const close = openLayer({ requestClose: () => close() });
    await pressKey('Escape');
    expect(page.tour.isOpen.value).toBe(true);
    await pressKey('Escape');
    expect(page.tour.isOpen.value).toBe(false);
  });

  it('goes on by itself when the program runs, and again when it is stopped', async () => {
    const { page } = await tour((it) => it.settings.change({ tourStep: 'run' }));
    await startRun(page);
    await nextTick();
    expect(step()).toBe('arena');
    page.settings.change({ tourStep: 'stop' });
    await nextTick();
    await page.run.stop();
    await nextTick();
    await nextTick();
    expect(step()).toBe('tools');
  });

  it('waits at a step whose deed was done before', async () => {
    const { page } = await tour((it) => it.settings.change({ tourStep: 'code' }));
    await startRun(page);
    await next();
    await nextTick();
    expect(step()).toBe('run');
  });

  it('goes on by itself when the help is opened: it is over then', async () => {
    const { page } = await tour((it) => it.settings.change({ tourStep: 'help' }));
    page.guide.open();
    await nextTick();
    await nextTick();
    expect(page.tour.isOpen.value).toBe(false);
  });

  it('draws a ring 4 px around the control that it speaks of', async () => {
    place('<button data-testid="run">Los</button>', 100, 50);
    await tour((page) => page.settings.change({ tourStep: 'run' }));
    await nextTick();
    const { left, top, width, height } = byId('tour-ring').style;
    expect([left, top, width, height]).toEqual(['96px', '46px', '208px', '48px']);
  });

  it('follows a control that moves', async () => {
    vi.useFakeTimers();
    const button = place('<button data-testid="run">Los</button>', 100, 50);
    await tour((page) => page.settings.change({ tourStep: 'run' }));
    await nextTick();
    button.getBoundingClientRect = () => new DOMRect(300, 400, 200, 40);
    vi.advanceTimersByTime(200);
    await nextTick();
    expect([byId('tour-ring').style.left, byId('tour-ring').style.top]).toEqual(['296px', '396px']);
  });

  it('has no ring around what is not in sight', async () => {
    await tour();
    expect(isThere('tour-ring')).toBe(false);
  });

  it('leads the keyboard to the control on request', async () => {
    const button = place('<button data-testid="run">Los</button>');
    await tour((page) => page.settings.change({ tourStep: 'run' }));
    await nextTick();
    await tap('tour-there');
    expect(document.activeElement).toBe(button);
    expect(byId('tour-ring').classList.contains('tour-ring--here')).toBe(true);
  });

  it('offers no way to a control where there is only something to see', async () => {
    place('<div data-testid="editor"></div>');
    await tour();
    await nextTick();
    expect(isThere('tour-ring')).toBe(true);
    expect(isThere('tour-there')).toBe(false);
  });

  it('points at the menu where a narrow bar has no room for the help', async () => {
    place('<button data-testid="menu"></button>');
    await tour((page) => page.settings.change({ tourStep: 'help' }));
    await nextTick();
    expect(textOf(byId('tour'))).toContain('Das findest du hier im Menü.');
  });

  it('brings the pane of each step to the front on a phone', async () => {
    setWindow(390, 800);
    const { page } = await tour();
    const tabs: string[] = [];
    for (let at = 0; at < 6; at += 1) {
      tabs.push(page.layout.tab.value);
      await next();
    }
    expect(tabs).toEqual(['code', 'code', 'arena', 'console', 'console', 'arena']);
  });

  it('gives the keyboard back to what had it', async () => {
    const button = place('<button>davor</button>');
    button.focus();
    const { bubble } = await tour();
    expect(document.activeElement).toBe(byId('tour'));
    leavePage(bubble);
    expect(document.activeElement).toBe(button);
  });
});

describe('the keys of the help', () => {
  beforeAll(() => import('../guide/GuidePanel.vue'));
  function visit(): TestPage {
    const page = createPage();
    mountOn(page, FirstSteps);
    return page;
  }

  it.each([{ key: 'F1' }, { key: '/', ctrlKey: true }, { key: '/', metaKey: true }])(
    'help opens and closes with $key',
    (keys) => {
      const page = visit();
      const press = (): boolean => {
        const event = new KeyboardEvent('keydown', { ...keys, bubbles: true, cancelable: true });
        document.body.dispatchEvent(event);
        return event.defaultPrevented;
      };
      expect(press()).toBe(true);
      expect(page.guide.at.value).toBe('');
      press();
      expect(page.guide.at.value).toBeNull();
    },
  );

  it('leaves a plain / and Alt+F1 to the browser', async () => {
    const page = visit();
    expect(await pressKey('/', document.body)).toBe(false);
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'F1', altKey: true, bubbles: true }));
    expect(page.guide.at.value).toBeNull();
  });
});
