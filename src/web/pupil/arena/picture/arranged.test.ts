import { describe, expect, it } from 'vitest';
import { defaultScene, type Scene } from '#scene/scene';
import { lidarOf } from '#robots/testing/lidar-of';
import { arranged, bumperAtStart, lieStill, robotAtStart, summaryOf } from './arranged';

describe('the arena before and during a run', () => {
  const scene: Scene = {
    ...defaultScene(),
    robot: { type: null, at: [600, 450], heading: 270, scale: 1, options: {} },
    objects: [
      { type: 'block', id: 'b', at: [100, 100], size: [50, 50], angle: 90 },
      { type: 'fixed-block', id: 'f', at: [300, 100], size: [50, 50], angle: 0 },
    ],
  };
  const moved = { xMm: 120, yMm: 100, headingRad: 1 };

  it('shows the robot at its start and the block that can be pushed turned by 90°', () => {
    const { robot, blocks } = arranged(scene, null);
    expect(robot?.pose.xMm).toBe(600);
    expect(blocks.map(({ id, pose }) => [id, pose.headingRad])).toEqual([['b', Math.PI / 2]]);
  });

  it('shows the block where the run has pushed it', () => {
    const snapshot = { timeUs: 0, display: [], robot: null, blocks: { b: moved }, lights: [] };
    const during = arranged(scene, snapshot);
    expect(during.robot).toBeNull();
    expect(during.blocks[0]?.pose).toEqual(moved);
    expect(lieStill(arranged(scene, null).blocks, during.blocks)).toBe(false);
    expect(lieStill(during.blocks, arranged(scene, snapshot).blocks)).toBe(true);
  });

  it('shows the bumper of a robot that carries one from the start', () => {
    const bumper = bumperAtStart({ bumper: 'always' });
    expect(arranged(scene, null, { bumper }).robot?.state.bumper).toEqual({ left: false, right: false });
    expect(bumperAtStart({ bumper: 'when-read' })).toBeNull();
    expect(arranged(scene, null).robot?.state.bumper).toBeNull();
  });

  it('is summed up as 60 cm, 45 cm, -90 degrees, no distance', () => {
    const { robot } = arranged(scene, null);
    expect(summaryOf(robot)).toEqual({ xCm: 60, yCm: 45, headingDeg: -90, distanceCm: null });
    expect(summaryOf(null)).toBeNull();
  });

  it('has the nearest distance that a lidar sees where there is no ultrasonic sensor', () => {
    const robot = robotAtStart(scene);
    const seen = { ...robot, state: { ...robot.state, lidar: lidarOf({ row: [420, 440, null, null, 470, 320, 230, 181] }) } }; // prettier-ignore
    expect(summaryOf(seen)?.distanceCm).toBe(18);
  });
});
