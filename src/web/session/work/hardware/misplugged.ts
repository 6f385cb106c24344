import type { AtTable } from '#advice/at-table';
import { filesByName, type Project } from '#project/project';
import { importsOf } from '#python/imports';
import { robotFault, type RobotFault } from '#simulation/robot-fit';

import { deviceName } from '../settings/devices';
import { hardwareOf, settingsFor } from './hardware';
import type { Settings } from '../settings/settings';
import type { Notice } from '../../../kit/notices';

/** A notice about what does not fit. Its action puts it right; without one a task keeps the robot as it is. */
export type FitNotice = Required<Pick<Notice, 'kind' | 'key' | 'values'>> & Pick<Notice, 'action'>;

/** A device as it is: its work, its settings, and whether a task keeps its robot. */
export interface Fitted {
  readonly project: Project;
  readonly settings: Settings;
  readonly isKept: boolean;
}

type Change = (wish: Partial<Settings>) => void;

/**
 * A notice with the way out if the program is written for another robot, or the robot stands on a microcomputer that it
 * does not fit; otherwise `null`. Nothing of the robot answers then, as in reality. The program's error says only that,
 * if there is an error at all, so the page says what does not fit.
 */
export function mispluggedNotice(device: Fitted, change: Change): FitNotice | null {
  const fault = faultOf(device, 'foreign');
  if (fault === null || fault.kind === 'lacksRobot') return null;
  const { kind, values } = fault;
  if (!device.isKept) return { kind: 'warn', key: `arena.${kind}`, values, action: actionOf(device, fault, change) };
  return { kind: 'warn', key: kind === 'otherRobot' ? 'arena.otherRobotKept' : 'arena.misplugged', values };
}

/** The button for an error whose cause is that the robot does not fit, or that there is none; `null`: none. */
export function robotOffer(device: Fitted, change: Change): Required<Notice>['action'] | null {
  const fault = device.isKept ? null : faultOf(device, 'all');
  return fault && actionOf(device, fault, change);
}

/** The robot's part in the explanation of an error that comes from a robot that does not answer. */
export function robotInError(device: Fitted): AtTable {
  const robot = hardwareOf(device.project, device.settings)?.robot?.name ?? null;
  const fault = faultOf(device, 'all');
  if (fault === null) return { robot, fault };
  const { kind, values } = fault;
  const key = device.isKept && kind !== 'misplugged' ? (`error.${kind}Kept` as const) : (`error.${kind}` as const);
  return { robot, fault: { key, values } };
}

function actionOf({ project, settings }: Fitted, { kind, fits, values }: RobotFault, change: Change) {
  const key = kind === 'misplugged' ? ('arena.plugIn' as const) : ('arena.takeRobot' as const);
  return { key, values, run: () => change(settingsFor(fits, project, settings)) };
}

/**
 * The mismatch, with the microcomputer named as it was chosen.
 *
 * @param drivers in an error, the drivers by others among the project's own files count too: a file may have the name
 *   of one by chance, so by themselves they are no fault
 */
function faultOf({ project, settings }: Fitted, drivers: 'all' | 'foreign'): RobotFault | null {
  const hardware = hardwareOf(project, settings);
  if (hardware === null) return null;
  const imports = importsOf(filesByName(project.files));
  const fault = robotFault(hardware, { ...imports, all: imports[drivers] });
  return fault && { ...fault, values: { ...fault.values, plugged: deviceName(settings.device, hardware.board) } };
}
