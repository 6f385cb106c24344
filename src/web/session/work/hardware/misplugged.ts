import { findBoard } from '#board/boards/index';
import { filesByName, type Project } from '#project/project';
import { foreignModules } from '#python/imports';
import { isMisplugged, robotMeant } from '#simulation/hardware';

import type { TextKey, TextValues } from '../../../kit/i18n/texts';
import { deviceName } from '../settings/devices';
import { hardwareOf, settingsFor } from './hardware';
import type { Settings } from '../settings/settings';
import type { Notice } from '../../../kit/notices';

/** The robot, as far as it can cause an error. */
export interface RobotInError {
  /** Name of the robot; `null`: none. */
  readonly robot: string | null;
  /** The reason why it cannot answer; `null`: it can, or the reason is unknown. */
  readonly fault: { readonly key: TextKey; readonly values: TextValues } | null;
}

/**
 * A notice with the way out if the program is written for another robot, or the robot stands on a microcomputer that it
 * does not fit; otherwise `null`. Nothing of the robot answers then, as in reality. The program's error says only that,
 * if there is an error at all, so the page says what does not fit.
 */
export function mispluggedNotice(
  project: Project,
  now: Settings,
  change: (wish: Partial<Settings>) => void,
): Required<Omit<Notice, 'holds'>> | null {
  const fault = faultOf(project, now);
  if (fault === null) return null;
  const { kind, values, robot } = fault;
  const action = kind === 'otherRobot' ? ('takeRobot' as const) : ('plugIn' as const);
  return {
    kind: 'warn',
    key: `arena.${kind}`,
    values,
    action: { key: `arena.${action}`, values, run: () => change(settingsFor(robot, project, now)) },
  };
}

/** The robot's part in the explanation of an error that comes from a robot that does not answer. */
export function robotInError(project: Project, now: Settings): RobotInError {
  const fault = faultOf(project, now);
  const robot = hardwareOf(project, now)?.robot ?? null;
  if (fault !== null)
    return { robot: robot?.name ?? null, fault: { key: `error.${fault.kind}`, values: fault.values } };
  const needsOne = robot === null && robotMeant(foreignModules(filesByName(project.files)), null) !== null;
  return { robot: robot?.name ?? null, fault: needsOne ? { key: 'error.noRobot', values: {} } : null };
}

/** The mismatch, its words, and the robot that fits. */
function faultOf(project: Project, now: Settings) {
  const hardware = hardwareOf(project, now);
  const robot = hardware?.robot ?? null;
  if (hardware === null || robot === null) return null;
  const meant = robotMeant(foreignModules(filesByName(project.files)), robot);
  if (meant !== null)
    return { kind: 'otherRobot' as const, robot: meant, values: { meant: meant.name, robot: robot.name } };
  if (!isMisplugged(hardware)) return null;
  const values: TextValues = {
    robot: robot.name,
    board: findBoard(robot.board)?.name ?? robot.board,
    plugged: deviceName(now.device, hardware.board),
  };
  return { kind: 'misplugged' as const, robot, values };
}
