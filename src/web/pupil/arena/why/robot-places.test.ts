import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { findRobot } from '#robots/index';
import { readRobotDrawing } from '../robot/robot-drawing';
import { partAt, type DrawnRobot } from './robot-places';

const robotOf = (id: string, headingDeg = 0, scale = 1): DrawnRobot => ({
  pose: { xMm: 500, yMm: 300, headingRad: (headingDeg * Math.PI) / 180 },
  scale,
  outlineMm: findRobot(id)?.body.outlineMm ?? [],
  parts: readRobotDrawing(readFileSync(`src/robots/${id}/robot.svg`, 'utf8')),
});
/** The part a few mm ahead of the axle and to the left. */
const at = (robot: DrawnRobot, ahead: number, left: number, reachMm = 3) => {
  const { xMm, yMm, headingRad } = robot.pose;
  const [cos, sin] = [Math.cos(headingRad) * robot.scale, Math.sin(headingRad) * robot.scale];
  return partAt({ x: xMm + ahead * cos - left * sin, y: yMm + ahead * sin + left * cos }, robot, reachMm);
};

describe('what is pointed at of a robot', () => {
  it.each([
    ['maqueen-lite', 0, 1],
    ['maqueen-lite', 130, 1],
    ['maqueen-lite', -60, 2],
    ['callibot', 0, 1],
    ['maqueen-plus-v2', 45, 0.5],
  ])('is a wheel of %s at its side, turned by %i° at scale %f', (id, headingDeg, scale) => {
    const robot = robotOf(id, headingDeg, scale);
    const { wheels } = robot.parts!;
    const side = (box: typeof wheels.left): number => -(box!.x + box!.width / 2);
    expect(at(robot, 0, side(wheels.left))).toBe('wheel-left');
    expect(at(robot, 0, side(wheels.right))).toBe('wheel-right');
  });

  it('is a light where it is drawn, the nearer one of two', () => {
    const robot = robotOf('maqueen-lite', 30);
    for (const side of ['left', 'right'] as const) {
      const { x, y } = robot.parts!.leds[side]!;
      expect(at(robot, -y, -x, 12)).toBe(`light-${side}`);
    }
  });

  it('is its display, if a place of it is meant', () => {
    const robot = robotOf('maqueen-lite');
    const { x, y, width, height } = robot.parts!.display[12]!;
    expect(at(robot, -y - height / 2, -x - width / 2, 1)).toBe('display');
  });

  it('is the robot elsewhere on it, also before its drawing has come, and nothing beside it', () => {
    const robot = robotOf('maqueen-lite');
    expect(at({ ...robot, parts: null }, 10, 0)).toBe('robot');
    expect(at(robot, 120, 0)).toBeNull();
    expect(at({ ...robot, parts: null }, -200, 0)).toBeNull();
  });
});
