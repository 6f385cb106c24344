// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { editingPage, samples } from '../app/testing/editing';
import { byId } from '../app/testing/find';
import { mountOn, textOf } from '../app/testing/mount-on';
import { show, startRun } from '../app/testing/run';
import NarrationRegion from './NarrationRegion.vue';
import { seen, type Changes } from './testing/drive';

const ON =
  'Die Fahrt wird angesagt. In der Arena nennt die Taste N, was im Parcours liegt, und die Taste O, was um den Roboter ist.';

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
