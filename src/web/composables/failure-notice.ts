import { placementProblems } from '#scene/placement';
import type { Scene } from '#scene/scene';
import type { Hardware } from '#simulation/hardware';

import type { Notice } from './use-notices';

/**
 * What the page says about a run that could not begin: where the course has no room for the robot in the pupil's words,
 * anything else in those of the simulation.
 *
 * @param message what the simulation says
 */
export function failureNotice(message: string, hardware: Pick<Hardware, 'robot'> | null, scene: Scene): Notice {
  const robot = hardware?.robot ?? null;
  const misplaced = robot === null ? undefined : placementProblems(scene, robot.body.outlineMm)[0];
  if (robot === null || misplaced?.message !== message)
    return { kind: 'error', key: 'notice.failed', values: { message } };
  const [x, y] = scene.robot.at.map((mm) => mm / 10);
  return {
    kind: 'error',
    key: misplaced.code === 'robot-outside' ? 'notice.robotOutside' : 'notice.robotInside',
    values: { robot: robot.name, x: x ?? 0, y: y ?? 0 },
  };
}
