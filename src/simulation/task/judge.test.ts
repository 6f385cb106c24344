import { describe, expect, it } from 'vitest';
import type { Point, Scene, SceneObject, Task, Zone } from '#scene/scene';
import { defaultScene } from '#scene/scene';
import { createRig, testChassis } from '#world/testing/rig';
import { STEP_S, STEP_US } from '#world/step';
import { CourseWorld } from '../course/course-world';
import { Judge } from './judge';
import { spikedIds } from './task-brief';

const zone = (type: Zone['type'], id: string, at: Point, more: Partial<Zone> = {}): Zone => ({
  ...{ type, id, at, size: [100, 100], angle: 0, round: false, number: 0, blocks: 0 },
  ...more,
});
const checkpoint = (number: number, at: Point, more: Partial<Zone> = {}): Zone =>
  zone('checkpoint', `c${String(number)}`, at, { number, ...more });
const block = (id: string, at: Point): SceneObject => ({ type: 'block', id, at, size: [50, 50], angle: 0 });
const courseOf = (objects: readonly SceneObject[], task: Partial<Task> = {}): Scene => ({
  ...defaultScene(),
  size: [2000, 1000],
  task: { seconds: null, noTouch: false, ...task },
  objects,
});

/** A robot at (300 | 500) that looks along x, 81 mm long and 80 mm wide, and its judge. */
function start(objects: readonly SceneObject[], task: Partial<Task> = {}) {
  const course = courseOf(objects, task);
  const arena = new CourseWorld(course);
  const type = testChassis();
  const robot = arena.world.addChassis(type, { xMm: 300, yMm: 500, headingRad: 0 });
  const judge = new Judge(course, {
    robots: [{ device: 'robot', chassis: robot, body: type.outlineMm }],
    block: (id) => arena.block(id),
    spiked: spikedIds(course),
  });
  let timeUs = 0;
  judge.step(timeUs);
  return {
    robot,
    arena,
    judge,
    verdict: () => judge.verdict(),
    /** About 300 mm/s at 0.5. */
    drive: (seconds: number, left = 0.5, right = left): void => {
      robot.setDuty(0, left);
      robot.setDuty(1, right);
      for (let step = 0; step < Math.round(seconds / STEP_S); step++) {
        arena.world.step();
        timeUs += STEP_US;
        judge.step(timeUs);
      }
    },
    /** Without wheels: the judge only sees its position. */
    put: (xMm: number, yMm: number, headingRad = 0): void => {
      robot.place({ xMm, yMm, headingRad });
      arena.world.step();
      timeUs += STEP_US;
      judge.step(timeUs);
    },
  };
}

describe('a course without a task', () => {
  it('has no verdict, whatever is touched', () => {
    const { drive, verdict } = start([block('b', [600, 500])]);
    drive(3);
    expect(verdict()).toBeNull();
  });
});

describe('a target', () => {
  it('is reached when the middle of the axle is inside: 400 mm on, after about 1.4 s', () => {
    const { drive, verdict, robot } = start([zone('target', 't', [750, 500])]);
    drive(0.5);
    expect(verdict()).toMatchObject({ state: 'open', atMs: null, targets: { reached: 0, of: 1 } });
    drive(4);
    const decided = verdict();
    expect(decided).toMatchObject({ state: 'passed', reason: null, targets: { reached: 1, of: 1 } });
    expect(decided?.atMs).toBeGreaterThan(1350);
    expect(decided?.atMs).toBeLessThan(1550);
    expect(robot.pose().xMm).toBeGreaterThan(750);
  });

  it('does not reach into its corners if it is round', () => {
    const { put, verdict } = start([zone('target', 't', [1000, 500], { round: true })]);
    put(1045, 545);
    expect(verdict()?.state).toBe('open');
    put(1045, 505);
    expect(verdict()?.state).toBe('passed');
  });

  it('counts only after all checkpoints', () => {
    const { put, verdict } = start([zone('target', 't', [1000, 500]), checkpoint(1, [1500, 500])]);
    put(1000, 500);
    expect(verdict()).toMatchObject({ state: 'open', targets: { reached: 0, of: 1 } });
    put(1500, 500);
    expect(verdict()).toMatchObject({ state: 'open', checkpoints: { passed: 1, of: 1 } });
    put(1000, 500);
    expect(verdict()).toMatchObject({ state: 'passed', targets: { reached: 1, of: 1 } });
  });

  it('several of them may be reached in any order', () => {
    const { put, verdict } = start([zone('target', 'a', [1000, 500]), zone('target', 'b', [1500, 500])]);
    put(1500, 500);
    put(700, 500);
    expect(verdict()).toMatchObject({ state: 'open', targets: { reached: 1, of: 2 } });
    put(1000, 500);
    expect(verdict()?.state).toBe('passed');
  });
});

