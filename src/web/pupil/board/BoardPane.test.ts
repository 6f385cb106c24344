// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { inputsOf, show, startRun } from '../../app/testing/run';
import BoardPane from './BoardPane.vue';

/** A page with a program for the bare board, its pane, and the board's drawing in it. */
async function pane(device = 'microbit-v2', wish: Parameters<typeof createPage>[0] = {}) {
  const page = createPage(wish);
  page.settings.change({ device, robot: 'none', panel: null, showCard: false });
  const mounted = mountOn(page, BoardPane);
  await flushPromises();
  return { page, mounted };
}
const held = (name: string) => named(name, '.face [role="button"]').getAttribute('aria-pressed');

describe('the pane of the microcomputer', () => {
  // The drawings come late; here they are there at once.
  beforeAll(() =>
    Promise.all([
      import('./WholeBoard.vue'),
      import('./drawing/MicrobitView.vue'),
      import('./drawing/CalliopeView.vue'),
    ]),
  );

  it('is called by the device that is chosen', async () => {
    const { page, mounted } = await pane();
    expect(mounted.attributes('aria-label')).toBe('Mikrocomputer');
    expect(mounted.get('h2').text()).toBe('micro:bit V2');
    page.settings.change({ device: 'calliope-mini-3' });
    await nextTick();
    expect(mounted.get('h2').text()).toBe('Calliope mini 3');
  });

  it('names every key of a micro:bit for screen readers', async () => {
    const { mounted } = await pane();
    const names = mounted.findAll('.face [role="button"]').map((it) => it.attributes('aria-label'));
    expect(names).toEqual(['Taste A', 'Taste B', 'Logo berühren', ...[0, 1, 2].map((pin) => `Pin ${pin} berühren`)]);
  });

  it('shows the display as rows of digits, dark until a run is there', async () => {
    const { page } = await pane();
    const row = '0 0 0 0 0';
    named(`Anzeige: ${[row, row, row, row, row].join(', ')}`, '[role="img"]');
    await startRun(page);
    await show(page, { display: Array.from({ length: 25 }, (_, place) => (place === 7 ? 9 : 0)) });
    named(`Anzeige: ${[row, '0 0 9 0 0', row, row, row].join(', ')}`, '[role="img"]');
  });

  it('says what a device is not whose picture is another’s', async () => {
    const { mounted } = await pane('calliope-mini-2');
    expect(textOf(mounted.get('.about').element)).toBe(
      'Das Bild zeigt den mini 3. Deiner hat ein Farblicht, kein Logo zum Berühren und weniger Speicher.',
    );
    const other = await pane('calliope-mini-3');
    expect(other.mounted.find('.about').exists()).toBe(false);
  });

  it('says which keys of the keyboard press the board, until something is unfolded below', async () => {
    const { page, mounted } = await pane();
    expect(mounted.get('.hint').text()).toBe('Auf der Tastatur: a, b und l (Logo)');
    page.settings.change({ panel: 'radio' });
    await nextTick();
    expect(mounted.find('.hint').exists()).toBe(false);
  });

  it('can be hidden, but not on a phone, where it has a tab of its own', async () => {
    const { page } = await pane();
    named('Mikrocomputer ausblenden').click();
    expect(page.settings.current.value.showBoard).toBe(false);
    setWindow(390, 800);
    const phone = await pane();
    expect(phone.mounted.find('[aria-label="Mikrocomputer ausblenden"]').exists()).toBe(false);
  });

  it('cannot be hidden where a host says what is shown', async () => {
    const { mounted } = await pane('microbit-v2', { settings: { parts: ['board', 'arena'] } });
    expect(mounted.find('[aria-label="Mikrocomputer ausblenden"]').exists()).toBe(false);
  });

  it('shows a key pressed that the run knows as pressed: on the keyboard, by a host', async () => {
    const { page } = await pane();
    await startRun(page);
    await show(page, { buttons: { a: true, b: false }, touch: { pinLogo: true } });
    expect([held('Taste A'), held('Taste B'), held('Logo berühren')]).toEqual(['true', 'false', 'true']);
  });

  it('says when the board sleeps or has switched itself off', async () => {
    const { page, mounted } = await pane();
    await startRun(page);
    await show(page, { power: 'asleep' });
    expect(mounted.get('svg.microbit').attributes('aria-label')).toBe('micro:bit V2, schläft');
    await show(page, { power: 'off' });
    expect(mounted.get('svg.microbit').attributes('aria-label')).toBe('micro:bit V2, ausgeschaltet');
    await show(page, { power: 'on' });
    expect(mounted.get('svg.microbit').attributes('aria-label')).toBe('micro:bit V2');
  });

  it('says that the microphone listens and that the loudspeaker plays', async () => {
    const { page, mounted } = await pane();
    const said = () => mounted.findAll('.face [role="img"]').map((it) => it.attributes('aria-label'));
    await startRun(page);
    await show(page, { microphoneOn: true, isSounding: true });
    expect(said()).toEqual(expect.arrayContaining(['Mikrofon hört zu', 'Lautsprecher spielt']));
    await show(page, {});
    expect(said()).not.toEqual(expect.arrayContaining(['Mikrofon hört zu']));
  });

  it('is silent while the run makes a pause', async () => {
    const { page, mounted } = await pane();
    await startRun(page);
    await show(page, { isSounding: true });
    page.run.pause();
    await nextTick();
    expect(mounted.find('[aria-label="Lautsprecher spielt"]').exists()).toBe(false);
  });

  it('shows the Calliope’s lights and motors in numbers as well', async () => {
    const { page } = await pane('calliope-mini-3');
    await startRun(page);
    page.run.pause(); // the wheels stand still
    await show(page, {
      board: 'calliope-mini-3',
      rgb: [
        [255, 0, 0],
        [0, 0, 0],
        [0, 0, 9],
      ],
      motors: [0.6, -0.25],
    });
    const said = [...document.querySelectorAll('[role="img"]')].map((it) => it.getAttribute('aria-label') ?? '');
    expect(said.find((it) => it.startsWith('Farblichter'))).toContain('255');
    const motors = said.find((it) => it.startsWith('Motoren'));
    expect(motors).toContain('60 %');
    expect(motors).toContain('−25 %');
  });
});

