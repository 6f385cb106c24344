// @vitest-environment happy-dom
import { nextTick } from 'vue';
import { beforeEach, describe, expect, it, vi } from 'vitest';

import type { SimulatorEvent } from '#embed/simulator';
import { defaultScene } from '#scene/scene';
import { RowWriter } from '#tape/rows/row-writer';
import type { Variables } from '#vm/debug/variables';

import { createPage } from '../../app/testing/page';
import { pictureOf, show, startRun } from '../../app/testing/run';
import { appSimulator } from './app-simulator';

const VARIABLES: Variables = {
  stack: [{ function: '<module>', file: 'main.py', line: 2, locals: [] }],
  globals: [{ name: 'n', value: { type: 'int', text: '1' } }],
};
const MAIN = 'n = 1\nn = 2\nn = 3';

/** A page with a program of three lines, and what its host hears. */
function opened() {
  const page = createPage();
  const simulator = appSimulator(page);
  simulator.setFiles([
    { name: 'main.py', text: MAIN },
    { name: 'turning.py', text: '' },
  ]);
  const heard: SimulatorEvent[] = [];
  const stop = simulator.listen((event) => void heard.push(event));
  const of = (type: SimulatorEvent['type']) => heard.filter((event) => event.type === type);
  return { page, simulator, debug: simulator.debug, of, stop };
}

/** The tape of a run of so many ms, as its worker sends it when somebody looks back. */
function tapeOf(untilMs: number): Uint8Array {
  const writer = new RowWriter();
  for (let ms = 20; ms <= untilMs; ms += 20) writer.add(pictureOf({ timeUs: ms * 1000 }));
  return writer.finish()!;
}

/** Waits for a promise while the worker answers what it is asked for. */
async function whileAnswering<T>(page: ReturnType<typeof createPage>, promise: Promise<T>): Promise<T> {
  await nextTick();
  page.say({ type: 'tape', piece: tapeOf(100), thinSinceUs: null });
  page.say({ type: 'inputs', inputs: [], nowUs: 2_000_000 });
  return promise;
}

const runsOf = (page: ReturnType<typeof createPage>) => page.sent.filter(({ type }) => type === 'run');

beforeEach(() => sessionStorage.clear());