describe('checkpoints', () => {
  const three = [checkpoint(2, [900, 500]), checkpoint(1, [600, 500]), checkpoint(3, [1200, 500])];

  it('are passed in the order of their numbers', () => {
    const { drive, verdict } = start(three);
    drive(9);
    expect(verdict()).toMatchObject({ state: 'passed', checkpoints: { passed: 3, of: 3 } });
  });

  it('do not count out of order: 2 before 1 is none', () => {
    const { put, verdict } = start(three);
    put(900, 500);
    expect(verdict()).toMatchObject({ state: 'open', checkpoints: { passed: 0, of: 3 } });
    put(600, 500);
    put(1200, 500);
    expect(verdict()).toMatchObject({ checkpoints: { passed: 1, of: 3 } });
    put(900, 500);
    put(1200, 500);
    expect(verdict()?.state).toBe('passed');
  });

  it('may be passed in any order if they have one number, and a gap between numbers does no harm', () => {
    const twice = [checkpoint(1, [600, 500]), checkpoint(1, [900, 500], { id: 'other' }), checkpoint(7, [1200, 500])];
    const { put, verdict } = start(twice);
    put(900, 500);
    put(1200, 500);
    expect(verdict()).toMatchObject({ checkpoints: { passed: 1, of: 3 } });
    put(600, 500);
    put(1200, 500);
    expect(verdict()?.state).toBe('passed');
  });

  it('are passed at once if they lie over each other', () => {
    const { put, verdict } = start([checkpoint(1, [900, 500]), checkpoint(2, [900, 500])]);
    put(900, 500);
    expect(verdict()?.state).toBe('passed');
  });
});

describe('blocks', () => {
  const target = zone('target', 't', [900, 500], { size: [200, 200], blocks: 2 });

  it('are delivered while all their corners are inside, and must be at the same time', () => {
    const { arena, drive, verdict } = start([target, block('a', [600, 800]), block('b', [700, 800])]);
    const place = (id: string, xMm: number, headingRad = 0) => arena.block(id)?.place({ xMm, yMm: 500, headingRad });
    place('a', 974); // 1 mm inside
    drive(0.004, 0);
    expect(verdict()).toMatchObject({ state: 'open', blocks: { delivered: 1, of: 2 } });
    place('a', 974, Math.PI / 4); // its corner sticks out
    drive(0.004, 0);
    expect(verdict()?.blocks).toEqual({ delivered: 0, of: 2 });
    place('b', 870);
    drive(0.004, 0);
    expect(verdict()).toMatchObject({ state: 'open', blocks: { delivered: 1, of: 2 } });
    place('a', 940);
    drive(0.004, 0);
    expect(verdict()).toMatchObject({ state: 'passed', blocks: { delivered: 2, of: 2 } });
  });

  it('count once each, and no more of them than a target wants', () => {
    const one = { ...target, blocks: 1 };
    const blocks = [block('a', [860, 500]), block('b', [930, 500])];
    const { verdict } = start([one, { ...one, id: 'u' }, { ...one, id: 'v' }, ...blocks]);
    expect(verdict()).toMatchObject({ state: 'open', blocks: { delivered: 2, of: 3 } });
  });

  it('count only in the colour that a target wants', () => {
    const red = { ...target, blocks: 1, blockColor: 'red' as const };
    const blocks = [block('a', [860, 500]), { ...block('b', [930, 500]), color: 'red' as const } as SceneObject];
    expect(start([red, ...blocks]).verdict()).toMatchObject({ blocks: { delivered: 1, of: 1 } });
    expect(start([red, block('a', [860, 500])]).verdict()?.blocks).toEqual({ delivered: 0, of: 1 });
  });

  it('pass the task if the robot pushes them there', () => {
    const { drive, verdict } = start([{ ...target, blocks: 1 }, block('a', [500, 500])], { noTouch: true });
    drive(6);
    expect(verdict()).toMatchObject({ state: 'passed', touches: 1 });
  });
});

