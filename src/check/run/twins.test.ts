import { describe, expect, it } from 'vitest';
import { createRng, type Rng } from '#core/rng';
import type { Scene, SceneObject, Task } from '#scene/scene';
import { CourseWorld } from '#simulation/course/course-world';
import { AUTO, chooseHardware } from '#simulation/hardware';
import { Judge } from '#simulation/task/judge';
import { sceneWith } from '../testing/tasks';
import { Judging } from './judging';
import type { RunCheck } from './watchers';

const RUNS = 1000;
const STEP_US = 4000;
const STEPS = 250;

const between = (rng: Rng, from: number, to: number): number => Math.round(from + rng.unit() * (to - from));

/** Gates as narrow as a step of the world, wide fields that overlap, walls. */
function randomCourse(rng: Rng, type: 'any-order' | 'round'): Scene {
  const zone = (id: string, kind: 'checkpoint' | 'target', number: number): SceneObject => ({
    ...{ type: kind, id, number, at: [between(rng, 200, 420), between(rng, 400, 500)], blocks: 0 },
    size: [between(rng, 2, 120), between(rng, 20, 300)],
    ...{ angle: between(rng, 0, 90), round: rng.unit() < 0.3 },
  });
  const gates = Array.from({ length: between(rng, 1, 3) }, (_, place) =>
    zone(`c${String(place)}`, 'checkpoint', type === 'round' ? between(rng, 1, 2) : 1),
  );
  const x = between(rng, 300, 500);
  const walls: SceneObject[] = rng.unit() < 0.7 ? [{ type: 'wall', id: 'w', from: [x, 200], to: [x, 700], thickness: 10 }] : []; // prettier-ignore
  return sceneWith([...gates, ...(type === 'round' ? [zone('t', 'target', 0)] : []), ...walls]);
}

/** Drives a robot at random, and returns the verdicts of judge and checks on the same trail. */
function drive(course: Scene, task: Partial<Task>, checks: readonly RunCheck[], rng: Rng) {
  const scene: Scene = { ...course, task: { ...course.task, ...task } };
  const hardware = chooseHardware({ scene, imports: new Set(), robot: 'maqueen-lite', board: AUTO });
  if ('problem' in hardware || hardware.robot === null) throw new Error('no robot');
  const { body } = hardware.robot;
  const arena = new CourseWorld(scene);
  const chassis = arena.world.addChassis(body, { xMm: 200, yMm: 450, headingRad: 0 });
  const robots = [{ device: 'robot', chassis, body: body.outlineMm }];
  const judge = new Judge(scene, { robots, block: () => undefined, spiked: new Set() });
  const judging = new Judging(checks, course, STEPS * STEP_US);
  let nowUs = 0;
  const lights = { rgb: [], lights: [], robot: null };
  const run = {
    ...{ display: [], lights, body: [], blockLying: () => null },
    get nowUs() {
      return nowUs;
    },
    get pose() {
      return chassis.pose();
    },
    get verdict() {
      return judge.verdict();
    },
    get isJudged() {
      return judge.isFinal;
    },
    get touches() {
      return judge.touches;
    },
  };
  const look = (): void => {
    judge.step(nowUs);
    judging.step(run);
  };
  look();
  for (let step = 0; step < STEPS && !(judging.isDone && judge.isFinal); step += 1) {
    if (step % 50 === 0) for (const wheel of [0, 1] as const) chassis.setDuty(wheel, rng.unit() < 0.3 ? 1 : 2 * rng.unit() - 0.6); // prettier-ignore
    arena.world.step();
    nowUs += STEP_US;
    look();
  }
  return { verdict: judge.verdict(), outcome: judging.outcome(() => null, {}) };
}

const base = { points: 1, needed: true } as const;
const met = { passed: 0, failed: 0, open: 0 };

describe('a check that says the same as the goals of a course', () => {
  it.each([
    ['any-order', { ...base, id: 'c', type: 'checkpoints', each: null }],
    ['round', { ...base, id: 'l', type: 'laps', count: 1 }],
  ] as const)('says it of the same step: %s, %j', (kind, reach) => {
    for (let run = 0; run < RUNS / 2; run += 1) {
      const rng = createRng(run);
      const course = randomCourse(rng, kind);
      const noTouch = rng.unit() < 0.5;
      const seconds = rng.unit() < 0.5 ? between(rng, 200, 900) / 1000 : null;
      const checks: RunCheck[] = [reach];
      if (noTouch) checks.push({ ...base, id: 'touches', type: 'touches', most: 0 });
      if (seconds !== null) checks.push({ ...base, id: 'faster', type: 'faster', seconds });
      const { verdict, outcome } = drive(course, { noTouch, seconds }, checks, rng);
      const state = verdict?.state as keyof typeof met;
      met[state] += 1;
      expect([run, outcome.passed, outcome.atMs]).toEqual([run, state === 'passed', verdict?.atMs]);
    }
  });

  it('has been tried where it holds, fails and stays open', () => {
    for (const count of Object.values(met)) expect(count).toBeGreaterThan(50);
  });
});
