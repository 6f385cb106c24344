// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';

import { controls } from './controls';
import CtlButton from './CtlButton.vue';
import HeadingDial from './HeadingDial.vue';
import PaneSplitter from './PaneSplitter.vue';
import RangeSlider from './RangeSlider.vue';
import { LEVEL } from './tilt';
import TiltPad from './TiltPad.vue';

const global = { plugins: [controls] };
/** A square of 100 px with its corner at 0, 0: happy-dom has no layout. */
const square = (element: Element): void => {
  element.getBoundingClientRect = () => new DOMRect(0, 0, 100, 100);
};
const at = (clientX: number, clientY: number, more = {}) => ({ clientX, clientY, button: 0, pointerId: 1, ...more });

describe('a button of the page', () => {
  it('has a name for screen readers and shows it when the mouse rests on it', () => {
    const button = mount(CtlButton, { props: { label: 'Teilen', icon: 'M0 0' }, global });
    expect(button.attributes('aria-label')).toBe('Teilen');
    expect(button.attributes('title')).toBe('Teilen');
    expect(button.get('.page-icon').attributes('aria-hidden')).toBe('true');
  });

  it('does not say that it can stay pressed unless it can', async () => {
    const button = mount(CtlButton, { props: { label: 'Teilen' }, global });
    expect(button.attributes('aria-pressed')).toBeUndefined();
    await button.setProps({ pressed: false });
    expect(button.attributes('aria-pressed')).toBe('false');
    await button.setProps({ pressed: true });
    expect(button.attributes('aria-pressed')).toBe('true');
    expect(button.classes()).toContain('ctl--on');
  });

  it('does nothing while it is disabled', async () => {
    const clicks: unknown[] = [];
    const button = mount(CtlButton, {
      props: { label: 'Teilen', disabled: true, onClick: () => clicks.push(1) },
      global,
    });
    await button.trigger('click');
    expect(clicks).toEqual([]);
    await button.setProps({ disabled: false });
    await button.trigger('click');
    expect(clicks).toEqual([1]);
  });

  it('shows words beside its icon, or the icon alone', () => {
    const alone = mount(CtlButton, { props: { label: 'Teilen', icon: 'M0 0' }, global });
    const named = mount(CtlButton, { props: { label: 'Teilen', icon: 'M0 0' }, slots: { default: 'Link' }, global });
    expect(alone.classes()).toContain('ctl--icon');
    expect(named.classes()).not.toContain('ctl--icon');
    expect(named.text()).toBe('Link');
  });

  it('is named by the words that it shows, unless it has a longer name', async () => {
    const button = mount(CtlButton, { props: { text: 'Link', icon: 'M0 0' }, global });
    expect(button.classes()).not.toContain('ctl--icon');
    expect([button.text(), button.attributes('aria-label'), button.attributes('title')]).toEqual([
      'Link',
      'Link',
      'Link',
    ]);
    await button.setProps({ label: 'Link kopieren' });
    expect([button.text(), button.attributes('aria-label')]).toEqual(['Link', 'Link kopieren']);
  });
});

describe('a slider', () => {
  const props = { label: 'Temperatur', min: -5, max: 50, step: 1, value: 6, text: '6 °C' };

  it('has its name, its range and its value in words', () => {
    const slider = mount(RangeSlider, { props, global });
    const input = slider.get('input');
    expect(slider.element.tagName).toBe('LABEL');
    expect(slider.get('.name').text()).toBe('Temperatur');
    expect(slider.get('.value').text()).toBe('6 °C');
    expect(input.attributes()).toMatchObject({
      type: 'range',
      min: '-5',
      max: '50',
      step: '1',
      'aria-valuetext': '6 °C',
    });
  });

  it('is filled as far as the value lies in its range: 6 of −5 … 50 is a fifth', () => {
    const slider = mount(RangeSlider, { props, global });
    expect(slider.get('input').element.style.getPropertyValue('--share')).toBe('20%');
  });

  it('tells the number that it is moved to', async () => {
    const slider = mount(RangeSlider, { props, global });
    await slider.get('input').setValue('-3');
    expect(slider.emitted('change')).toEqual([[-3]]);
  });
});

