import { findBoard } from '#board/boards/index';
import { isMisplugged } from '#simulation/hardware';

import { deviceName } from '../project/devices';
import { hardwareOf, settingsFor } from '../project/hardware';
import type { Project } from '../project/project';
import type { Settings } from '../project/settings';
import type { Notice } from './use-notices';

/**
 * What is wrong when the robot stands on a microcomputer that it does not fit, and the way out; else `null`. Nothing of
 * the robot answers then, as on the table: the program's error says only that, so the page tells what is plugged where.
 */
export function mispluggedNotice(
  project: Project,
  now: Settings,
  change: (wish: Partial<Settings>) => void,
): Required<Notice> | null {
  const hardware = hardwareOf(project, now);
  const robot = hardware?.robot ?? null;
  if (hardware === null || robot === null || !isMisplugged(hardware)) return null;
  return {
    kind: 'warn',
    key: 'arena.misplugged',
    values: {
      robot: robot.name,
      board: findBoard(robot.board)?.name ?? robot.board,
      plugged: deviceName(now.device, hardware.board),
    },
    action: { key: 'arena.plugIn', run: () => change(settingsFor(robot, project, now)) },
  };
}
