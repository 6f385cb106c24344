// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { editingPage, samples } from '../../app/testing/editing';
import { byId } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
import NarrationRegion from './NarrationRegion.vue';
import { seen, type Changes } from './testing/drive';
import { recordedSound } from './testing/recorded-sound';

const ON =
  'Die Fahrt wird beschrieben. In der Arena nennt die Taste N, was im Parcours liegt, und die Taste O, was um den Roboter ist.';

/** A page whose drive is told. Its clock on the wall is the test's. */
async function page() {
  const made = await editingPage([{ ...samples.wall, from: [700, 0], to: [700, 900] }]);
  made.settings.change({ robot: 'maqueen-lite', device: 'microbit-v2', tell: true });
  mountOn(made, NarrationRegion);
  /** The run shows this, and so much time goes by. */
  const drive = async (changes: Changes, ms: number) => {
    await show(made, seen(changes));
    await vi.advanceTimersByTimeAsync(ms);
  };
  return { ...made, drive, said: () => textOf(byId('narration')) };
}

describe('the region in which the drive is told', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval', 'performance'] })); // prettier-ignore
  afterEach(() => void vi.useRealTimers());

  it('is polite, is there before its words, and says that it is on', async () => {
    const { said } = await page();
    expect(byId('narration').getAttribute('aria-live')).toBe('polite');
    expect(said()).toBe('');
    await vi.advanceTimersByTimeAsync(1);
    expect(said()).toBe(ON);
  });

  it('lets the page say first that the run has begun, then follows it', async () => {
    const made = await page();
    const { drive, said } = made;
    await startRun(made);
    await drive({}, 1000);
    expect(said()).toBe(ON);
    await drive({}, 500);
    expect(said()).toBe('Start bei x 20, y 45 cm, Richtung 0 Grad.');
    await drive({ aheadMm: 180, pathMm: 10 }, 2000);
    expect(said()).toBe('Wand 18 cm voraus.');
  });

  it('notices without new pictures that the robot has stopped', async () => {
    const made = await page();
    await startRun(made);
    await made.drive({}, 2500);
    await made.drive({ xMm: 300, pathMm: 100 }, 3000);
    expect(made.said()).toBe('Der Roboter steht: x 30, y 45 cm, Richtung 0 Grad.');
  });

  it('is a new element for the same words, so that they are heard again', async () => {
    const made = await page();
    await startRun(made);
    await made.drive({}, 2500);
    await made.drive({ xMm: 637, touches: 1 }, 2500);
    const before = byId('narration').firstElementChild;
    expect(made.said()).toBe('Stösst vorn an eine Wand.');
    for (let step = 1; step <= 4; step += 1)
      await made.drive({ xMm: 637, touches: step < 4 ? 1 : 2, pathMm: 5 * step }, 1200);
    expect(made.said()).toBe('Stösst vorn an eine Wand.');
    expect(byId('narration').firstElementChild).not.toBe(before);
  });

  it('says nothing in a pause, and at the stop where the robot stands', async () => {
    const made = await page();
    await startRun(made);
    await made.drive({}, 2500);
    await show(made, seen({ touches: 1 }));
    made.run.pause();
    await vi.advanceTimersByTimeAsync(5000);
    expect(made.said()).toBe('Start bei x 20, y 45 cm, Richtung 0 Grad.');
    await made.run.stop();
    await nextTick();
    await vi.advanceTimersByTimeAsync(2500);
    expect(made.said()).toBe('Der Roboter steht: x 20, y 45 cm, Richtung 0 Grad.');
  });

  it('lets the page say that the program has ended', async () => {
    const made = await page();
    await startRun(made);
    await made.drive({}, 4500);
    made.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1 }, device: 0 });
    await made.drive({ aheadMm: 120 }, 1000);
    expect(made.said()).toBe('Start bei x 20, y 45 cm, Richtung 0 Grad.');
    await made.drive({ aheadMm: 120 }, 400);
    expect(made.said()).toBe('Wand 12 cm voraus.');
  });

  it('lets the arena answer first when somebody explores it by keyboard', async () => {
    document.body.insertAdjacentHTML('beforeend', '<div role="application"></div>');
    const made = await page();
    await startRun(made);
    await made.drive({}, 4500);
    document.querySelector('[role="application"]')?.dispatchEvent(new KeyboardEvent('keydown', { key: 'n', bubbles: true })); // prettier-ignore
    await made.drive({ aheadMm: 120 }, 3500);
    expect(made.said()).toBe('Start bei x 20, y 45 cm, Richtung 0 Grad.');
    await made.drive({ aheadMm: 120 }, 400);
    expect(made.said()).toBe('Wand 12 cm voraus.');
  });

  it('asks for nothing any more when the run is over', async () => {
    const made = await page();
    await startRun(made);
    await made.drive({}, 2500);
    await made.run.stop();
    await vi.advanceTimersByTimeAsync(6000);
    expect(vi.getTimerCount()).toBe(0);
  });

  it('tells nothing of the board without a robot', async () => {
    const made = await page();
    await startRun(made);
    await show(made);
    await vi.advanceTimersByTimeAsync(5000);
    expect(made.said()).toBe(ON);
  });
});

describe('the tones of the drive', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval', 'performance'] })); // prettier-ignore
  afterEach(() => {
    vi.useRealTimers();
    vi.restoreAllMocks();
  });

  /** A robot on a line that drives; what is heard of it. */
  async function onLine() {
    const made = await page();
    const { output, heard } = recordedSound();
    vi.spyOn(made.sound, 'output').mockImplementation(() => output);
    await startRun(made);
    const last = async () => {
      await vi.advanceTimersByTimeAsync(100);
      const sounds = heard.splice(0);
      return sounds.includes('line ends') ? 'ends' : sounds.length > 0 ? 'sounds' : 'silent';
    };
    await show(made, seen({ line: [1, 0] }));
    return { ...made, last };
  }

  it('go with the run: silent in a pause and after the stop', async () => {
    const { run, last } = await onLine();
    expect(await last()).toBe('sounds');
    run.pause();
    expect([await last(), await last()]).toEqual(['ends', 'silent']);
    run.resume();
    expect(await last()).toBe('sounds');
    await run.stop();
    expect([await last(), await last()]).toEqual(['ends', 'silent']);
  });

  it.each([
    ['the page is muted', { muted: true }],
    ['the tones are switched off', { tones: false }],
  ])('are silent when %s, while the words go on', async (_, change) => {
    const { settings, last, drive, said } = await onLine();
    expect(await last()).toBe('sounds');
    settings.change(change);
    expect([await last(), await last()]).toEqual(['ends', 'silent']);
    await drive({ aheadMm: 120 }, 2500);
    expect(said()).toContain('Start bei x 20');
  });

  it('are silent while the page is out of sight', async () => {
    const { last } = await onLine();
    expect(await last()).toBe('sounds');
    const hidden = vi.spyOn(document, 'hidden', 'get').mockReturnValue(true);
    document.dispatchEvent(new Event('visibilitychange'));
    expect([await last(), await last()]).toEqual(['ends', 'silent']);
    hidden.mockReturnValue(false);
    document.dispatchEvent(new Event('visibilitychange'));
    expect(await last()).toBe('sounds');
  });
});