describe('a bar between two panes', () => {
  const props = { label: 'Breite des Programms', axis: 'x', sign: 1, sizePx: 400, minPx: 300, maxPx: 500 } as const;

  it('says what it sets, where it stands and how far it goes, in whole px', () => {
    const bar = mount(PaneSplitter, { props: { ...props, sizePx: 400.4, minPx: 299.6 } });
    expect(bar.attributes()).toMatchObject({
      role: 'separator',
      tabindex: '0',
      'aria-label': 'Breite des Programms',
      'aria-orientation': 'vertical',
      'aria-valuenow': '400',
      'aria-valuemin': '300',
      'aria-valuemax': '500',
    });
  });

  it('follows the pointer from where it was taken', async () => {
    const bar = mount(PaneSplitter, { props });
    await bar.trigger('pointerdown', at(1000, 0));
    await bar.trigger('pointermove', at(1030, 0));
    await bar.trigger('pointermove', at(990, 0));
    expect(bar.emitted('resize')).toEqual([[430], [390]]);
  });

  it('goes no further than its limits', async () => {
    const bar = mount(PaneSplitter, { props });
    await bar.trigger('pointerdown', at(0, 0));
    await bar.trigger('pointermove', at(5000, 0));
    await bar.trigger('pointermove', at(-5000, 0));
    expect(bar.emitted('resize')).toEqual([[500], [300]]);
  });

  it('makes a pane smaller that lies on its other side', async () => {
    const bar = mount(PaneSplitter, { props: { ...props, sign: -1 } });
    await bar.trigger('pointerdown', at(0, 0));
    await bar.trigger('pointermove', at(30, 0));
    await bar.trigger('keydown', { key: 'ArrowRight' });
    expect(bar.emitted('resize')).toEqual([[370], [384]]);
  });

  it('follows nobody who has not taken it or has let go', async () => {
    const bar = mount(PaneSplitter, { props });
    await bar.trigger('pointermove', at(30, 0));
    for (const end of ['pointerup', 'pointercancel']) {
      await bar.trigger('pointerdown', at(0, 0));
      await bar.trigger(end, at(0, 0));
      await bar.trigger('pointermove', at(30, 0));
    }
    expect(bar.emitted('resize')).toBeUndefined();
  });

  it('is not taken by the right mouse button', async () => {
    const bar = mount(PaneSplitter, { props });
    await bar.trigger('pointerdown', at(0, 0, { button: 2 }));
    await bar.trigger('pointermove', at(30, 0));
    expect(bar.emitted('resize')).toBeUndefined();
  });

  it('moves by 16 px with the arrow keys along its way, and not with the others', async () => {
    const bar = mount(PaneSplitter, { props });
    for (const key of ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'a']) await bar.trigger('keydown', { key });
    expect(bar.emitted('resize')).toEqual([[384], [416]]);
    const level = mount(PaneSplitter, { props: { ...props, axis: 'y' } });
    for (const key of ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']) await level.trigger('keydown', { key });
    expect(level.emitted('resize')).toEqual([[384], [416]]);
    expect(level.attributes('aria-orientation')).toBe('horizontal');
  });

  it('takes the suggested size with Home and with a double click', async () => {
    const bar = mount(PaneSplitter, { props });
    await bar.trigger('keydown', { key: 'Home' });
    await bar.trigger('dblclick');
    expect(bar.emitted('resize')).toEqual([[null], [null]]);
  });
});

describe('a compass to turn', () => {
  const letters = ['N', 'O', 'S', 'W'] as const;
  const dialAt = (heading: number) => {
    const dial = mount(HeadingDial, { props: { heading, label: 'Kompass', text: `${heading}°`, letters } });
    square(dial.element);
    return dial;
  };

  it('says its name and where it points', () => {
    const dial = dialAt(90);
    expect(dial.attributes()).toMatchObject({
      role: 'slider',
      'aria-label': 'Kompass',
      'aria-valuenow': '90',
      'aria-valuetext': '90°',
    });
    expect(dial.findAll('text').map((it) => it.text())).toEqual(letters.slice());
  });

  it.each([
    ['north', 50, 0, 0],
    ['east', 100, 50, 90],
    ['south', 50, 100, 180],
    ['west', 0, 50, 270],
    ['north-east', 100, 0, 45],
  ])('dragged to the %s points there', async (_name, x, y, heading) => {
    const dial = dialAt(10);
    await dial.trigger('pointerdown', at(x, y));
    expect(dial.emitted('turn')).toEqual([[heading]]);
  });

  it('does not jump when its very middle is touched', async () => {
    const dial = dialAt(10);
    await dial.trigger('pointerdown', at(51, 51));
    expect(dial.emitted('turn')).toBeUndefined();
  });

  it('follows the pointer until it is let go', async () => {
    const dial = dialAt(10);
    await dial.trigger('pointermove', at(100, 50));
    await dial.trigger('pointerdown', at(50, 0));
    await dial.trigger('pointermove', at(100, 50));
    await dial.trigger('pointerup', at(100, 50));
    await dial.trigger('pointermove', at(50, 100));
    expect(dial.emitted('turn')).toEqual([[0], [90]]);
  });

  it('turns by 1° with the arrow keys and by 15° with the page keys, past north in both directions', async () => {
    const dial = dialAt(0);
    for (const key of ['ArrowRight', 'ArrowUp', 'ArrowLeft', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'x'])
      await dial.trigger('keydown', { key });
    expect(dial.emitted('turn')).toEqual([[1], [1], [359], [359], [15], [345], [0]]);
    const last = dialAt(359);
    await last.trigger('keydown', { key: 'ArrowRight' });
    expect(last.emitted('turn')).toEqual([[0]]);
  });
});