describe('a forbidden zone', () => {
  it('must not be covered by any part of the body: the nose is enough', () => {
    const { put, verdict } = start([zone('forbidden', 'no', [800, 500])]);
    put(690, 500); // the nose ends at 749
    expect(verdict()?.state).toBe('open');
    put(692, 500);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'forbidden', by: 'no' });
  });

  it('is covered, too, if the robot surrounds it', () => {
    const { put, verdict } = start([zone('forbidden', 'no', [800, 500], { size: [10, 10], round: true })]);
    put(780, 500);
    expect(verdict()?.state).toBe('failed');
  });
});

describe('spikes', () => {
  const spikes: SceneObject = { type: 'spikes', id: 's', at: [800, 500], size: [60, 60], angle: 0 };

  it('stop the robot, and the task is failed', () => {
    const { drive, verdict, robot } = start([spikes, zone('target', 't', [1500, 500])]);
    drive(6);
    expect(robot.pose().xMm).toBeLessThan(800 - 30 - 58);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'spikes', by: 's', touches: 1 });
  });

  it('hurt a robot that stands still if they are on a moving obstacle', () => {
    const mover: SceneObject = {
      ...{ type: 'mover', id: 'm', at: [600, 500], to: [300, 500], size: [60, 60], angle: 0, speed: 100 },
      spiked: true,
    };
    const spiked = start([mover]);
    spiked.drive(3, 0);
    expect(spiked.verdict()).toMatchObject({ state: 'failed', reason: 'spikes', by: 'm' });
    const blunt = start([{ ...mover, spiked: false }]);
    blunt.drive(3, 0);
    expect(blunt.verdict()).toBeNull();
    expect(blunt.robot.collisions()).toBe(1);
  });
});

describe('a task without touching', () => {
  it('is failed by a wall, which is named', () => {
    const wall: SceneObject = { type: 'wall', id: 'w', from: [800, 300], to: [800, 700], thickness: 10 };
    const { drive, verdict } = start([wall], { noTouch: true });
    drive(6);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'touched', by: 'w', touches: 1 });
  });

  it('is failed by the edge of the arena, which has no name', () => {
    const { drive, verdict } = start([], { noTouch: true });
    drive(4, -0.5);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'touched', by: null });
  });

  it('is failed by a block where no blocks are to be delivered', () => {
    const { drive, verdict } = start([block('b', [600, 500])], { noTouch: true });
    drive(4);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'touched', by: 'b' });
  });
});

describe('the order of the places', () => {
  const three = [checkpoint(1, [600, 500]), checkpoint(2, [900, 500]), checkpoint(3, [1200, 500])];
  const target = zone('target', 't', [1500, 500]);

  it('is watched: 2 came before 1, until it comes in its turn', () => {
    const { put, verdict } = start(three);
    expect(verdict()?.early).toBeNull();
    put(900, 500);
    expect(verdict()?.early).toEqual({ id: 'c2', number: 2, before: 1 });
    put(600, 500);
    expect(verdict()?.early).toEqual({ id: 'c2', number: 2, before: 1 });
    put(900, 500);
    expect(verdict()).toMatchObject({ early: null, checkpoints: { passed: 2, of: 3 } });
  });

  it('names the last one that came too early, a target without a number', () => {
    const { put, verdict } = start([...three, target]);
    put(1200, 500);
    put(1500, 500);
    expect(verdict()?.early).toEqual({ id: 't', number: 0, before: 1 });
  });

  it('is kept by who starts in the target and drives a round', () => {
    const { drive, put, verdict } = start([zone('target', 't', [300, 500]), ...three]);
    drive(9);
    expect(verdict()).toMatchObject({ state: 'open', early: null, checkpoints: { passed: 3, of: 3 } });
    put(300, 500);
    expect(verdict()).toMatchObject({ state: 'passed', early: null });
  });

  it('is not broken by a checkpoint that is drawn where the robot stands, nor by one that was taken away', () => {
    const { put, verdict, judge } = start(three);
    put(900, 500);
    judge.take(courseOf([checkpoint(1, [600, 500])]));
    expect(verdict()?.early).toBeNull();
    judge.take(courseOf(three));
    put(901, 500);
    expect(verdict()?.early).toBeNull();
  });
});

