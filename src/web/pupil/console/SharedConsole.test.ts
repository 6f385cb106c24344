// @vitest-environment happy-dom
import { nextTick } from 'vue';
import { beforeAll, describe, expect, it, vi } from 'vitest';

import { byId } from '../../app/testing/find';
import { mountOn } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { SHARED_LINES } from './log/shared-lines';
import SharedConsole from './SharedConsole.vue';

/** happy-dom has no layout: a log of 900 px, of which 200 are seen. */
function sized(box: HTMLElement): HTMLElement {
  Object.defineProperty(box, 'scrollHeight', { configurable: true, value: 900 });
  Object.defineProperty(box, 'clientHeight', { configurable: true, value: 200 });
  return box;
}
const scrolled = async (box: HTMLElement, to: number): Promise<void> => {
  box.scrollTop = to;
  box.dispatchEvent(new Event('scroll'));
  await nextTick();
};

/** The console of all devices, at its end. */
async function withConsole() {
  const page = createPage();
  mountOn(page, SharedConsole);
  await startRun(page);
  const box = sized(byId('console'));
  const print = async (text: string): Promise<void> => {
    page.say({ type: 'console', output: [{ text, device: 0, timeUs: 1_000_000 }] });
    await vi.waitFor(() => expect(box.textContent).toContain(text.split('\n')[0]));
    await nextTick();
  };
  await print('one\n');
  await scrolled(box, 700);
  return { page, print, box };
}

describe('the console of all devices', () => {
  beforeAll(() => import('./ErrorCard.vue'));

  it('follows what is printed again after somebody has looked back', async () => {
    const { page, print, box } = await withConsole();
    await show(page, { timeUs: 2_000_000 });
    page.run.look.back();
    await nextTick();
    await scrolled(box, 120); // to the moment that is looked at
    page.run.look.leave();
    await print('two\n');
    expect(box.scrollTop).toBe(900);
  });

  it('says that earlier lines are gone', async () => {
    const { print, box } = await withConsole();
    expect(box.textContent).not.toContain('Nur die letzten');
    await print('more\n'.repeat(SHARED_LINES));
    expect(box.textContent).toContain('Nur die letzten 300 Zeilen sind noch da.');
  });

  it('keeps the card of an error while somebody looks back, in place of the traceback', async () => {
    const { page, box } = await withConsole();
    const traceback =
      "Traceback (most recent call last):\n  File \"main.py\", line 1\nNameError: name 'x' isn't defined\n";
    page.say({ type: 'console', output: [{ text: traceback, device: 0, timeUs: 1_000_000 }] });
    await vi.waitFor(() => expect(box.textContent).toContain('NameError'));
    const failure = { type: 'NameError', message: "name 'x' isn't defined", traceback };
    page.console.addError({ file: 'main.py', line: 1 }, { failure, source: null, table: null });
    await show(page, { timeUs: 2_000_000 });
    page.run.look.back();
    await vi.waitFor(() => expect(box.querySelector('.card')).not.toBeNull());
    expect(Array.from(box.querySelectorAll('.line .text'), ({ textContent }) => textContent.trim())).toEqual(['one']);
    expect(box.querySelector('.card .device')?.textContent).toContain('Traceback');
  });

  it('stays where somebody has scrolled to in the present', async () => {
    const { print, box } = await withConsole();
    await scrolled(box, 120);
    await print('two\n');
    expect(box.scrollTop).toBe(120);
  });
});
