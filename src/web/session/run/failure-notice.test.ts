import { describe, expect, it } from 'vitest';

import { findRobot } from '#robots/index';
import { defaultScene, type Background, type Block, type Mover, type Scene } from '#scene/scene';
import { fitRun } from '#simulation/run-problem';
import { failureNotice } from './failure-notice';
import { soloRun } from '#simulation/run-setup';

const empty = defaultScene();
const callibot = findRobot('callibot');
const mover: Mover = { type: 'mover', id: 'm', at: [900, 600], to: [900, 800], size: [50, 50], angle: 0, speed: 100, spiked: false }; // prettier-ignore
const startAt = (x: number, y: number): Scene => ({ ...empty, robot: { ...empty.robot, at: [x, y], heading: 90 } });

/** The page's notice for the simulation's complaint about this start. */
function noticeAt(scene: Scene) {
  const checked = fitRun(soloRun({ scene, files: {}, robot: 'callibot', board: 'auto', seed: 1, reality: 0 }));
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

  it('says in the page’s language what else no run can begin with', () => {
    const heap = Array.from({ length: 300 }, (_, index): Block => ({ type: 'block', id: `b${String(index)}`, at: [900, 600], size: [50, 50], angle: 0 })); // prettier-ignore
    const movers = Array.from({ length: 101 }, (_, index): Mover => ({ ...mover, id: `m${String(index)}` }));
    const background: Background = { at: [0, 0], size: [100, 100], cells: [9, 9], levels: 'AAAA', picture: '' };
    const messageOf = (scene: Partial<Scene>) => noticeAt({ ...startAt(300, 300), ...scene }).values?.['message'];
    expect(messageOf({ objects: heap })).toMatch(/^An mehr als \d+ Stellen stehen Blöcke ineinander/);
    expect(messageOf({ objects: movers })).toContain('101 fahrende Hindernisse sind zu viele');
    expect(messageOf({ background })).toContain('Das Bild am Boden ist beschädigt.');
  });

  it('hands on what it has no words for', () => {
    expect(failureNotice('broken', { robot: callibot }, empty)).toEqual({
      kind: 'error',
      key: 'notice.failed',
      values: { message: 'broken' },
    });
  });
});