describe('a finger on the board', () => {
  beforeAll(() => Promise.all([import('./WholeBoard.vue'), import('./drawing/MicrobitView.vue')]));
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
  afterEach(() => void vi.useRealTimers());
  const finger = (type: string, name: string, pointerId = 1) =>
    named(name, '.face [role="button"], .keys button').dispatchEvent(
      new PointerEvent(type, { pointerId, button: 0, bubbles: true }),
    );
  const pressed = (page: ReturnType<typeof createPage>) =>
    inputsOf(page).map((it) =>
      it.type === 'button' ? `${it.button} ${it.down}` : it.type === 'touch' ? `${it.pad} ${it.down}` : it.type,
    );

  it('presses a button and lets it go in the run', async () => {
    const { page } = await pane();
    await startRun(page);
    finger('pointerdown', 'Taste A');
    expect(pressed(page)).toEqual(['a true']);
    vi.advanceTimersByTime(500);
    finger('pointerup', 'Taste A');
    expect(pressed(page)).toEqual(['a true', 'a false']);
  });

  it('touches the logo or a pin instead of pressing it', async () => {
    const { page } = await pane();
    await startRun(page);
    finger('pointerdown', 'Logo berühren');
    finger('pointerdown', 'Pin 1 berühren', 2);
    expect(pressed(page)).toEqual(['pinLogo true', 'pin1 true']);
  });

  it('presses both on A + B', async () => {
    const { page } = await pane();
    await startRun(page);
    finger('pointerdown', 'Tasten A + B zusammen');
    expect(pressed(page)).toEqual(['a true', 'b true']);
    vi.advanceTimersByTime(500);
    finger('pointerup', 'Tasten A + B zusammen');
    expect(pressed(page)).toEqual(['a true', 'b true', 'a false', 'b false']);
  });

  it('is passed on to the run as it is if it taps very quickly: the run makes the press last long enough', async () => {
    const { page } = await pane();
    await startRun(page);
    finger('pointerdown', 'Taste B');
    finger('pointerup', 'Taste B');
    expect(pressed(page)).toEqual(['b true', 'b false']);
  });

  it('reaches nothing without a run, but is seen', async () => {
    const { page } = await pane();
    finger('pointerdown', 'Taste A');
    await nextTick();
    expect(pressed(page)).toEqual([]);
    expect(held('Taste A')).toBe('true');
  });

  it('lets go when the window loses the keyboard', async () => {
    const { page } = await pane();
    await startRun(page);
    finger('pointerdown', 'Taste A');
    vi.advanceTimersByTime(500);
    window.dispatchEvent(new Event('blur'));
    expect(pressed(page)).toEqual(['a true', 'a false']);
  });

  it('lets go when the pane goes away, however short the press was', async () => {
    const { page, mounted } = await pane();
    await startRun(page);
    finger('pointerdown', 'Taste A');
    mounted.vm.$.parent?.appContext.app.unmount();
    expect(pressed(page)).toEqual(['a true', 'a false']);
  });

  it('presses the key that has the focus with the space bar or Enter, once however long it is held', async () => {
    const { page } = await pane();
    await startRun(page);
    const key = named('Taste A', '.face [role="button"]');
    const type = (kind: string, name: string, repeat = false) =>
      key.dispatchEvent(new KeyboardEvent(kind, { key: name, repeat, bubbles: true, cancelable: true }));
    expect(type('keydown', ' ')).toBe(false);
    type('keydown', ' ', true);
    vi.advanceTimersByTime(500);
    type('keyup', ' ');
    type('keydown', 'x');
    vi.advanceTimersByTime(500);
    type('keydown', 'Enter');
    expect(pressed(page)).toEqual(['a true', 'a false', 'a true']);
  });

  it('presses for 200 ms by a mere click, as of a screen reader', async () => {
    const { page } = await pane();
    await startRun(page);
    named('Taste A', '.face [role="button"]').dispatchEvent(new MouseEvent('click', { detail: 0, bubbles: true }));
    vi.advanceTimersByTime(199);
    expect(pressed(page)).toEqual(['a true']);
    vi.advanceTimersByTime(1);
    expect(pressed(page)).toEqual(['a true', 'a false']);
  });
});

