// @vitest-environment happy-dom
import { enableAutoUnmount, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { h, nextTick } from 'vue';

import PageListItem from '../controls/PageListItem.vue';
import PageList from '../controls/PageList.vue';
import PageMenu from './PageMenu.vue';

enableAutoUnmount(afterEach);
beforeEach(() => {
  document.body.innerHTML = '<section id="menus"></section><button id="elsewhere"></button>';
});

const chosen = vi.fn();
const entry = (title: string, disabled = false) =>
  h(PageListItem, { title, disabled, role: 'menuitem', onClick: () => void chosen(title) });

/** A menu of four entries, the third of which cannot be chosen, and its button. */
function menu(props: Readonly<Record<string, unknown>> = {}, below?: () => unknown) {
  const mounted = mount(PageMenu, {
    props,
    attachTo: document.body,
    slots: {
      activator: ({ props: given }: { props: Record<string, unknown> }) => h('button', { id: 'opener', ...given }),
      default: () => [
        h(PageList, { role: 'menu' }, () => [entry('Eins'), entry('Zwei'), entry('Drei', true), entry('Vier')]),
        below?.(),
      ],
    },
  });
  const button = mounted.get<HTMLButtonElement>('#opener');
  button.element.focus();
  return { mounted, button };
}
const list = () => document.querySelector<HTMLElement>('#menus [role=menu]');
const focused = () => document.activeElement?.textContent ?? '';
async function press(key: string, shiftKey = false): Promise<KeyboardEvent> {
  const event = new KeyboardEvent('keydown', { key, shiftKey, bubbles: true, cancelable: true });
  document.activeElement?.dispatchEvent(event);
  await nextTick();
  await nextTick();
  return event;
}
async function click(element: Element): Promise<void> {
  element.dispatchEvent(new Event('pointerdown', { bubbles: true }));
  (element as HTMLElement).click();
  await new Promise((done) => setTimeout(done));
  await nextTick();
}

describe('a menu', () => {
  it('opens and closes with its button, in the landmark for menus, and its button says so', async () => {
    const { button } = menu();
    expect(button.attributes()).toMatchObject({ 'aria-haspopup': 'menu', 'aria-expanded': 'false' });
    await click(button.element);
    expect(list()).not.toBeNull();
    expect(button.attributes('aria-expanded')).toBe('true');
    expect(document.getElementById(button.attributes('aria-controls') ?? '')?.contains(list())).toBe(true);
    await click(button.element);
    expect(list()).toBeNull();
  });

  it('opens with arrow down at its first entry, and with arrow up at its last', async () => {
    menu();
    await press('ArrowDown');
    await vi.waitFor(() => expect(focused()).toBe('Eins'));
    await press('Escape');
    await press('ArrowUp');
    await vi.waitFor(() => expect(focused()).toBe('Vier'));
  });

  it('is walked through with the arrow keys, Home and End, past what cannot be chosen, and round its ends', async () => {
    menu();
    await press('ArrowDown');
    await vi.waitFor(() => expect(focused()).toBe('Eins'));
    const seen: string[] = [];
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowUp', 'Home', 'End', 'ArrowUp']) {
      await press(key);
      seen.push(focused());
    }
    expect(seen).toEqual(['Zwei', 'Vier', 'Eins', 'Vier', 'Eins', 'Vier', 'Zwei']);
  });

  it.each(['Enter', ' '])('takes the entry at the keyboard with %j, and gives the keyboard back', async (key) => {
    const { button } = menu();
    await press('ArrowDown');
    await vi.waitFor(() => expect(focused()).toBe('Eins'));
    await press(key);
    expect(chosen).toHaveBeenLastCalledWith('Eins');
    expect(list()).toBeNull();
    expect(document.activeElement).toBe(button.element);
  });

  it('closes with Escape and gives the keyboard back', async () => {
    const { button } = menu();
    await press('ArrowDown');
    await vi.waitFor(() => expect(focused()).toBe('Eins'));
    await press('Escape');
    expect(list()).toBeNull();
    expect(document.activeElement).toBe(button.element);
  });

  it('is entered with Tab from its button, and left with Tab at its end, from the button on', async () => {
    const { button } = menu();
    await click(button.element);
    expect((await press('Tab')).defaultPrevented).toBe(true);
    expect(focused()).toBe('Eins');
    expect((await press('Tab')).defaultPrevented).toBe(false); // the browser goes on from the button
    expect([list(), document.activeElement]).toEqual([null, button.element]);
  });

  it('stays open with Tab from its entries to what follows them, and with Tab back', async () => {
    menu({ closeOnContentClick: false }, () => h('button', { id: 'below' }, 'Mehr'));
    await press('ArrowDown');
    await vi.waitFor(() => expect(focused()).toBe('Eins'));
    await press('Tab');
    expect(list()).not.toBeNull();
    document.getElementById('below')?.focus();
    await nextTick();
    await press('Tab', true);
    expect(list()).not.toBeNull();
    await press('Tab');
    expect(list()).toBeNull();
  });

  it('closes with a click beside it, and leaves the keyboard where that click put it', async () => {
    const { button } = menu();
    await click(button.element);
    const elsewhere = document.getElementById('elsewhere')!;
    elsewhere.focus();
    await click(elsewhere);
    expect([list(), document.activeElement]).toEqual([null, elsewhere]);
  });

  it('stays open after a choice where it holds settings', async () => {
    const { button } = menu({ closeOnContentClick: false });
    await click(button.element);
    await click(list()!.querySelector('.page-list-item')!);
    expect(list()).not.toBeNull();
  });

  it('takes everything with it when it leaves the page while it is open', async () => {
    const { mounted, button } = menu();
    await click(button.element);
    mounted.unmount();
    expect(document.getElementById('menus')?.childElementCount).toBe(0);
    const above = menu(); // what is opened next is on top, and hears Escape
    await click(above.button.element);
    await press('Escape');
    expect(list()).toBeNull();
  });
});
