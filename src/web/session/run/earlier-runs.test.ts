// @vitest-environment happy-dom
import { nextTick } from 'vue';
import { describe, expect, it } from 'vitest';

import { defaultScene, type Scene } from '#scene/scene';
import type { RobotSnapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';

import { createPage, type TestPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { EarlierRuns } from './earlier-runs';
import { Recording } from './recording';
import { showAgain } from './run-again';

const verdict = (changes: Partial<Verdict> = {}): Verdict => ({
  ...{ state: 'open', atMs: null, reason: null, by: null, place: null, help: [], early: null, stars: null },
  checkpoints: { passed: 0, of: 3 },
  targets: { reached: 0, of: 0 },
  blocks: { delivered: 0, of: 0 },
  ...{ touches: 0, robots: [] },
  ...changes,
});
const robot = { type: 'maqueen-lite' } as RobotSnapshot;
const passed = (seconds: number): Verdict => verdict({ state: 'passed', atMs: seconds * 1000 });

function pageWithRuns(): { page: TestPage; runs: EarlierRuns; here: () => Parameters<EarlierRuns['choices']>[0] } {
  const page = createPage();
  page.settings.change({ robot: 'maqueen-lite' });
  const runs = new EarlierRuns(page.run, () => page.console.run.value);
  const here = () => ({ scene: page.work.scene.value, robots: ['maqueen-lite'] });
  return { page, runs, here };
}

const tape = (bytes: number) => ({ type: 'tape', piece: new Uint8Array(bytes), thinSinceUs: null }) as const;

/** Drives a run that ends with this verdict and so many bytes of tape. */
async function drive(page: TestPage, seconds: number, came: Verdict | null = null, bytes = 100): Promise<void> {
  await startRun(page);
  page.say(tape(bytes));
  await show(page, { timeUs: seconds * 1_000_000, verdict: came, robot });
}

describe('the runs before this one', () => {
  it('are kept when another run begins, with their number and how long they took', async () => {
    const { page, runs, here } = pageWithRuns();
    await drive(page, 12.4);
    expect(runs.all.value).toEqual([]);
    await drive(page, 3);
    expect(runs.choices(here()).last).toMatchObject({ number: 1, tookUs: 12_400_000, isOpened: false });
    await page.run.reset();
    expect(runs.choices(here()).last).toMatchObject({ number: 2, tookUs: 3_000_000 });
  });

  it('count the one on the page for the next race as soon as it is over', async () => {
    const { page, runs, here } = pageWithRuns();
    await drive(page, 42.5);
    await drive(page, 28.4, passed(28.4));
    expect(runs.choices(here(), true).best?.number).toBeUndefined();
    page.say({ type: 'stopped' });
    const { best, last } = runs.choices(here(), true);
    expect([best?.number, best?.tookUs, last?.number]).toEqual([2, 28_400_000, 2]);
    expect(runs.choices(here()).last?.number).toBe(1); // it is no ghost of itself
  });

  it('took as long as their program, whatever the world did afterwards', async () => {
    const { page, runs, here } = pageWithRuns();
    await startRun(page);
    page.say(tape(9));
    const ended = { kind: 'finished', exception: null, timeUs: 2_500_000 } as never;
    page.say({ type: 'program-ended', ended, device: 0 });
    await show(page, { timeUs: 60_000_000, robot });
    await page.run.reset();
    expect(runs.choices(here()).last?.tookUs).toBe(2_500_000);
  });

  it('leave nothing where nothing was recorded, or where a board has no robot', async () => {
    const { page, runs, here } = pageWithRuns();
    await startRun(page);
    await show(page, { timeUs: 20_000, robot });
    await startRun(page);
    page.say(tape(9));
    await show(page, { timeUs: 20_000 });
    await page.run.reset();
    expect(runs.choices(here())).toEqual({});
  });

  it('have a best one: the soonest to pass, else the one that came farthest; without a task there is none', async () => {
    const { page, runs, here } = pageWithRuns();
    await drive(page, 5);
    await drive(page, 9, verdict({ checkpoints: { passed: 2, of: 3 } }));
    await drive(page, 4, verdict({ checkpoints: { passed: 1, of: 3 } }));
    expect(runs.choices(here()).best?.number).toBe(2);
    await drive(page, 30, passed(20));
    await drive(page, 30, passed(15));
    await drive(page, 30, passed(17));
    await page.run.reset();
    const { best, last } = runs.choices(here());
    expect([best?.number, best?.tookUs, last?.number]).toEqual([5, 15_000_000, 6]);
    const { page: other, runs: tries } = pageWithRuns();
    await drive(other, 5);
    await other.run.reset();
    expect(Object.keys(tries.choices(here()))).toEqual(['last']);
  });

  it('are offered on the same course with the same robots only; its name makes no other course', async () => {
    const { page, runs } = pageWithRuns();
    await drive(page, 5);
    await page.run.reset();
    const scene = page.work.scene.value;
    const offered = (changed: Partial<Scene>, robots: (string | null)[] = ['maqueen-lite']): boolean =>
      runs.choices({ scene: { ...scene, ...changed }, robots }).last !== undefined;
    expect(offered({ name: 'Mine', description: 'Go.' })).toBe(true);
    expect(offered({ size: [500, 500] })).toBe(false);
    expect(offered({ objects: [] })).toBe(scene.objects.length === 0);
    expect(offered({ robot: { ...scene.robot, heading: scene.robot.heading + 90 } })).toBe(false);
    expect(offered({}, ['maqueen-plus-v2'])).toBe(false);
    expect(offered({}, ['maqueen-lite', 'maqueen-lite'])).toBe(false);
  });

  it('include one that came with a link or a file, which the next run races against', async () => {
    const { page, runs, here } = pageWithRuns();
    await startRun(page);
    const kept = page.run.recording.value.setup!;
    await page.run.reset();
    expect(runs.wish.value).toBe('none');
    await showAgain(page.run, {
      kept,
      untilUs: 1_000_000,
      ends: { untilUs: 1_000_000, untilProgramEnds: false },
      first: page.run.present.value!,
      pieces: [new Uint8Array(9)],
      atUs: 0,
    });
    page.say({ type: 'started' });
    await show(page, { timeUs: 1_000_000, robot });
    await startRun(page);
    expect(runs.wish.value).toBe('opened');
    const { opened, last } = runs.choices(here());
    expect([opened?.isOpened, opened?.tookUs, last]).toEqual([true, 1_000_000, undefined]);
  });

  it('are six at most: the best and the opened one stay, the oldest of the others goes', async () => {
    const { page, runs, here } = pageWithRuns();
    await drive(page, 30, passed(9));
    for (let n = 0; n < 9; n++) await drive(page, 30, passed(20));
    await page.run.reset();
    expect(runs.all.value.map(({ number }) => number)).toEqual([1, 6, 7, 8, 9, 10]);
    expect(runs.choices(here()).best?.number).toBe(1);
  });

  it('take 4 MB at most, but the last one is always there', async () => {
    const { page, runs } = pageWithRuns();
    for (let n = 0; n < 3; n++) await drive(page, 30, null, 1_900_000);
    await page.run.reset();
    expect(runs.all.value.map(({ number }) => number)).toEqual([2, 3]);
    await drive(page, 30, null, 5_000_000);
    await page.run.reset();
    expect(runs.all.value.map(({ number }) => number)).toEqual([4]);
  });

  it('stay when another course is opened, and are there again with theirs', async () => {
    const { page, runs, here } = pageWithRuns();
    const { project } = page.work.work.value;
    await drive(page, 5);
    page.work.openProject({ ...project, scene: { ...defaultScene(), size: [700, 400] } }, null);
    await page.run.reset();
    expect(runs.choices(here())).toEqual({});
    page.work.openProject(project, null);
    await nextTick();
    expect(runs.choices(here()).last?.number).toBe(1);
  });
});

it('a recording that nobody has said anything about cannot go on', () => {
  expect(new Recording(null).canRepeat).toBe(false);
});
