// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { noLocks } from '#check/task/task';
import type { LidarState } from '#robots/robot';
import { lidarOf } from '#robots/testing/lidar-of';

import { mountOn, named, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { inputsOf, show, startRun } from '../../../app/testing/run';
import type { TaskLocks } from '../../../session/work/model/task-locks';
import { robotOf } from '../../narration/testing/drive';
import { newBoard } from '../../several-devices/new-device';
import SensorPanel from './SensorPanel.vue';

/** The panel of the sensors for a bare board, or for one on a robot. */
function panel(robot = 'none', device = 'microbit-v2') {
  const page = createPage();
  page.settings.change({ robot, device });
  const mounted = mountOn(page, SensorPanel);
  const slider = (name: string) => {
    const found = [...(mounted.element as HTMLElement).querySelectorAll<HTMLElement>('label.slider')].find(
      (it) => it.querySelector('.name')?.textContent === name,
    );
    if (found === undefined) throw new Error(`No slider ${name}.`);
    return {
      text: () => found.querySelector('.value')?.textContent,
      move: async (value: number) => {
        const input = found.querySelector('input')!;
        input.value = String(value);
        input.dispatchEvent(new Event('input'));
        await nextTick();
      },
    };
  };
  return { page, mounted, slider };
}
const button = (name: string) => named(name, 'button') as HTMLButtonElement;
const sensed = (page: ReturnType<typeof createPage>) =>
  inputsOf(page).map((it) => (it.type === 'sensor' ? `${it.id} ${it.value}` : it.type));

describe('what the board feels, set by hand', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
  afterEach(() => void vi.useRealTimers());

  it('is at first what a board on a table feels', () => {
    const { slider } = panel();
    expect(slider('Temperatur').text()).toBe('21 °C');
    expect(slider('Lichtstärke').text()).toBe('127');
    expect(slider('Schallpegel').text()).toBe('0');
  });

  it('is what the next run starts with if it is set before a run', async () => {
    const { page, slider } = panel();
    await slider('Temperatur').move(-3);
    expect(slider('Temperatur').text()).toBe('−3 °C');
    expect(sensed(page)).toEqual([]);
    await page.run.start();
    const run = page.sent.find((message) => message.type === 'run');
    expect(JSON.stringify(run)).toContain('{"type":"sensor","id":"temperature","value":-3}');
  });

  it('is nothing where the open task does without the hand, and says so', async () => {
    const { page, mounted, slider } = panel();
    page.work.locks.task.value = {
      locks: { ...noLocks, hand: true },
      refusesInput: () => true,
    } as unknown as TaskLocks;
    await nextTick();
    expect(textOf((mounted.element as HTMLElement).querySelector('[data-testid="sensors-kept"]'))).toContain('Hand');
    const sliders = [...(mounted.element as HTMLElement).querySelectorAll<HTMLElement>('label.slider')];
    expect(sliders.map((it) => it.inert)).toEqual([true, true, true]);
    await slider('Temperatur').move(-3);
    expect(slider('Temperatur').text()).toBe('21 °C');
  });

  it('reaches a run that is under way at once', async () => {
    const { page, slider } = panel();
    await startRun(page);
    await slider('Lichtstärke').move(200);
    expect(sensed(page)).toEqual(['lightLevel 200']);
  });

  it('is shown at once, and later what the run tells: half a second after the hand', async () => {
    const { page, slider } = panel();
    await startRun(page);
    await slider('Lichtstärke').move(200);
    await show(page, { sensors: { lightLevel: 127 }, timeUs: 1 }); // the run has not taken it in
    expect(slider('Lichtstärke').text()).toBe('200');
    vi.advanceTimersByTime(500);
    await show(page, { sensors: { lightLevel: 90 }, timeUs: 2 });
    vi.advanceTimersByTime(500);
    await nextTick();
    expect(slider('Lichtstärke').text()).toBe('90');
  });

  it('can be taken back all at once, and only when something was set', async () => {
    const { page, slider } = panel();
    expect(button('Alle Sensoren zurücksetzen').disabled).toBe(true);
    await startRun(page);
    await slider('Temperatur').move(40);
    await slider('Schallpegel').move(99);
    expect(button('Alle Sensoren zurücksetzen').disabled).toBe(false);
    button('Alle Sensoren zurücksetzen').click();
    await nextTick();
    expect(sensed(page).slice(2)).toEqual(['temperature 21', 'soundLevel 0']);
    expect(slider('Temperatur').text()).toBe('21 °C');
    expect(button('Alle Sensoren zurücksetzen').disabled).toBe(true);
  });

  it('is told along three axes when the little board is tilted: all at once', async () => {
    const { page } = panel();
    await startRun(page);
    named('Neigung', '[role="slider"]').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));
    expect(sensed(page)).toEqual(['accelerometerX 51', 'accelerometerY 0', 'accelerometerZ -1023']);
    await nextTick();
    expect(named('Neigung', '[role="slider"]').getAttribute('aria-valuetext')).toContain('51 nach rechts');
  });

  it('is a direction when the compass is turned', async () => {
    const { page } = panel();
    await startRun(page);
    named('Kompass', '[role="slider"]').dispatchEvent(new KeyboardEvent('keydown', { key: 'PageUp' }));
    expect(sensed(page)).toEqual(['compassHeading 15']);
    await nextTick();
    expect(named('Kompass', '[role="slider"]').getAttribute('aria-valuetext')).toBe('15°');
  });

  it('writes north where the run says 360°', async () => {
    const { page } = panel();
    await startRun(page);
    await show(page, { sensors: { compassHeading: 360 } });
    expect(named('Kompass', '[role="slider"]').getAttribute('aria-valuenow')).toBe('0');
  });

  it('has every axis for itself, in its own unit', async () => {
    const { page, slider } = panel();
    await startRun(page);
    await slider('Beschleunigung Z').move(-1000);
    await slider('Magnetfeld X').move(30_000);
    expect(sensed(page)).toEqual(['accelerometerZ -1000', 'compassX 30000']);
    expect(slider('Beschleunigung Z').text()).toMatch(/^−1.?000 mg$/);
  });
});

