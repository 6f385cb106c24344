import type { BoardType, FirmwareType } from '#board/board-type';
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
  readonly firmware: FirmwareType;
  /** `null`: the bare board. */
  readonly robot: RobotType | null;
}

/** What a run asks for. */
export interface HardwareWish {
  readonly scene: Scene;
  readonly files: Readonly<Record<string, string>>;
  readonly robot: string;
  readonly board: string;
  /** Empty or left out: the board's first. */
  readonly firmware?: string;
}

/**
 * Finds the board and the robot of a run. An explicit wish wins over the scene, the scene over the program's imports.
 *
 * @returns a problem naming the unknown id and the known ones, when there is no such thing
 */
export function chooseHardware(wish: HardwareWish): Hardware | { readonly problem: string } {
  const imported = new Set(Object.values(wish.files).flatMap(importedModules));
  const boardId = wish.board === AUTO ? (wish.scene.board ?? AUTO) : wish.board;
  const named = boardId === AUTO ? boardByImports(imported) : findBoard(boardId);
  if (named === undefined) return unknown('board', boardId, boardTypes);
  const robotId = wish.robot === AUTO ? (wish.scene.robot.type ?? AUTO) : wish.robot;
  const robot = robotId === AUTO ? robotByImports(imported, named) : findRobot(robotId);
  if (robot === null && robotId !== NO_ROBOT && robotId !== AUTO)
    return unknown('robot', robotId, [...robotTypes, { id: NO_ROBOT }]);
  const board = named ?? findBoard(robot?.board ?? '') ?? boardTypes[0];
  if (board === undefined) return unknown('board', boardId, boardTypes);
  const [usual] = board.firmwares;
  const firmware = wish.firmware ? board.firmwares.find(({ id }) => id === wish.firmware) : usual;
  if (firmware === undefined)
    return unknown('firmware', wish.firmware ?? '', board.firmwares, `firmwares of the ${board.name}`);
  return { board, firmware, robot };
}

function unknown(
  what: string,
  id: string,
  known: readonly { readonly id: string }[],
  all = `${what}s`,
): { readonly problem: string } {
  return { problem: `Unknown ${what} "${id}". Known ${all}: ${known.map((type) => type.id).join(', ')}.` };
}

/** The board whose own module is imported; `null` when that leaves the choice open. */
function boardByImports(imported: ReadonlySet<string>): BoardType | null {
  const [usual] = boardTypes;
  if (usual?.modules.some((name) => imported.has(name))) return null;
  return boardTypes.find((type) => type.modules.some((name) => imported.has(name))) ?? null;
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

/**
 * The first robot one of whose libraries is imported; when none is, the first that carries the board, if that was
 * named, or of all.
 */
function robotByImports(imported: ReadonlySet<string>, board: BoardType | null): RobotType | null {
  const byImport = robotTypes.find((type) => Object.keys(type.libraries).some((file) => imported.has(moduleOf(file))));
  return byImport ?? robotTypes.find((type) => board === null || type.board === board.id) ?? null;
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
