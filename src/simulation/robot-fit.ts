import { findBoard } from '#board/boards/index';
import { bringsOneOf, robotOfDrivers } from '#robots/by-module';
import { robotTypes } from '#robots/index';
import type { RobotType } from '#robots/robot';
import type { Hardware } from './hardware';

/** Modules that a program imports: its own files among them, and without those. */
export interface Imports {
  readonly all: ReadonlySet<string>;
  readonly foreign: ReadonlySet<string>;
}

/** A robot that does not fit its program or its board, so that nothing of it answers, or it drives oddly. */
export interface RobotFault {
  /** `lacksRobot`: the program is for one, and there is none. */
  readonly kind: 'otherRobot' | 'lacksRobot' | 'misplugged';
  /** The robot with which program and board fit. */
  readonly fits: RobotType;
  /** Names for a sentence. */
  readonly values: Readonly<Record<string, string>>;
}

type Plugged = Pick<Hardware, 'board' | 'robot'>;

/** True if the robot is on a board that it does not fit: then nothing of it is connected. */
export function isMisplugged({ board, robot }: Plugged): boolean {
  return robot !== null && robot.board !== board.id;
}

/**
 * The other robot for which a program is written: the program imports a module of that robot and none of this one, or
 * else a driver by others for that robot and none for this one. It is a guess for a notice; the run does not depend on
 * it. `null`: the program fits, or it is unclear.
 */
export function robotMeant({ all, foreign }: Imports, robot: RobotType | null): RobotType | null {
  if (robot !== null && bringsOneOf(robot, foreign)) return null;
  const byModule = robotTypes.find((type) => bringsOneOf(type, foreign));
  if (byModule !== undefined) return byModule;
  const drives = robot !== null && Array.from(all).some((name) => robotOfDrivers(new Set([name])) === robot);
  return drives ? null : robotOfDrivers(all);
}

/** The mismatch of robot, board and program; `null`: none. */
export function robotFault({ board, robot }: Plugged, imports: Imports): RobotFault | null {
  const meant = robotMeant(imports, robot);
  if (meant !== null) {
    const values = { meant: meant.name, module: meant.modules[0] ?? '' };
    if (robot === null) return { kind: 'lacksRobot', fits: meant, values };
    return { kind: 'otherRobot', fits: meant, values: { ...values, robot: robot.name, own: robot.modules[0] ?? '' } };
  }
  if (robot === null || !isMisplugged({ board, robot })) return null;
  const values = { robot: robot.name, board: findBoard(robot.board)?.name ?? robot.board, plugged: board.name };
  return { kind: 'misplugged', fits: robot, values };
}
