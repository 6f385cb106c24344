import { describe, expect, it } from 'vitest';
import { defaultScene, type Point, type SceneObject, type Task, type Zone } from '#scene/scene';
import { testChassis } from '#world/testing/rig';
import { STEP_US } from '#world/step';
import { CourseWorld } from '../course/course-world';
import { Judge } from './judge';
import { spikedIds } from './task-brief';

const zone = (type: Zone['type'], id: string, at: Point, more: Partial<Zone> = {}): Zone => ({
  ...{ type, id, at, size: [200, 200], angle: 0, round: false, number: 0, blocks: 0 },
  ...more,
});
const target = zone('target', 't', [1500, 500], { size: [400, 900] });
const checkpoint = (number: number, at: Point): Zone => zone('checkpoint', `c${String(number)}`, at, { number });
const block = (id: string, at: Point): SceneObject => ({ type: 'block', id, at, size: [50, 50], angle: 0 });

/** Ada at (300 | 200), Ben at (300 | 500), Cem at (300 | 800), side by side; they look along x. */
function start(robots: Task['robots'], objects: readonly SceneObject[], task: Partial<Task> = {}, count = 3) {
  const rules = { seconds: null, noTouch: false, ...(robots && { robots }), ...task };
  const course = { ...defaultScene(), size: [2000, 1000] as const, task: rules, objects };
  const arena = new CourseWorld(course);
  const type = testChassis();
  const entered = ['Ada', 'Ben', 'Cem'].slice(0, count).map((device, place) => ({
    device,
    chassis: arena.world.addChassis(type, { xMm: 300, yMm: 200 + 300 * place, headingRad: 0 }),
    body: type.outlineMm,
  }));
  const judge = new Judge(course, { robots: entered, block: (id) => arena.block(id), spiked: spikedIds(course) });
  let timeUs = 0;
  const look = (): void => {
    arena.world.step();
    timeUs += STEP_US;
    judge.step(timeUs);
  };
  judge.step(timeUs);
  return {
    arena,
    judge,
    course,
    verdict: () => judge.verdict(),
    /** How it stands for each robot: its state, and why. */
    robots: () => judge.verdict()?.robots.map(({ device, state, reason }) => [device, state, reason]),
    /** Puts robots at places, all in one moment. */
    put: (places: Readonly<Record<string, Point>>): void => {
      for (const { device, chassis } of entered) {
        const [xMm, yMm] = places[device] ?? [NaN, NaN];
        if (!Number.isNaN(xMm)) chassis.place({ xMm, yMm, headingRad: 0 });
      }
      look();
    },
    /** Drives one robot, about 300 mm/s at 0.5. */
    drive: (device: string, seconds: number, duty = 0.5): void => {
      const chassis = entered.find((one) => one.device === device)?.chassis;
      chassis?.setDuty(0, duty);
      chassis?.setDuty(1, duty);
      for (let step = 0; step < seconds * 250; step++) look();
      chassis?.setDuty(0, 0);
      chassis?.setDuty(1, 0);
    },
    wait: (seconds: number): void => {
      for (let step = 0; step < seconds * 250; step++) look();
    },
  };
}

describe('a task that says nothing of several robots', () => {
  it('counts the first one alone', () => {
    const { put, verdict } = start(undefined, [target]);
    put({ Ben: [1500, 500] });
    expect(verdict()).toMatchObject({ state: 'open', targets: { reached: 0, of: 1 }, robots: [] });
    put({ Ada: [1500, 200] });
    expect(verdict()).toMatchObject({ state: 'passed', robots: [] });
  });
});

