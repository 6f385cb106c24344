import { describe, expect, it } from 'vitest';

import { findRobot } from '#robots/index';
import { defaultScene, type Scene } from '#scene/scene';
import { checkRun } from '#simulation/run-problem';
import { failureNotice } from './failure-notice';

const empty = defaultScene();
const callibot = findRobot('callibot');
const startAt = (x: number, y: number): Scene => ({ ...empty, robot: { ...empty.robot, at: [x, y], heading: 90 } });

/** What the simulation says about this start, and what the page makes of it. */
function noticeAt(scene: Scene) {
  const checked = checkRun({ scene, files: {}, robot: 'callibot', board: 'auto', seed: 1, reality: 0 });
  if (!('problem' in checked)) throw new Error('The robot has room there.');
  return failureNotice(checked.problem, { robot: callibot }, scene);
}

describe('the notice about a run that could not begin', () => {
  it('says in the page’s own words that the robot sticks out of the arena', () => {
    expect(noticeAt(startAt(20, 130))).toEqual({
      kind: 'error',
      key: 'notice.robotOutside',
      values: { robot: 'Calli:bot', x: 2, y: 13 },
    });
  });

  it('says that something is in the robot’s way where it stands inside a wall', () => {
    const wall = { type: 'wall', id: 'w', from: [300, 300], to: [500, 300], thickness: 10 } as const;
    const scene: Scene = { ...startAt(405, 300), objects: [wall] };
    expect(noticeAt(scene)).toMatchObject({
      key: 'notice.robotInside',
      values: { robot: 'Calli:bot', x: 40.5, y: 30 },
    });
  });

  it('hands on what it has no words for', () => {
    expect(failureNotice('broken', { robot: callibot }, empty)).toEqual({
      kind: 'error',
      key: 'notice.failed',
      values: { message: 'broken' },
    });
  });
});
