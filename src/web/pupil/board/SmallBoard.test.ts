// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, named, setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { inputsOf, startRun } from '../../app/testing/run';
import BoardPane from './BoardPane.vue';

beforeEach(() => {
  localStorage.clear();
  setWindow(1366, 700);
});

describe('the board beside a card', () => {
  beforeAll(() => import('./WholeBoard.vue')); // comes late; here it is there at once

  it('is its display and its two buttons, and whole on request: then the card is its title line', async () => {
    const page = createPage();
    mountOn(page, BoardPane);
    expect([byId('board').querySelectorAll('rect').length, isThere('panel-sensors')]).toEqual([25, false]);
    await tap('board-whole');
    await flushPromises();
    expect([page.layout.card.value, isThere('panel-sensors')]).toEqual(['folded', true]);
    page.task.open();
    await nextTick();
    expect(isThere('panel-sensors')).toBe(false);
  });

  it('presses the buttons of the board', async () => {
    const page = createPage();
    mountOn(page, BoardPane);
    await startRun(page);
    named('Taste A').dispatchEvent(new PointerEvent('pointerdown', { pointerId: 1, button: 0 }));
    expect(inputsOf(page).at(-1)).toMatchObject({ type: 'button', down: true });
  });

  it('makes room for a panel that something else has opened', async () => {
    const page = createPage();
    mountOn(page, BoardPane);
    page.settings.change({ panel: 'radio' });
    await flushPromises();
    expect([page.layout.card.value, isThere('panel-radio')]).toEqual(['folded', true]);
  });

  it('makes room for the variables of a halted program, and only as long', async () => {
    const page = createPage();
    mountOn(page, BoardPane);
    await startRun(page);
    page.run.pause();
    await nextTick();
    expect(page.layout.card.value).toBe('folded');
    page.run.resume();
    await nextTick();
    expect(page.layout.card.value).toBe('open');
  });
});
