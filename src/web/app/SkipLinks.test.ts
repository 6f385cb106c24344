// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, textOf } from './testing/mount-on';
import { createPage } from './testing/page';
import SkipLinks from './SkipLinks.vue';

beforeEach(() => {
  document.body.innerHTML = `
    <section class="pane-code"><div class="cm-content" tabindex="0"></div></section>
    <section class="pane-arena"><div role="application" tabindex="0"></div></section>`;
});
async function pressTab(): Promise<readonly string[]> {
  dispatchEvent(new KeyboardEvent('keydown', { key: 'Tab' }));
  await nextTick();
  return [...document.querySelectorAll('.skip')].map((link) => textOf(link));
}
const add = (html: string): void => document.body.insertAdjacentHTML('beforeend', html);

describe('the first stops of the Tab key', () => {
  it('lead to what is there', async () => {
    mountOn(createPage(), SkipLinks);
    expect(await pressTab()).toEqual(['Zum Programm', 'Zur Arena']);
    add('<section data-testid="task-card"><h2>Fahr los</h2></section><div data-testid="verdict"></div>');
    expect(await pressTab()).toEqual(['Zur Aufgabe', 'Zum Programm', 'Zur Arena', 'Zum nächsten Schritt']);
  });

  it('lead into it: to its heading, to its button, or to itself', async () => {
    add('<section data-testid="task-card"><button></button><h2>Fahr los</h2></section>');
    add('<div data-testid="verdict"><button>Los geht’s</button></div>');
    mountOn(createPage(), SkipLinks);
    await pressTab();
    const reached = ['Zur Aufgabe', 'Zum nächsten Schritt', 'Zur Arena'].map((name) => {
      named(name).click();
      return textOf(document.activeElement) || document.activeElement?.getAttribute('role');
    });
    expect(reached).toEqual(['Fahr los', 'Los geht’s', 'application']);
  });
});
