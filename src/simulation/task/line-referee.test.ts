import { describe, expect, it } from 'vitest';
import type { League } from '#scene/league/league';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { testChassis } from '#world/testing/rig';
import { STEP_US } from '#world/step';
import { CourseWorld } from '../course/course-world';
import { Judge } from './judge';
import { spikedIds } from './task-brief';

const stroke = (id: string, points: readonly (readonly [number, number])[]): SceneObject => ({
  ...{ type: 'stroke', id, points, width: 20, color: 'black' },
});

/** Three tiles in a row, the second with a gap. */
const row: League = {
  rules: 'line-2025',
  tiles: [
    { at: [150, 150], heading: 0 },
    { at: [450, 150], heading: 0, gaps: 1 },
    { at: [750, 150], heading: 0 },
  ],
};
const line = [stroke('a', [[0, 150], [400, 150]]), stroke('b', [[500, 150], [750, 150]])]; // prettier-ignore

/** A robot of 81 × 80 mm that is put from place to place, and its judge. */
function start(league: League, objects: readonly SceneObject[], task: Scene['task'] = defaultScene().task) {
  const course: Scene = { ...defaultScene(), size: [1200, 900], task, objects, league };
  const arena = new CourseWorld(course);
  const type = testChassis();
  const robot = arena.world.addChassis(type, { xMm: 150, yMm: 150, headingRad: 0 });
  const judge = new Judge(course, {
    robots: [{ device: 'robot', chassis: robot, body: type.outlineMm }],
    block: (id) => arena.block(id),
    spiked: spikedIds(course),
  });
  let timeUs = 0;
  judge.step(timeUs);
  const wait = (seconds: number): void => {
    for (let step = 0; step < Math.round((seconds * 1e6) / STEP_US); step++) {
      arena.world.step();
      timeUs += STEP_US;
      judge.step(timeUs);
    }
  };
  const put = (xMm: number, yMm: number): void => {
    robot.place({ xMm, yMm, headingRad: 0 });
    wait(STEP_US / 1e6);
  };
  return { judge, robot, arena, course, put, wait, points: () => judge.verdict()?.points };
}

describe('a line that is scored', () => {
  it('is passed when the robot has stood on the last tile for 5 s, with its points', () => {
    const { judge, put, wait, points } = start(row, line);
    put(450, 150);
    put(750, 150);
    expect(points()).toMatchObject({ score: 15, tile: 2 });
    wait(4.8);
    expect(judge.verdict()?.state).toBe('open');
    wait(0.4);
    expect(judge.verdict()).toMatchObject({ state: 'passed', points: { score: 5 + 10 + 10 + 60, lacks: 0 } });
  });

  it('puts the robot back to the start when it is far from the line', () => {
    const { judge, put, robot, points } = start(row, line);
    put(450, 150);
    put(600, 800);
    expect(robot.pose()).toMatchObject({ xMm: 150, yMm: 150, headingRad: 0 });
    expect(points()).toMatchObject({ lacks: 1, attempt: 2 });
    expect(judge.verdict()?.help).toEqual([]);
  });

  it('puts it back when somebody calls, and when the time is over keeps the points', () => {
    const { judge, put, robot, wait } = start(row, line, { seconds: 2, noTouch: false });
    put(450, 150);
    judge.callLack();
    expect(robot.pose()).toMatchObject({ xMm: 150, yMm: 150 });
    wait(2);
    expect(judge.verdict()).toMatchObject({ state: 'failed', reason: 'time', points: { score: 5, lacks: 1 } });
  });

  it('begins anew if it is scored otherwise while the robot drives, and not if a line is added', () => {
    const { judge, course, put, points } = start(row, line);
    put(450, 150);
    put(750, 150);
    judge.take({ ...course, objects: [...line, stroke('c', [[0, 500], [300, 500]])] }); // prettier-ignore
    expect(points()).toMatchObject({ tile: 2 });
    judge.take({ ...course, league: { ...row, rules: 'line-entry-2026' } });
    expect(points()).toMatchObject({ tile: 0, score: 0 });
  });

  it('counts a living victim in the green corner, as long as nobody holds it', () => {
    const zone: League = {
      ...row,
      tiles: row.tiles.slice(0, 2),
      zone: { at: [900, 600], size: [600, 600] },
    };
    const victim: SceneObject = { type: 'block', id: 'v', at: [800, 600], size: [45, 45], angle: 0, round: true, color: 'silver' }; // prettier-ignore
    const safe: SceneObject = { type: 'paper', id: 's', at: [1050, 450], size: [300, 300], angle: 0, corners: [[0, 0], [300, 0], [300, 300]], color: 'green' }; // prettier-ignore
    const { put, arena, points } = start(zone, [...line, safe, victim]);
    put(450, 150);
    put(800, 400);
    expect(points()?.factor).toBeUndefined();
    arena.block('v')?.place({ xMm: 1120, yMm: 400, headingRad: 0 });
    put(810, 400);
    expect(points()?.factor).toBeCloseTo(1.4, 9);
  });
});