describe('gestures and keys to hold', () => {
  it('work while the program runs, and say so before', async () => {
    const { page, mounted } = panel();
    const all = () => mounted.findAll<HTMLButtonElement>('.keys button, [data-testid="shake"]');
    expect(all().length).toBeGreaterThan(8);
    expect(all().every((it) => it.element.disabled)).toBe(true);
    const { id } = mounted.get('.note--shake').element;
    expect(button('Schütteln').getAttribute('aria-describedby')).toBe(id);
    expect(mounted.get('.note--shake').text()).toBe('Gesten und Tasten wirken, während das Programm läuft.');
    await startRun(page);
    expect(all().some((it) => it.element.disabled)).toBe(false);
    expect(button('Schütteln').getAttribute('aria-describedby')).toBeNull();
  });

  it('tell the program each time', async () => {
    const { page } = panel();
    await startRun(page);
    button('Schütteln').click();
    button('Schütteln').click();
    button('freier Fall').click();
    expect(sensed(page)).toEqual(['gesture shake', 'gesture shake', 'gesture freefall']);
  });

  it('are not kept for the next run', async () => {
    const { page } = panel();
    await startRun(page);
    button('Schütteln').click();
    await nextTick();
    expect(button('Alle Sensoren zurücksetzen').disabled).toBe(true);
  });

  it('keep a key down until it is tapped again', async () => {
    const { page } = panel();
    await startRun(page);
    await show(page, {});
    const key = button('Taste A');
    expect(key.getAttribute('aria-pressed')).toBe('false');
    key.click();
    await show(page, { buttons: { a: true, b: false } });
    expect(key.getAttribute('aria-pressed')).toBe('true');
    key.click();
    expect(inputsOf(page)).toEqual([
      { type: 'button', button: 'a', down: true },
      { type: 'button', button: 'a', down: false },
    ]);
  });

  it('keep the logo and the pins touched that this board has', async () => {
    const { page } = panel('none', 'calliope-mini-3');
    await startRun(page);
    button('Logo berühren').click();
    button('P3: Pin 3 berühren').click();
    expect(inputsOf(page)).toEqual([
      { type: 'touch', pad: 'pinLogo', down: true },
      { type: 'touch', pad: 'pin3', down: true },
    ]);
    const microbit = panel();
    expect(microbit.mounted.find('[aria-label="P3: Pin 3 berühren"]').exists()).toBe(false);
  });
});

