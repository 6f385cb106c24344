// @vitest-environment happy-dom
import { enableAutoUnmount, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import HintBubble from './HintBubble.vue';

enableAutoUnmount(afterEach);

/** A page with one button at this place, in px, and the hints for fingers. */
function page(box = new DOMRect(300, 100, 44, 44), around = '') {
  document.body.innerHTML = `<div ${around}><button title="Teilen">x</button></div><p>Text</p>`;
  const button = document.querySelector('button')!;
  const clicks: Event[] = [];
  button.addEventListener('click', (event) => clicks.push(event));
  button.getBoundingClientRect = () => box;
  button.parentElement!.getBoundingClientRect = () => new DOMRect(0, 0, 52, 400);
  const bubble = mount(HintBubble, { attachTo: document.body });
  const touch = (type: string, more: PointerEventInit = {}, target: Element = button) =>
    target.dispatchEvent(
      new PointerEvent(type, {
        bubbles: true,
        cancelable: true,
        pointerType: 'touch',
        clientX: 310,
        clientY: 110,
        ...more,
      }),
    );
  return { button, bubble, clicks, touch };
}
const after = async (ms: number): Promise<void> => {
  vi.advanceTimersByTime(ms);
  await nextTick();
};

describe('the hint for a finger', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('shows a control’s title once the finger has rested on it for half a second', async () => {
    const { bubble, touch } = page();
    touch('pointerdown');
    await after(499);
    expect(bubble.find('.bubble').exists()).toBe(false);
    await after(1);
    expect(bubble.get('.bubble').text()).toBe('Teilen');
    expect(bubble.get('.bubble').attributes('aria-hidden')).toBe('true');
  });

  it('stays for a moment after the finger has left, then goes', async () => {
    const { bubble, touch } = page();
    touch('pointerdown');
    await after(500);
    touch('pointerup');
    await after(1199);
    expect(bubble.find('.bubble').exists()).toBe(true);
    await after(1);
    expect(bubble.find('.bubble').exists()).toBe(false);
  });

  it('swallows the click of the tap that showed it, and no other', async () => {
    const { button, clicks, touch } = page();
    touch('pointerdown');
    await after(500);
    touch('pointerup');
    button.click();
    expect(clicks).toHaveLength(0);
    button.click();
    expect(clicks).toHaveLength(1);
  });

  it('does not keep a short tap from acting', async () => {
    const { button, bubble, clicks, touch } = page();
    touch('pointerdown');
    await after(200);
    touch('pointerup');
    button.click();
    await after(1000);
    expect(clicks).toHaveLength(1);
    expect(bubble.find('.bubble').exists()).toBe(false);
  });

  it('does not come when the finger moves on by more than 10 px: it scrolls', async () => {
    const { bubble, touch } = page();
    touch('pointerdown');
    touch('pointermove', { clientX: 310, clientY: 121 });
    await after(1000);
    expect(bubble.find('.bubble').exists()).toBe(false);
  });

  it('comes although the finger trembles by up to 10 px', async () => {
    const { bubble, touch } = page();
    touch('pointerdown');
    touch('pointermove', { clientX: 310, clientY: 120 });
    await after(500);
    expect(bubble.find('.bubble').exists()).toBe(true);
  });

  it('is for fingers only: a mouse sees the title itself', async () => {
    const { bubble, touch } = page();
    touch('pointerdown', { pointerType: 'mouse' });
    await after(1000);
    expect(bubble.find('.bubble').exists()).toBe(false);
  });

  it('does not come where there is no control', async () => {
    const { bubble, touch } = page();
    touch('pointerdown', {}, document.querySelector('p')!);
    await after(1000);
    expect(bubble.find('.bubble').exists()).toBe(false);
  });

  it('takes the place of the browser’s own menu on a control, and leaves it elsewhere', async () => {
    const { bubble, touch } = page();
    touch('pointerdown');
    expect(touch('contextmenu')).toBe(false); // prevented
    await nextTick();
    expect(bubble.find('.bubble').exists()).toBe(true);
    const text = document.querySelector('p')!;
    touch('pointerdown', {}, text);
    expect(touch('contextmenu', {}, text)).toBe(true);
  });

  it('stands below the control, and low on the screen above it', async () => {
    for (const [top, place] of [
      [100, '150px'],
      [700, '688px'],
    ] as const) {
      const { bubble, touch } = page(new DOMRect(300, top, 44, 44));
      touch('pointerdown');
      await after(500);
      const { style } = bubble.get<HTMLElement>('.bubble').element;
      expect([style.left, style.top]).toEqual(['322px', place]);
      bubble.unmount();
    }
  });

  it('keeps away from the edges of the screen', async () => {
    const { bubble, touch } = page(new DOMRect(0, 100, 44, 44));
    touch('pointerdown');
    await after(500);
    expect(bubble.get<HTMLElement>('.bubble').element.style.left).toBe('118px');
  });

  it('stands beside a column of tools', async () => {
    const { bubble, touch } = page(new DOMRect(4, 100, 44, 44), 'role="toolbar" aria-orientation="vertical"');
    touch('pointerdown');
    await after(500);
    const { style } = bubble.get<HTMLElement>('.bubble').element;
    expect([style.left, style.top]).toEqual(['60px', '100px']);
  });
});