describe('a host that debugs', () => {
  it('sets break points where the program has lines, and hears of those that somebody else sets', async () => {
    const { page, debug, of } = opened();
    await startRun(page);
    const points = [
      { file: 'main.py', line: 3 },
      { file: 'main.py', line: 2 },
    ];
    expect(await debug.setBreakPoints(points)).toBeNull();
    expect(debug.breakPoints()).toEqual([...points].reverse());
    expect(page.sent.findLast(({ type }) => type === 'break-points')).toEqual({
      type: 'break-points',
      points: [[...points].reverse()],
    });
    expect(of('break-points')).toEqual([{ type: 'break-points', points: [...points].reverse() }]);
    expect(
      await debug.setBreakPoints([
        { file: 'main.py', line: 1 },
        { file: 'x.py', line: 1 },
      ]),
    ).toBe('points[1]: there is no file "x.py"; the program has main.py, turning.py.');
    expect(await debug.setBreakPoints([{ file: 'main.py', line: 4 }])).toBe(
      'points[0]: main.py has 3 lines, no line 4.',
    );
    expect(debug.breakPoints()).toHaveLength(2);
    expect(await debug.setBreakPoints([], 'nobody')).toContain('no device "nobody"');
    expect(debug.breakPoints('nobody')).toContain('no device "nobody"');
  });

  it('keeps them with other files, loses them with another course, and sets them again at once', async () => {
    const { debug, simulator, of } = opened();
    await debug.setBreakPoints([{ file: 'main.py', line: 2 }]);
    simulator.setFiles([{ name: 'main.py', text: `${MAIN}\n` }]);
    await nextTick();
    expect(debug.breakPoints()).toHaveLength(1);
    simulator.setScene({ ...defaultScene(), name: 'Another' });
    expect(await debug.setBreakPoints([{ file: 'main.py', line: 3 }])).toBeNull();
    expect(debug.breakPoints()).toEqual([{ file: 'main.py', line: 3 }]);
    expect(of('break-points').map((event) => 'points' in event && event.points.length)).toEqual([1, 0, 1]);
  });

  it('is told where a program stands, and asks for its variables', async () => {
    const { page, debug, of } = opened();
    expect(await debug.moment()).toBe('This needs a run; it is ready.');
    await startRun(page);
    await show(page, { timeUs: 40_000, position: { file: 'main.py', line: 2, depth: 0 } });
    page.say({ type: 'held', device: 0, timeUs: 40_123 });
    expect(of('held')).toEqual([{ type: 'held', timeUs: 40_123, file: 'main.py', line: 2 }]);
    const moment = debug.moment();
    page.say({ type: 'variables', device: 0, timeUs: 40_123, variables: VARIABLES });
    expect(await moment).toEqual({ timeUs: 40_123, variables: VARIABLES });
  });

  it('is not left waiting by a run that is stopped before it answers', async () => {
    const { page, debug } = opened();
    await startRun(page);
    const moment = debug.moment();
    void page.run.stop();
    expect(await moment).toBe('The run has ended.');
  });

  it('steps only a program that stands and has not ended', async () => {
    const { page, debug } = opened();
    expect(await debug.step('over')).toBe('This needs a run that is paused; it is ready.');
    expect(await debug.step('back')).toBe('This needs a run that has been.');
    await startRun(page);
    expect(await debug.step('into')).toBe('This needs a run that is paused; it is running.');
    page.run.pause();
    expect(await debug.step({ file: 'main.py', line: 9 })).toBe('run-to: main.py has 3 lines, no line 9.');
    expect(await debug.step({ file: 'main.py', line: 3 })).toBeNull();
    expect(page.sent.at(-1)).toEqual({ type: 'step-line', step: { file: 'main.py', line: 3 }, device: 0 });
    page.run.pause();
    page.say({ type: 'program-ended', device: 0, ended: { kind: 'finished', exception: null, timeUs: 1 } });
    expect(await debug.step('over')).toBe('The program has ended: no line begins any more.');
  });

  it('looks at a moment of the tape without a time line on the page, and goes on from it', async () => {
    const { page, simulator, debug, of } = opened();
    expect(await debug.lookAt(0)).toBe('This needs a run that has been.');
    expect(await debug.goOn(false)).toBe('This needs a moment of the past: look-at chooses one.');
    await startRun(page);
    await show(page, { timeUs: 100_000 });
    expect(await whileAnswering(page, debug.lookAt(50_000))).toBeNull();
    expect([simulator.phase(), debug.isLookingBack(), simulator.nowUs()]).toEqual(['paused', true, 40_000]);
    expect(of('looking').at(-1)).toEqual({ type: 'looking', timeUs: 40_000 });
    expect(await whileAnswering(page, debug.lookAt(200_000))).toBe(
      'The run has come to 100 ms; there is no moment at 200 ms.',
    );
    expect(simulator.nowUs()).toBe(40_000);
    const on = whileAnswering(page, debug.goOn(true));
    await vi.waitFor(() => expect(runsOf(page)).toMatchObject([{}, { paused: true, catchUpUs: 40_000 }]));
    page.say({ type: 'started' });
    await show(page, { timeUs: 40_000 });
    expect(await on).toBeNull();
    expect([simulator.phase(), debug.isLookingBack()]).toEqual(['paused', false]);
  });

  it('is told when the run is stopped before it is there', async () => {
    const { page, debug } = opened();
    await startRun(page);
    await show(page, { timeUs: 100_000 });
    await whileAnswering(page, debug.lookAt(50_000));
    const on = whileAnswering(page, debug.goOn(false));
    await vi.waitFor(() => expect(runsOf(page)).toHaveLength(2));
    page.say({ type: 'started' });
    await nextTick();
    await page.run.stop();
    expect(await on).toBe('The run was stopped before it was there.');
  });

  it('comes back to the present, which goes on', async () => {
    const { page, simulator, debug, of } = opened();
    await startRun(page);
    await show(page, { timeUs: 100_000 });
    await whileAnswering(page, debug.lookAt(50_000));
    expect(debug.lookNow()).toBeNull();
    expect([of('looking').at(-1), simulator.nowUs()]).toEqual([{ type: 'looking', timeUs: null }, 100_000]);
    await whileAnswering(page, debug.lookAt(50_000));
    expect(simulator.resume()).toBeNull();
    expect([simulator.phase(), simulator.nowUs()]).toEqual(['running', 100_000]);
  });

  it('hears nothing more once it has left', async () => {
    const { page, of, stop } = opened();
    await startRun(page);
    await show(page, { timeUs: 40_000, position: { file: 'main.py', line: 2, depth: 0 } });
    stop();
    page.say({ type: 'held', device: 0, timeUs: 40_123 });
    page.run.look.back();
    expect([of('held'), of('looking')]).toEqual([[], []]);
  });
});
