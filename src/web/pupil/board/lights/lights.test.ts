// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { show, startRun } from '../../../app/testing/run';
import LightChain from './LightChain.vue';
import LightChains from './LightChains.vue';
import LightList from './LightList.vue';

type Colors = readonly (readonly [number, number, number])[];
const dark = (count: number): Colors => Array.from({ length: count }, () => [0, 0, 0] as const);
const ringOf = (colors: Colors) => ({ lights: [{ pin: 'P2', colors }] });
/** A page whose program lights a chain on pin 2. */
function pageWith(robot: string) {
  const page = createPage();
  page.settings.change({ robot, device: 'microbit-v2' });
  return page;
}

describe('a chain of lights beside the board', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
  afterEach(() => void vi.useRealTimers());

  it('says its pin and how many lights it has', () => {
    const chain = mountOn(pageWith('none'), LightChain, { pin: 'P2', count: 12 });
    expect(textOf(chain.get('figcaption .name').element)).toBe('Pin 2 · 12 Lichter');
  });

  it('is a picture whose name says how many are lit, counted once a second', async () => {
    const page = pageWith('none');
    const chain = mountOn(page, LightChain, { pin: 'P2', count: 12 });
    const said = () => chain.get('canvas').attributes('aria-label');
    expect(said()).toBe('LED-Ring an Pin 2: 12 Lichter, 0 leuchten');
    await startRun(page);
    await show(page, ringOf([[255, 0, 0], [0, 0, 1], ...dark(10)]));
    expect(said()).toContain('0 leuchten');
    vi.advanceTimersByTime(1000);
    await nextTick();
    expect(said()).toBe('LED-Ring an Pin 2: 12 Lichter, 2 leuchten');
  });

  it('does not count another pin’s lights', async () => {
    const page = pageWith('none');
    const chain = mountOn(page, LightChain, { pin: 'P1', count: 12 });
    await startRun(page);
    await show(page, ringOf([[255, 0, 0]]));
    vi.advanceTimersByTime(1000);
    await nextTick();
    expect(chain.get('canvas').attributes('aria-label')).toContain('0 leuchten');
  });

  it('has the form that was chosen for its pin', async () => {
    const page = pageWith('none');
    page.settings.change({ lights: { P2: { form: 'strip' } } });
    const chain = mountOn(page, LightChain, { pin: 'P2', count: 12 });
    expect(chain.get('canvas').attributes('aria-label')).toContain('LED-Streifen an Pin 2');
    page.settings.change({ lights: { P2: { form: 'matrix' } } });
    await nextTick();
    expect(chain.get('canvas').attributes('aria-label')).toContain('LED-Matrix an Pin 2');
  });

  it('is drawn on the robot if it is there; here are only its words', () => {
    const page = pageWith('maqueen-lite');
    page.settings.change({ lights: { P2: { place: 'robot' } } });
    const chain = mountOn(page, LightChain, { pin: 'P2', count: 12 });
    expect(chain.find('canvas').exists()).toBe(false);
    expect(chain.get('.where').text()).toBe('auf dem Roboter');
    expect(chain.get('.vh').text()).toBe('LED-Ring an Pin 2: 12 Lichter, 0 leuchten');
  });

  it('lies beside the board again where there is no robot to lie on', () => {
    const page = pageWith('none');
    page.settings.change({ lights: { P2: { place: 'robot' } } });
    const chain = mountOn(page, LightChain, { pin: 'P2', count: 12 });
    expect(chain.find('canvas').exists()).toBe(true);
  });

  it('stands among the others, one for each pin', () => {
    const chains = mountOn(pageWith('none'), LightChains, { counts: { P1: 8, P2: 12 } });
    expect(chains.findAll('figcaption .name').map((it) => textOf(it.element))).toEqual([
      'Pin 1 · 8 Lichter',
      'Pin 2 · 12 Lichter',
    ]);
  });

  it('has a menu to change it', async () => {
    vi.useRealTimers();
    mountOn(pageWith('none'), LightChain, { pin: 'P2', count: 12 });
    named('Form und Platz ändern').click();
    const menu = await vi.waitFor(() => named('Lichterkette an Pin 2', '[role="menu"]'), 20_000);
    expect(menu.textContent).toContain('Zickzack');
  });
});

describe('form and place of a chain', () => {
  const checked = () =>
    [...document.querySelectorAll('[role="menuitemradio"][aria-checked="true"]')].map((it) => textOf(it));

  it('are two groups with what is chosen marked', () => {
    mountOn(pageWith('maqueen-lite'), LightList, { pin: 'P2', form: 'ring', place: 'board', hasRobot: true });
    expect(checked()).toEqual(['Ring', 'Neben dem Mikrocomputer']);
    named('Form', '[role="group"]');
    named('Platz', '[role="group"]');
  });

  it('are the form alone without a robot', () => {
    mountOn(pageWith('none'), LightList, { pin: 'P2', form: 'strip', place: 'board', hasRobot: false });
    expect(checked()).toEqual(['Streifen']);
    expect(document.querySelectorAll('[role="group"]')).toHaveLength(1);
  });

  it('are kept for their pin, the other choice and the other pins as they were', () => {
    const page = pageWith('maqueen-lite');
    page.settings.change({ lights: { P1: { form: 'zigzag' } } });
    mountOn(page, LightList, { pin: 'P2', form: 'ring', place: 'board', hasRobot: true });
    named('Auf dem Roboter', '[role="menuitemradio"]').click();
    named('Streifen', '[role="menuitemradio"]').click();
    expect(page.settings.current.value.lights).toEqual({
      P1: { form: 'zigzag' },
      P2: { place: 'robot', form: 'strip' },
    });
  });
});