describe('the microcomputer in the micro:bit foundation’s editor', () => {
  beforeAll(() => Promise.all([import('./WholeBoard.vue'), import('./drawing/MicrobitView.vue')]));

  it('is the drawing alone: the host has the buttons, the panels and the heading', async () => {
    const { mounted } = await pane('microbit-v2', { dialect: 'microbit' });
    expect(mounted.find('h2').exists()).toBe(false);
    expect(mounted.find('.keys').exists()).toBe(false);
    expect(mounted.find('[data-testid="panel-sensors"]').exists()).toBe(false);
  });

  it('pales while nothing runs', async () => {
    const { page, mounted } = await pane('microbit-v2', { dialect: 'microbit' });
    expect(mounted.classes()).toContain('pale');
    await startRun(page);
    expect(mounted.classes()).not.toContain('pale');
  });

  it('is called by the words of the host', async () => {
    const labels = { 'button-a': 'Press A', 'touch-logo': 'Touch logo' };
    const { mounted } = await pane('microbit-v2', { dialect: 'microbit', settings: { labels } });
    const names = mounted.findAll('.face [role="button"]').map((it) => it.attributes('aria-label'));
    expect(names.slice(0, 3)).toEqual(['Press A', 'Taste B', 'Touch logo']);
  });
});
