import { placementProblems } from '#scene/placement';
import { runRefusal } from '#scene/run-refusal';
import type { Scene } from '#scene/scene';
import type { Hardware } from '#simulation/hardware';

import { t } from '../../kit/i18n';
import type { Notice } from '../../kit/notices';
import words from './words';

/**
 * The page's notice about a run that could not begin: a problem of the course in the pupil's language, anything else in
 * the words of the simulation.
 *
 * @param message text of the simulation
 */
export function failureNotice(message: string, hardware: Pick<Hardware, 'robot'> | null, scene: Scene): Notice {
  const robot = hardware?.robot ?? null;
  const misplaced = robot === null ? undefined : placementProblems(scene, robot.body.outlineMm)[0];
  if (robot === null || misplaced?.message !== message)
    return { kind: 'error', key: 'notice.failed', values: { message: inWords(message, scene) } };
  const [x, y] = scene.robot.at.map((mm) => mm / 10);
  return {
    kind: 'error',
    key: misplaced.code === 'robot-outside' ? 'notice.robotOutside' : 'notice.robotInside',
    values: { robot: robot.name, x: x ?? 0, y: y ?? 0 },
  };
}

function inWords(message: string, scene: Scene): string {
  const refusal = runRefusal(scene);
  return refusal?.message === message ? t(words[refusal.code], refusal.params) : message;
}
