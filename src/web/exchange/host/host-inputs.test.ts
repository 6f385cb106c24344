import { shallowRef } from 'vue';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { MAIN } from '#project/project';
import { defaultScene } from '#scene/scene';

import { SensorsModel } from '../../session/run/sensors-model';
import { WorkModel } from '../../session/work/model/work-model';
import { defaultSettings } from '../../session/work/settings/settings';
import { hostInputs } from './host-inputs';
import { fakeRun, settled } from './testing/fake-run';

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
});
afterEach(() => void vi.unstubAllGlobals());

const down = { type: 'button', button: 'a', down: true } as const;
const up = { ...down, down: false } as const;

/** A host at a page that runs. */
async function hostAtRun() {
  const fake = fakeRun();
  const { run, say } = fake;
  const files = [{ name: MAIN, text: '' }];
  const project = { files, scene: defaultScene(), course: null };
  const sensors = new SensorsModel(run);
  const nothing = (): void => undefined;
  const own = shallowRef(defaultSettings('en'));
  const settings = { current: own, own, change: nothing, bring: nothing, hold: nothing };
  const work = new WorkModel({ project, open: MAIN, previous: [] }, () => 0);
  const taker = hostInputs({ run, sensors, settings, work });
  void run.start();
  await settled();
  say({ type: 'started' });
  return { ...fake, sensors, taker, work };
}

describe('what a host does to a run', () => {
  it('reaches the run at once and in order: how long a press lasts there is the run’s matter', async () => {
    const { inputs, sensors, taker } = await hostAtRun();
    expect([taker.take(down), taker.take(up)]).toEqual([null, null]);
    taker.take({ type: 'sensor', id: 'buttonB', value: 1 });
    taker.take({ type: 'sensor', id: 'buttonB', value: 0 });
    expect(inputs()).toEqual([
      down,
      up,
      { type: 'sensor', id: 'buttonB', value: 1 },
      { type: 'sensor', id: 'buttonB', value: 0 },
    ]);
    expect(sensors.wishes.value).toEqual({ buttonB: 0 });
  });

  it('is told apart from what a person does', async () => {
    const { run, host, taker } = await hostAtRun();
    const own: boolean[] = [];
    host.listen(({ type }) => type === 'sensed' && own.push(taker.isOwn()));
    taker.take(down);
    taker.take(up);
    run.input(down);
    expect(own).toEqual([true, true, false]);
  });

  it('is refused where the board has no such thing, and takes accelerations of the widest range', async () => {
    const { inputs, taker } = await hostAtRun();
    expect(taker.take({ type: 'touch', pad: 'pin3', down: true })).toMatch(/no sensor "pin3"/);
    expect(taker.take({ type: 'sensor', id: 'accelerometerX', value: 8001 })).toMatch(/-8000 … 8000 mg/);
    expect(inputs()).toEqual([]);
    expect(taker.take({ type: 'sensor', id: 'accelerometerX', value: 7000 })).toBeNull();
    expect(inputs()).toHaveLength(1);
  });

  it('reaches the microcomputer that it names; a packet without a name reaches all', async () => {
    const { run, taker, work } = await hostAtRun();
    const other = { name: 'remote', device: 'auto', firmware: '', robot: 'none', robotOptions: {}, files: [], sameAs: 'robot' } as const; // prettier-ignore
    work.addDevice(other, 'robot');
    const asked = vi.spyOn(run, 'input');
    const packet = { type: 'radio', text: 'hi' } as const;
    expect([taker.take(down), taker.take(down, 'remote'), taker.take(packet), taker.take(packet, 'robot')]).toEqual([
      ...[null, null, null, null],
    ]);
    expect(asked.mock.calls).toEqual([
      [down, 0],
      [down, 1],
      [packet, undefined],
      [packet, 0],
    ]);
    expect(taker.take(down, 'nobody')).toBe('There is no device "nobody". Known are "robot", "remote".');
  });
});