describe('help', () => {
  const target = zone('target', 't', [1000, 500]);
  const other = zone('target', 'other', [1000, 800]);

  it('is reported if it comes from the hand, and what is done with it does not count as passed', () => {
    const { put, verdict, judge } = start([target]);
    expect(verdict()?.help).toEqual([]);
    judge.takeHand();
    expect(verdict()).toMatchObject({ state: 'open', help: ['hand'] });
    put(1000, 500);
    expect(verdict()).toMatchObject({ state: 'helped', help: ['hand'], targets: { reached: 1, of: 1 } });
  });

  it('is reported even if the task allows it, and the task is passed', () => {
    const { put, verdict, judge } = start([target], { allows: ['hand'] });
    judge.takeHand();
    put(1000, 500);
    expect(verdict()).toMatchObject({ state: 'passed', help: ['hand'] });
  });

  it('is not allowed if the other kind is', () => {
    const { put, verdict, judge } = start([target, other], { allows: ['hand'] });
    judge.takeHand();
    judge.take(courseOf([target], { allows: ['hand'] }));
    put(1000, 500);
    expect(verdict()).toMatchObject({ state: 'helped', help: ['hand', 'edits'] });
  });

  it('is no reason to have failed less', () => {
    const { put, verdict, judge } = start([target, zone('forbidden', 'no', [1500, 500])]);
    judge.takeHand();
    put(1500, 500);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'forbidden', help: ['hand'] });
  });

  it('changes nothing after the decision', () => {
    const { put, verdict, judge } = start([target]);
    put(1000, 500);
    judge.takeHand();
    expect(verdict()).toMatchObject({ state: 'passed', help: [] });
  });

  it('is not a change of the course that the run does not feel: its name, words on the floor, a wall', () => {
    const label: SceneObject = { type: 'label', id: 'l', at: [9, 9], text: 'Start', height: 30, angle: 0 };
    const wall: SceneObject = { type: 'wall', id: 'w', from: [800, 900], to: [900, 900], thickness: 10 };
    const { verdict, judge } = start([target]);
    judge.take({ ...courseOf([target, label, wall]), name: 'Other', description: 'Drive.' });
    expect(verdict()?.help).toEqual([]);
    judge.take(courseOf([target, label, wall], { seconds: 60 }));
    expect(verdict()?.help).toEqual(['edits']);
  });
});

describe('stars', () => {
  const target = zone('target', 't', [1000, 500]);
  const passedAfter = (seconds: number, task: Partial<Task>) => {
    const { drive, put, verdict } = start([target], task);
    drive(seconds, 0);
    put(1000, 500);
    return verdict();
  };

  it('are one for passing and one more for each time that is kept', () => {
    const stars: Partial<Task> = { stars: [4, 2] };
    expect(passedAfter(1, stars)?.stars).toBe(3);
    expect(passedAfter(1.996, stars)).toMatchObject({ atMs: 2000, stars: 3 });
    expect(passedAfter(3, stars)?.stars).toBe(2);
    expect(passedAfter(5, stars)?.stars).toBe(1);
  });

  it('are none for who has not passed, and not spoken of where the task gives none', () => {
    expect(start([target], { stars: [4, 2] }).verdict()?.stars).toBe(0);
    expect(passedAfter(3, { stars: [4, 2], seconds: 1 })).toMatchObject({ state: 'failed', stars: 0 });
    expect(passedAfter(1, {})?.stars).toBeNull();
  });
});

describe('the place of the decision', () => {
  it('is where the robot was, to a tenth of a millimetre', () => {
    const { put, verdict } = start([zone('forbidden', 'no', [1500, 500])]);
    expect(verdict()?.place).toBeNull();
    put(1499.96, 503.21);
    expect(verdict()?.place).toEqual({ xMm: 1500, yMm: 503.2 });
  });
});

describe('a time limit', () => {
  it('fails the task at its end, to the millisecond', () => {
    const { drive, verdict } = start([zone('target', 't', [1500, 500])], { seconds: 2 });
    drive(1.996, 0);
    expect(verdict()?.state).toBe('open');
    drive(0.004, 0);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'time', atMs: 2000 });
  });

  it('is passed by holding out where there is nothing to come to', () => {
    const { drive, verdict } = start([], { seconds: 2, noTouch: true });
    drive(2, 0);
    expect(verdict()).toMatchObject({ state: 'passed', atMs: 2000 });
  });
});