describe('“all must arrive”', () => {
  it('is passed when the last one is there, each after its own checkpoints', () => {
    const { put, verdict, robots } = start('all', [checkpoint(1, [900, 200]), target], {}, 2);
    put({ Ada: [900, 200] });
    put({ Ada: [1500, 200], Ben: [1500, 500] });
    expect(verdict()).toMatchObject({
      ...{ state: 'open', checkpoints: { passed: 1, of: 2 }, targets: { reached: 1, of: 2 } },
      early: { id: 't', number: 0, before: 1 }, // Ben came to the target without its checkpoint
    });
    expect(robots()).toEqual([
      ['Ada', 'passed', null],
      ['Ben', 'open', null],
    ]);
    put({ Ben: [900, 200] });
    put({ Ben: [1500, 500] });
    expect(verdict()).toMatchObject({ state: 'passed', atMs: 16, robots: [{ atMs: 8 }, { atMs: 16 }] });
  });

  it('is failed for all by what one does wrong, and says which', () => {
    const { put, verdict, robots } = start('all', [target, zone('forbidden', 'no', [900, 500])]);
    put({ Ada: [1500, 200], Ben: [900, 500] });
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'forbidden', by: 'no', place: { xMm: 900, yMm: 500 } });
    expect(robots()).toEqual([
      ['Ada', 'passed', null],
      ['Ben', 'failed', 'forbidden'],
      ['Cem', 'open', null],
    ]);
  });

  it('is failed when the time is over, for those that are not there', () => {
    const { put, wait, verdict, robots } = start('all', [target], { seconds: 1 }, 2);
    put({ Ada: [1500, 200] });
    wait(1);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'time', atMs: 1000 });
    expect(robots()).toEqual([
      ['Ada', 'passed', null],
      ['Ben', 'failed', 'time'],
    ]);
  });

  it('names the robot that was touched where nothing may be touched', () => {
    const { put, drive, verdict } = start('all', [target], { noTouch: true }, 2);
    put({ Ada: [300, 800], Ben: [600, 800] });
    drive('Ada', 2);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'robot', by: 'Ben' });
  });
});

describe('“the first one wins”', () => {
  it('is passed by who is first; the others are beaten', () => {
    const { put, verdict, robots } = start('first', [checkpoint(1, [900, 500]), target]);
    put({ Ada: [1500, 200], Ben: [900, 500] });
    expect(verdict()).toMatchObject({
      state: 'open',
      checkpoints: { passed: 1, of: 1 },
      targets: { reached: 0, of: 1 },
    });
    put({ Ben: [1500, 500] });
    expect(verdict()).toMatchObject({ state: 'passed', atMs: 8, place: { xMm: 1500, yMm: 500 } });
    expect(robots()).toEqual([
      ['Ada', 'failed', 'beaten'],
      ['Ben', 'passed', null],
      ['Cem', 'failed', 'beaten'],
    ]);
  });

  it('is won by both who arrive in the same moment', () => {
    const { put, robots } = start('first', [target], {}, 2);
    put({ Ada: [1500, 200], Ben: [1500, 500] });
    expect(robots()).toEqual([
      ['Ada', 'passed', null],
      ['Ben', 'passed', null],
    ]);
  });

  it('goes on without who did something wrong, until nobody is left', () => {
    const { put, verdict } = start('first', [target, zone('forbidden', 'no', [900, 500])], {}, 2);
    put({ Ada: [900, 500] });
    expect(verdict()).toMatchObject({ state: 'open', robots: [{ state: 'failed' }, { state: 'open' }] });
    put({ Ada: [1500, 200] }); // too late for it
    expect(verdict()?.state).toBe('open');
    put({ Ben: [900, 500] });
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'forbidden', by: 'no' });
  });
});

describe('“stay in the ring”', () => {
  const ring = zone('target', 'ring', [300, 500], { size: [700, 800], round: true });

  it('is won by the last one inside; it is no place to come to', () => {
    const { put, verdict, robots } = start('ring', [ring]);
    expect(verdict()).toMatchObject({ state: 'open', targets: { reached: 0, of: 0 } });
    put({ Cem: [300, 950] });
    expect(verdict()?.state).toBe('open');
    put({ Cem: [300, 800], Ada: [900, 200] }); // back in the ring: too late
    expect(verdict()).toMatchObject({ state: 'passed', atMs: 8 });
    expect(robots()).toEqual([
      ['Ada', 'failed', 'left'],
      ['Ben', 'passed', null],
      ['Cem', 'failed', 'left'],
    ]);
  });

  it('is won by nobody when the last two leave in the same moment', () => {
    const { put, verdict } = start('ring', [ring], {}, 2);
    put({ Ada: [900, 200], Ben: [900, 500] });
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'left' });
  });

  it('is won by nobody when the time is over', () => {
    const { wait, verdict } = start('ring', [ring], { seconds: 1 }, 2);
    wait(1);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'time' });
  });

  it('lets them touch each other, also where nothing else may be touched', () => {
    const { put, drive, verdict } = start('ring', [ring], { noTouch: true }, 2);
    put({ Ada: [150, 500], Ben: [300, 500] });
    drive('Ada', 1.5);
    expect(verdict()?.state).toBe('open');
    drive('Ada', 2);
    expect(verdict()).toMatchObject({ state: 'passed', robots: [{ state: 'passed' }, { reason: 'left' }] });
  });

  it('stays open for one robot that has nobody to beat', () => {
    const { wait, verdict } = start('ring', [ring], {}, 1);
    wait(1);
    expect(verdict()?.state).toBe('open');
  });
});

