import type { BoardType } from '#board/board-type';
import { boardTypes, findBoard } from '#board/boards/index';
import { findRobot, robotTypes } from '#robots/index';
import type { RobotType } from '#robots/robot';
import type { Scene } from '#scene/scene';

/** What stands for the bare board where a robot could be named. */
export const NO_ROBOT = 'none';

/** Chosen by the scene, else by what the program imports. */
export const AUTO = 'auto';

/** What a run is made of. */
export interface Hardware {
  readonly board: BoardType;
  /** `null`: the bare board. */
  readonly robot: RobotType | null;
}

/** What a run asks for. */
export interface HardwareWish {
  readonly scene: Scene;
  readonly files: Readonly<Record<string, string>>;
  readonly robot: string;
  readonly board: string;
}

/**
 * Finds the board and the robot of a run. An explicit wish wins over the scene, the scene over the program's imports.
 *
 * @returns a problem naming the unknown id and the known ones, when there is no such thing
 */
export function chooseHardware(wish: HardwareWish): Hardware | { readonly problem: string } {
  const robotId = wish.robot === AUTO ? (wish.scene.robot.type ?? AUTO) : wish.robot;
  const robot = robotId === AUTO ? robotByImports(wish.files) : findRobot(robotId);
  if (robot === null && robotId !== NO_ROBOT) {
    const known = [...robotTypes.map((type) => type.id), NO_ROBOT].join(', ');
    return { problem: `Unknown robot "${robotId}". Known robots: ${known}.` };
  }
  const boardId = wish.board === AUTO ? (wish.scene.board ?? robot?.board ?? boardTypes[0]?.id ?? '') : wish.board;
  const board = findBoard(boardId);
  if (board === undefined) {
    const known = boardTypes.map((type) => type.id).join(', ');
    return { problem: `Unknown board "${boardId}". Known boards: ${known}.` };
  }
  return { board, robot };
}

/**
 * Python modules that come along with robots, by file name: those of the chosen robot win, those of the others are
 * there too, as their files would be on a real board that carries another robot, or none.
 */
export function robotLibraries(robot: RobotType | null): Readonly<Record<string, string>> {
  const libraries: Record<string, string> = {};
  for (const type of robotTypes) Object.assign(libraries, type.libraries);
  return Object.assign(libraries, robot?.libraries);
}

/** The first robot one of whose libraries is imported; the first of all robots when none is. */
function robotByImports(files: Readonly<Record<string, string>>): RobotType | null {
  const imported = new Set(Object.values(files).flatMap(importedModules));
  const byImport = robotTypes.find((type) => Object.keys(type.libraries).some((file) => imported.has(moduleOf(file))));
  return byImport ?? robotTypes[0] ?? null;
}

const moduleOf = (file: string): string => file.replace(/\.m?py$/, '');

/** Names of the modules that a Python source imports at the beginning of a line. A guess for a default, never more. */
export function importedModules(source: string): string[] {
  const names: string[] = [];
  for (const [, from, list] of source.matchAll(/^[ \t]*(?:from[ \t]+(\w+)|import[ \t]+([^#\n;]+))/gm)) {
    if (from !== undefined) names.push(from);
    for (const part of list?.split(',') ?? []) names.push(part.trim().split(/[\s.]/)[0] ?? '');
  }
  return names;
}