describe('what the arena tells the board', () => {
  it('is a switch that is there only for a board on a robot', () => {
    const bare = panel();
    expect(bare.mounted.find('[role="switch"]').exists()).toBe(false);
    const robot = panel('maqueen-lite');
    const arena = robot.mounted.get('[role="switch"]');
    expect(arena.text()).toBe('Aus der Arena');
    expect(robot.mounted.get(`#${arena.attributes('aria-describedby')}`).text()).toBe(
      'Kompass, Stösse und Licht vom Boden kommen aus der Arena.',
    );
  });

  it('is switched for this run and the next ones', async () => {
    const { page, mounted } = panel('maqueen-lite');
    const before = page.settings.current.value.arenaSenses;
    await startRun(page);
    await mounted.get('[role="switch"]').trigger('click');
    expect(page.settings.current.value.arenaSenses).toBe(!before);
    expect(mounted.get('[role="switch"]').attributes('aria-checked')).toBe(String(!before));
    expect(inputsOf(page)).toEqual([{ type: 'arena-senses', on: !before }]);
  });

  it('is there for every one of several devices, and switches the senses of all', async () => {
    const { page, mounted } = panel('none');
    expect(mounted.find('[role="switch"]').exists()).toBe(false);
    page.work.addDevice({ ...newBoard(page), name: 'Zwei' }, 'Eins');
    await nextTick();
    expect(textOf(mounted.get('.note--arena').element)).toBe('Das Mikrofon hört die anderen Geräte.');
    await startRun(page);
    await mounted.get('[role="switch"]').trigger('click');
    const reached = page.sent.flatMap((message) => (message.type === 'input' ? [message.device] : []));
    expect(reached).toEqual([undefined, 'Zwei']);
  });
});

describe('the picture of a lidar', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
  afterEach(() => void vi.useRealTimers());

  /** The panel in a run whose robot sees this. */
  async function seeing(lidar: LidarState | null) {
    const { page, mounted } = panel('maqueen-lite');
    await startRun(page);
    const robot = robotOf({});
    await show(page, { robot: { ...robot, state: { ...robot.state, lidar } } });
    await vi.dynamicImportSettled();
    return { page, cells: () => mounted.findAll('[role="cell"]').map((cell) => cell.text()) };
  }
  const row = [420, 440, 450, 460, 470, 320, 230, 180];

  it('is not there for a robot without one', async () => {
    const { cells } = await seeing(null);
    expect(cells()).toEqual([]);
  });

  it('is in cm, and in mm where that was chosen, also later', async () => {
    const { page, cells } = await seeing(lidarOf({ row }));
    expect(cells().slice(24, 32)).toEqual(['42', '44', '45', '46', '47', '32', '23', '18']);
    document.querySelector<HTMLInputElement>('[data-testid="lidar-unit-mm"]')?.click();
    await nextTick();
    expect(cells()[31]).toBe('180');
    expect(page.settings.current.value.lidarUnit).toBe('mm');
  });

  it('is renewed ten times a second at most', async () => {
    const { page, cells } = await seeing(lidarOf({ row }));
    const robot = robotOf({});
    await show(page, { robot: { ...robot, state: { ...robot.state, lidar: lidarOf({ row: row.map(() => 100) }) } } });
    expect(cells()[31]).toBe('18');
    vi.advanceTimersByTime(100);
    await nextTick();
    expect(cells()[31]).toBe('10');
  });
});