describe('“catch the others”', () => {
  it('is passed when the first robot has touched them all, whoever ran into whom', () => {
    const { put, drive, verdict, robots } = start('catch', []);
    put({ Ada: [300, 800], Ben: [600, 800], Cem: [600, 200] });
    drive('Ada', 1.5);
    expect(robots()).toEqual([
      ['Ada', 'open', null],
      ['Ben', 'failed', 'caught'],
      ['Cem', 'open', null],
    ]);
    put({ Ada: [900, 200] });
    drive('Cem', 1.5);
    expect(verdict()).toMatchObject({ state: 'passed', robots: [{ state: 'passed' }, {}, { reason: 'caught' }] });
  });

  it('does not count the touch of two others', () => {
    const { put, drive, verdict } = start('catch', []);
    put({ Ada: [300, 800], Ben: [900, 200], Cem: [600, 200] });
    drive('Cem', 1.5);
    expect(verdict()).toMatchObject({ state: 'open', robots: [{}, { state: 'open' }, { state: 'open' }] });
  });

  it('is failed when the time is over; who is free has got away', () => {
    const { wait, verdict, robots } = start('catch', [], { seconds: 1 }, 2);
    wait(1);
    expect(verdict()).toMatchObject({ state: 'failed', reason: 'time' });
    expect(robots()).toEqual([
      ['Ada', 'failed', 'time'],
      ['Ben', 'passed', null],
    ]);
  });
});

describe('“together”', () => {
  it('counts for all what one reaches, in the order of the checkpoints', () => {
    const { put, verdict } = start('together', [checkpoint(1, [900, 200]), checkpoint(2, [900, 500]), target], {}, 2);
    put({ Ben: [900, 500] });
    expect(verdict()).toMatchObject({ checkpoints: { passed: 0, of: 2 }, early: { id: 'c2', before: 1 } });
    put({ Ada: [900, 200], Ben: [300, 500] });
    put({ Ben: [900, 500] });
    put({ Ada: [1500, 200] });
    expect(verdict()).toMatchObject({
      state: 'passed',
      checkpoints: { passed: 2, of: 2 },
      targets: { reached: 1, of: 1 },
    });
  });

  it('is passed by blocks, whoever brought them', () => {
    const home = zone('target', 'home', [900, 500], { blocks: 2 });
    const { arena, wait, verdict } = start('together', [home, block('a', [600, 100]), block('b', [600, 900])], {}, 2);
    arena.block('a')?.place({ xMm: 880, yMm: 450, headingRad: 0 });
    wait(0.004);
    expect(verdict()).toMatchObject({ state: 'open', blocks: { delivered: 1, of: 2 } });
    arena.block('b')?.place({ xMm: 880, yMm: 550, headingRad: 0 });
    wait(0.004);
    expect(verdict()).toMatchObject({ state: 'passed', robots: [{ state: 'passed' }, { state: 'passed' }] });
  });
});

describe('a rule that is changed while they drive', () => {
  it('begins anew for all of them', () => {
    const { judge, course, put, verdict } = start('all', [target], {}, 2);
    put({ Ada: [1500, 200] });
    judge.take({ ...course, task: { ...course.task, robots: 'together' } });
    expect(verdict()).toMatchObject({ targets: { reached: 0, of: 1 } });
    put({ Ada: [1501, 200] });
    expect(verdict()).toMatchObject({ state: 'helped', help: ['edits'] });
  });
});