describe('a little board to tilt', () => {
  const padAt = (x: number, y: number, hasEdge = true) => {
    const props = { x, y, hasEdge, label: 'Neigung', help: 'Zieh die Platine.', text: 'flach' };
    const pad = mount(TiltPad, { props, attachTo: document.body });
    square(pad.get('[role="slider"]').element);
    return { pad, slider: pad.get('[role="slider"]') };
  };

  it('says its name, its tilt in words and how it is used', () => {
    const { pad, slider } = padAt(300, 0);
    expect(slider.attributes()).toMatchObject({
      'aria-label': 'Neigung',
      'aria-valuetext': 'flach',
      'aria-valuenow': '300',
    });
    expect(pad.get(`#${slider.attributes('aria-describedby')}`).text()).toBe('Zieh die Platine.');
  });

  it('says no more than a board at rest can feel', () => {
    expect(padAt(5000, 0).slider.attributes('aria-valuenow')).toBe('1024');
    expect(padAt(-5000, 0).slider.attributes('aria-valuenow')).toBe('-1024');
  });

  it('tapped at its right rim stands on its right edge: 1024 mg to the right, 0 into the back', async () => {
    const { pad, slider } = padAt(0, 0);
    await slider.trigger('pointerdown', at(100, 50));
    expect(pad.emitted('tilt')).toBeUndefined();
    await slider.trigger('pointerup', at(100, 50));
    expect(pad.emitted('tilt')).toEqual([[{ x: 1024, y: 0, z: 0 }]]);
  });

  it('dragged tilts all the time, once the finger has moved by more than 3 px', async () => {
    const { pad, slider } = padAt(0, 0);
    await slider.trigger('pointerdown', at(50, 50));
    await slider.trigger('pointermove', at(53, 50));
    expect(pad.emitted('tilt')).toBeUndefined();
    await slider.trigger('pointermove', at(75, 50));
    expect(pad.emitted('tilt')).toEqual([[{ x: 512, y: 0, z: -887 }]]);
    await slider.trigger('pointerup', at(75, 50));
    await slider.trigger('pointermove', at(90, 50));
    expect(pad.emitted('tilt')).toHaveLength(1);
  });

  it('lies flat after two quick taps', async () => {
    const { pad, slider } = padAt(0, 0);
    for (const tap of [1, 2]) {
      await slider.trigger('pointerdown', at(50 + tap, 80));
      await slider.trigger('pointerup', at(50 + tap, 80));
    }
    expect(pad.emitted('tilt')?.at(1)).toEqual([LEVEL]);
  });

  it('tilts a twentieth further with each arrow key, and lies flat with Home', async () => {
    const { pad, slider } = padAt(0, 0);
    for (const key of ['ArrowRight', 'ArrowLeft', 'ArrowDown', 'ArrowUp', 'Home', 'x'])
      await slider.trigger('keydown', { key });
    const z = -1023; // the rest of gravity
    expect(pad.emitted('tilt')).toEqual([
      [{ x: 51, y: 0, z }],
      [{ x: -51, y: 0, z }],
      [{ x: 0, y: 51, z }],
      [{ x: 0, y: -51, z }],
      [LEVEL],
    ]);
  });

  it('stops following when the browser takes the finger away', async () => {
    const { pad, slider } = padAt(0, 0);
    await slider.trigger('pointerdown', at(50, 50));
    await slider.trigger('pointercancel', at(50, 50));
    await slider.trigger('pointermove', at(90, 50));
    await slider.trigger('pointerup', at(90, 50));
    expect(pad.emitted('tilt')).toBeUndefined();
  });

  it('has the contacts of a micro:bit only for one', () => {
    expect(padAt(0, 0, true).pad.findAll('path')).toHaveLength(1);
    expect(padAt(0, 0, false).pad.findAll('path')).toHaveLength(0);
  });
});
