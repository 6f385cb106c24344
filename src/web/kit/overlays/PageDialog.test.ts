// @vitest-environment happy-dom
import { enableAutoUnmount, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { h, nextTick } from 'vue';

import PageDialog from './PageDialog.vue';

enableAutoUnmount(afterEach);
beforeEach(() => {
  document.body.innerHTML = '<button id="before"></button>';
  document.getElementById('before')?.focus();
});

async function dialog(props: Readonly<Record<string, unknown>> = {}) {
  const mounted = mount(PageDialog, {
    props: { modelValue: true, ...props },
    attrs: { 'aria-label': 'Frage' },
    attachTo: document.body,
    slots: { default: () => ['eins', 'zwei', 'drei'].map((id) => h('button', { id })) },
  });
  await nextTick();
  await nextTick();
  return { mounted, asked: () => mounted.emitted('update:modelValue')?.length ?? 0 };
}
const shown = () => document.querySelector('[role=dialog]');
const focused = () => document.activeElement?.id;
async function press(key: string, shiftKey = false): Promise<void> {
  const event = new KeyboardEvent('keydown', { key, shiftKey, bubbles: true, cancelable: true });
  document.activeElement?.dispatchEvent(event);
  await nextTick();
}
async function click(element: Element | null): Promise<void> {
  element?.dispatchEvent(new Event('pointerdown', { bubbles: true }));
  (element as HTMLElement).click();
  await new Promise((done) => setTimeout(done));
}

describe('a dialog', () => {
  it('says what it is, and has the keyboard', async () => {
    await dialog();
    expect(shown()?.getAttribute('aria-modal')).toBe('true');
    expect(shown()?.getAttribute('aria-label')).toBe('Frage');
    expect(shown()?.contains(document.activeElement)).toBe(true);
  });

  it('keeps the keyboard: Tab goes round in it, both ways', async () => {
    await dialog();
    const seen: (string | undefined)[] = [];
    await press('Tab', true);
    seen.push(focused());
    await press('Tab');
    seen.push(focused());
    await press('Tab', true);
    seen.push(focused());
    document.getElementById('before')?.focus();
    await press('Tab');
    seen.push(focused());
    expect(seen).toEqual(['drei', 'eins', 'drei', 'eins']);
  });

  it('asks to be closed with Escape and with a click beside it, not with one inside', async () => {
    const { asked } = await dialog();
    await press('Escape');
    expect(asked()).toBe(1);
    await click(document.getElementById('zwei'));
    expect(asked()).toBe(1);
    await click(document.querySelector('.page-overlay__scrim'));
    expect(asked()).toBe(2);
  });

  it('stays while it must be seen to its end', async () => {
    const { asked } = await dialog({ persistent: true });
    await press('Escape');
    await click(document.querySelector('.page-overlay__scrim'));
    expect(asked()).toBe(0);
  });

  it('gives the keyboard back to where it was, also when it is taken off the page', async () => {
    const { mounted } = await dialog();
    await mounted.setProps({ modelValue: false });
    await nextTick();
    expect([shown()?.textContent ?? '', focused()]).toEqual(['', 'before']);
    await mounted.setProps({ modelValue: true });
    await nextTick();
    expect(focused()).not.toBe('before');
    mounted.unmount();
    await nextTick();
    await nextTick();
    expect([shown(), focused()]).toEqual([null, 'before']);
  });

  it('does not close the one below it with the same Escape', async () => {
    const below = await dialog();
    const above = await dialog();
    await press('Escape');
    expect([below.asked(), above.asked()]).toEqual([0, 1]);
  });
});
