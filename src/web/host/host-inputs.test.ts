import { shallowRef } from 'vue';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { MAIN } from '#project/project';
import { defaultScene } from '#scene/scene';

import { SensorsModel } from '../run/sensors-model';
import { WorkModel } from '../work/model/work-model';
import { defaultSettings } from '../work/settings/settings';
import { hostInputs } from './host-inputs';
import { fakeRun, settled } from './testing/fake-run';

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const down = { type: 'button', button: 'a', down: true } as const;
const up = { ...down, down: false } as const;

/** A host at a page that runs, or does not yet. */
async function hostAtRun() {
  const fake = fakeRun();
  const { run, host, say } = fake;
  const files = [{ name: MAIN, text: '' }];
  const project = { files, scene: defaultScene(), course: null };
  const sensors = new SensorsModel(run);
  const nothing = (): void => undefined;
  const own = shallowRef(defaultSettings('en'));
  const settings = { current: own, own, change: nothing, hold: nothing };
  const work = new WorkModel({ project, open: MAIN, previous: [] }, () => 0);
  const taker = hostInputs({ run, host, sensors, settings, work });
  const start = async (): Promise<void> => {
    void run.start();
    await settled();
    say({ type: 'started' });
  };
  await start();
  const pictures = (untilMs: number): void => {
    for (let ms = run.nowUs.value / 1000 + 16; ms <= untilMs; ms += 16) fake.picture(ms);
  };
  return { ...fake, sensors, taker, start, pictures };
}

describe('what a host does to a run', () => {
  it('presses a button long enough for the board, also when it says down and up in one breath', async () => {
    const { inputs, taker, pictures } = await hostAtRun();
    expect([taker.take(down), taker.take(up)]).toEqual([null, null]);
    expect(inputs).toEqual([down]);
    pictures(60); // not long enough yet
    expect(inputs).toEqual([down]);
    pictures(150);
    expect(inputs).toEqual([down, up]);
  });

  it('does so for touch pads and for buttons by their sensor, each on its own', async () => {
    const { inputs, taker, pictures } = await hostAtRun();
    for (const value of [1, 0]) {
      taker.take({ type: 'touch', pad: 'pinLogo', down: value === 1 });
      taker.take({ type: 'sensor', id: 'buttonB', value });
    }
    expect(inputs).toHaveLength(2);
    pictures(150);
    expect(inputs.slice(2)).toEqual([
      { type: 'touch', pad: 'pinLogo', down: false },
      { type: 'sensor', id: 'buttonB', value: 0 },
    ]);
  });

  it('lets go of a button in a page that is not drawn, too, but not while the run stands still', async () => {
    const { run, inputs, taker } = await hostAtRun();
    vi.useFakeTimers();
    taker.take(down);
    taker.take(up);
    run.pause();
    vi.advanceTimersByTime(10_000);
    expect(inputs).toEqual([down]);
    run.resume();
    vi.advanceTimersByTime(1000);
    expect(inputs).toEqual([down, up]);
  });

  it('is no longer pressed in the next run', async () => {
    const { run, inputs, sensors, taker, start, pictures } = await hostAtRun();
    taker.take({ type: 'sensor', id: 'buttonA', value: 1 });
    taker.take({ type: 'sensor', id: 'buttonA', value: 0 });
    await run.stop();
    expect(sensors.wishes.value).toEqual({ buttonA: 0 });
    inputs.length = 0;
    await start();
    taker.take(down);
    taker.take(up);
    pictures(150);
    expect(inputs).toEqual([down, up]);
  });

  it('is told apart from what a person does, also when it had to wait', async () => {
    const { run, host, taker, pictures } = await hostAtRun();
    const own: boolean[] = [];
    host.listen(({ type }) => type === 'sensed' && own.push(taker.isOwn()));
    taker.take(down);
    taker.take(up);
    pictures(150);
    run.input(down);
    expect(own).toEqual([true, true, false]);
  });

  it('is refused where the board has no such thing, and takes accelerations of the widest range', async () => {
    const { inputs, taker } = await hostAtRun();
    expect(taker.take({ type: 'touch', pad: 'pin3', down: true })).toMatch(/no sensor "pin3"/);
    expect(taker.take({ type: 'sensor', id: 'accelerometerX', value: 8001 })).toMatch(/-8000 … 8000 mg/);
    expect(inputs).toEqual([]);
    expect(taker.take({ type: 'sensor', id: 'accelerometerX', value: 7000 })).toBeNull();
    expect(inputs).toHaveLength(1);
  });
});
