// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it } from 'vitest';

import { setWindow } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { PANES } from './layout-model';

/** A page in a window of this size. */
function pageIn(width: number, height: number, wish: Parameters<typeof createPage>[0] = {}): TestPage {
  setWindow(width, height);
  return createPage(wish);
}
const shown = ({ layout }: TestPage) => PANES.filter((pane) => layout.isShown.value[pane]);

describe('how the panes lie', () => {
  it.each([
    [1280, 800, 'wide'],
    [1279, 800, 'medium'],
    [1001, 800, 'medium'],
    [1000, 800, 'narrow'],
    [600, 600, 'narrow'],
    [599, 800, 'phone'],
    [800, 390, 'phone'], // held across
    [1400, 439, 'phone'],
    [1000, 599, 'phone'],
  ])('in a window of %s × %s px: %s', (width, height, kind) => {
    expect(pageIn(width, height).layout.kind.value).toBe(kind);
  });

  it('have board and arena alone in a host’s small frame side by side, above each other, or behind tabs', () => {
    const wish = { settings: { parts: ['board', 'arena'] } } as const;
    const arrangement = (width: number, height: number) => pageIn(width, height, wish).layout.arrangement.value;
    expect(arrangement(560, 400)).toBe('medium');
    expect(arrangement(500, 480)).toBe('narrow');
    expect(arrangement(400, 400)).toBe('phone');
  });
});

describe('which panes are shown', () => {
  it('are all four, unless the pupil hides one', () => {
    const page = pageIn(1280, 800);
    page.settings.change({ showBoard: true, showArena: true });
    expect(shown(page)).toEqual(['code', 'board', 'arena', 'console']);
    page.settings.change({ showBoard: false });
    expect(shown(page)).toEqual(['code', 'arena', 'console']);
    page.settings.change({ showArena: false });
    expect(shown(page)).toEqual(['code', 'console']);
  });

  it('is one at a time on a phone, also one that is hidden on a large page', () => {
    const page = pageIn(390, 800);
    page.settings.change({ showBoard: false });
    expect(shown(page)).toEqual(['code']);
    page.layout.tab.value = 'board';
    expect(shown(page)).toEqual(['board']);
    expect(page.layout.tabs.value).toEqual(['code', 'board', 'arena', 'console']);
  });

  it('is what a host asks for, whatever the pupil has chosen', () => {
    const page = pageIn(1280, 800, { settings: { parts: ['code', 'board'] } });
    page.settings.change({ showBoard: false, showArena: true });
    expect(shown(page)).toEqual(['code', 'board']);
  });

  it('have the arena first on a phone in a host without a program', () => {
    const page = pageIn(300, 300, { settings: { parts: ['board', 'arena', 'console'] } });
    expect(shown(page)).toEqual(['arena']);
    page.layout.tab.value = 'console';
    expect(shown(page)).toEqual(['console']);
    page.layout.tab.value = 'code'; // not there
    expect(shown(page)).toEqual(['arena']);
  });

  it('leave the board away on a wide screen while the arena is to be watched', () => {
    const page = pageIn(1366, 768);
    page.settings.change({ cinema: true });
    expect(shown(page)).toEqual(['code', 'arena', 'console']);
    setWindow(1100, 768);
    expect(shown(page)).toContain('board');
  });

  it('beside the help are program and arena; the board comes back on a very wide screen', () => {
    const page = pageIn(1400, 800);
    page.settings.change({ showBoard: true, showArena: true });
    page.layout.isHelpShown.value = true;
    expect(shown(page)).not.toContain('board');
    setWindow(1800, 800);
    expect(shown(page)).toContain('board');
  });
});

describe('the sizes of the panes', () => {
  it('suit the window', () => {
    const isConsoleFolded = false;
    expect(pageIn(1280, 800).layout.sizes.value).toEqual({
      ...{ code: 344, board: 268, console: 186, top: 0, below: 0, isConsoleFolded },
    });
    expect(pageIn(1100, 800).layout.sizes.value).toEqual({
      ...{ code: 400, board: 208, console: 174, top: 0, below: 208, isConsoleFolded },
    });
  });

  it('spare lines in a low window: those of the console, and of a board below the program', () => {
    expect(pageIn(1366, 625).layout.sizes.value.console).toBe(170);
    expect(pageIn(1100, 640).layout.sizes.value).toMatchObject({ console: 170, below: 172 });
    expect(pageIn(820, 640).layout.sizes.value.console).toBe(208);
  });

  it('leave the program more room on a large screen', () => {
    expect(pageIn(1440, 800).layout.sizes.value).toMatchObject({ code: 384, board: 268 });
    expect(pageIn(1680, 900).layout.sizes.value).toMatchObject({ code: 528, board: 288 });
  });

  it('give the console the height of the card that stands in it', () => {
    const page = pageIn(1366, 625);
    page.layout.leastConsolePx.value = 194;
    expect(page.layout.sizes.value.console).toBe(194);
  });

  it('fold the console everywhere but on a phone', () => {
    const folded = (width: number, height: number): boolean => {
      const page = pageIn(width, height);
      page.layout.isConsoleFolded.value = true;
      return page.layout.sizes.value.isConsoleFolded;
    };
    expect([folded(1366, 625), folded(1100, 640), folded(820, 1180), folded(390, 844)]).toEqual([true, true, true, false]); // prettier-ignore
  });

  it('give the board more where no arena needs the room', () => {
    const page = pageIn(1280, 800);
    page.settings.change({ showArena: false });
    expect(page.layout.sizes.value.board).toBe(560);
  });

  it('are those that the pupil has dragged', () => {
    const page = pageIn(1280, 800);
    page.settings.change({ showArena: true, codePx: 333, consolePx: 99 });
    expect(page.layout.sizes.value).toMatchObject({ code: 333, board: 268, console: 99 });
    page.settings.change({ codePx: null });
    expect(page.layout.sizes.value.code).toBe(344);
  });
});

beforeEach(() => history.replaceState(null, '', '/'));
afterEach(() => setWindow(1024, 768));