describe('a verdict', () => {
  it('is final: what happens later changes nothing of it', () => {
    const { put, drive, verdict } = start([zone('target', 't', [1000, 500]), zone('forbidden', 'no', [1500, 500])]);
    put(1000, 500);
    const passed = verdict();
    put(1500, 500);
    drive(5, -0.5);
    expect(verdict()).toEqual(passed);
  });

  it('keeps what was reached when the course is changed, and asks for what is new', () => {
    const first = [checkpoint(1, [600, 500]), checkpoint(2, [1200, 500])];
    const { put, verdict, judge } = start(first);
    put(600, 500);
    judge.take(courseOf([...first, checkpoint(3, [1500, 500])]));
    expect(verdict()?.checkpoints).toEqual({ passed: 1, of: 3 });
    judge.take(courseOf([checkpoint(1, [600, 500]), checkpoint(2, [800, 500])]));
    put(800, 500);
    expect(verdict()).toMatchObject({ state: 'helped', checkpoints: { passed: 2, of: 2 } });
  });

  it('comes when a task is set while the robot drives; touches before it do not count', () => {
    const { drive, verdict, judge, robot } = start([]);
    drive(1, -0.5);
    drive(3, -0.5);
    expect(robot.collisions()).toBe(1);
    judge.take(courseOf([], { noTouch: true }));
    drive(1, 0.5);
    expect(verdict()?.state).toBe('open');
    drive(4, -0.5);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'touched' });
  });
});

describe('the test robot', () => {
  it('reaches 59 mm ahead of its axle, on which the figures above rest', () => {
    const { robot } = createRig();
    expect(robot.toWorld({ x: 59, y: 0 }).x - robot.pose().xMm).toBeCloseTo(59, 9);
  });
});

describe('a forbidden field feels all of a robot', () => {
  /** The robot's nose is 30 mm before the field. */
  const field = (robotNoseMm: number): Zone =>
    zone('forbidden', 'f', [300 + robotNoseMm + 30 + 100, 500], { size: [200, 400] });
  const nose = Math.max(
    ...testChassis()
      .outlineMm.flat()
      .map(({ x }) => x),
  );
  const ahead = (fromMm: number, toMm: number) => [
    { x: nose + fromMm, y: -5 },
    { x: nose + toMm, y: -5 },
    { x: nose + toMm, y: 5 },
    { x: nose + fromMm, y: 5 },
  ];
  const reasonOf = ({ verdict }: ReturnType<typeof start>) => verdict()?.reason ?? null;

  it('not the air before it', () => {
    const rig = start([field(nose)]);
    rig.drive(0.1, 0);
    expect(reasonOf(rig)).toBe(null);
  });

  it('a plate or bumper of 40 mm before it, none of 20 mm', () => {
    for (const [length, reason] of [
      [20, null],
      [40, 'forbidden'],
    ] as const) {
      const rig = start([field(nose)]);
      rig.robot.addPart(ahead(0, length));
      rig.drive(0.1, 0);
      expect([length, reasonOf(rig)]).toEqual([length, reason]);
    }
  });

  it('a jaw that swings into it while the robot stands', () => {
    const rig = start([field(nose)]);
    const jaw = [{ x: 0, y: -2 }, { x: 60, y: -2 }, { x: 60, y: 2 }, { x: 0, y: 2 }]; // prettier-ignore
    const claw = rig.robot.addGripper({ hingeMm: { x: nose, y: 15 }, jawMm: [jaw], forceN: 1 });
    claw.setSwing(Math.PI / 2);
    rig.drive(0.4, 0);
    expect(reasonOf(rig)).toBe(null);
    claw.setSwing(0);
    rig.drive(0.4, 0);
    expect(reasonOf(rig)).toBe('forbidden');
  });

  it('a fork, and a block on it once it is lifted', () => {
    const short = { plateMm: ahead(0, 25), clearMm: 5 };
    const rig = start([field(nose), { ...block('b', [300 + nose + 24, 500]), size: [20, 20] } as SceneObject]);
    const fork = rig.robot.addFork(short);
    rig.drive(0.1, 0);
    expect(reasonOf(rig)).toBe(null);
    fork.setHeightMm(10);
    rig.drive(0.1, 0);
    expect([fork.isHolding(), reasonOf(rig)]).toEqual([true, 'forbidden']);
    const long = start([field(nose)]);
    long.robot.addFork({ plateMm: ahead(0, 40), clearMm: 5 });
    long.drive(0.1, 0);
    expect(reasonOf(long)).toBe('forbidden');
  });
});
