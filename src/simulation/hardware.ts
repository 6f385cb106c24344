import type { BoardType, FirmwareType } from '#board/boards/board-type';
import { boardTypes, findBoard } from '#board/boards/index';
import { completeOptions, optionProblem, type OptionValues } from '#core/option';
import { bringsOneOf, robotOfDrivers } from '#robots/by-module';
import { optionsInHand } from '#robots/in-hand';
import { findRobot, robotTypes } from '#robots/index';
import type { RobotType } from '#robots/robot';
import type { RobotStart, Scene } from '#scene/scene';
import { NO_ROBOT } from './run-setup';

/** The scene chooses, otherwise the modules that the program imports. */
export const AUTO = 'auto';

/** The hardware of a run. */
export interface Hardware {
  readonly board: BoardType;
  readonly firmware: FirmwareType;
  /** `null`: the bare board. */
  readonly robot: RobotType | null;
  /** A value for each of the robot's options; of a bare board: what it holds (`optionsInHand`). */
  readonly options: OptionValues;
}

/** The ids of what was chosen, for the set-up of a run. */
export const hardwareIds = ({ board, firmware, robot }: Hardware) => ({
  board: board.id,
  firmware: firmware.id,
  robot: robot?.id ?? NO_ROBOT,
});

/** The requested hardware of a run. */
export interface HardwareWish {
  readonly scene: Scene;
  /** Names of the modules that the program imports: a guess for what is left to `auto`. */
  readonly imports: ReadonlySet<string>;
  readonly robot: string;
  readonly board: string;
  /** Empty or left out: the board's first. */
  readonly firmware?: string;
  /** Chosen options of the robot; they win over those of the scene. */
  readonly robotOptions?: OptionValues;
}

/**
 * Finds the board and the robot of a run. An explicit request wins over the scene, and the scene over the program's
 * imports.
 *
 * @returns for an unknown id, a problem that names it and the known ones
 */
export function chooseHardware(wish: HardwareWish): Hardware | { readonly problem: string } {
  const boardId = wish.board === AUTO ? (wish.scene.board ?? AUTO) : wish.board;
  const named = boardId === AUTO ? boardByImports(wish.imports) : findBoard(boardId);
  if (named === undefined) return placed(wish.board === AUTO, 'board', unknown('board', boardId, boardTypes));
  const robotId = wish.robot === AUTO ? (wish.scene.robot.type ?? AUTO) : wish.robot;
  const robot = robotId === AUTO ? robotByImports(wish.imports, named) : findRobot(robotId);
  if (robot === null && robotId !== NO_ROBOT && robotId !== AUTO)
    return placed(wish.robot === AUTO, 'robot.type', unknown('robot', robotId, [...robotTypes, { id: NO_ROBOT }]));
  const board = named ?? findBoard(robot?.board ?? '') ?? boardTypes[0];
  if (board === undefined) return unknown('board', boardId, boardTypes);
  const [usual] = board.firmwares;
  const firmware = wish.firmware ? board.firmwares.find(({ id }) => id === wish.firmware) : usual;
  if (firmware === undefined)
    return unknown('firmware', wish.firmware ?? '', board.firmwares, `firmwares of the ${board.name}`);
  if (robot === null) return { board, firmware, robot, options: optionsInHand(board, wish.robotOptions) };
  const options = chooseOptions(robot, wish);
  return 'problem' in options ? options : { board, firmware, robot, options: options.values };
}

/** The wish for a device after the first: the course's board and robot are the first one's. */
export interface FurtherWish extends Omit<HardwareWish, 'robotOptions'> {
  /** By the id of the robot. */
  readonly robotOptions: Readonly<Record<string, OptionValues>>;
  /** The start in the course (`furtherStart`), or `null`. */
  readonly start: RobotStart | null;
}

/**
 * The same for a device after the first. What is left to `auto` its program's imports decide, and the robot at its start
 * in the course: without the module of a robot it has none.
 */
export function chooseFurtherHardware(wish: FurtherWish): Hardware | { readonly problem: string } {
  const robot = furtherRobot(wish);
  return chooseHardware({ ...wish, scene: sceneOfFurther(wish), robot, robotOptions: wish.robotOptions[robot] ?? {} });
}

/** The id of the robot of a device after the first. */
export function furtherRobot({ robot, imports, start }: Pick<FurtherWish, 'robot' | 'imports' | 'start'>): string {
  if (robot !== AUTO) return robot;
  const meant = robotTypes.find((type) => bringsOneOf(type, imports));
  return meant === undefined ? NO_ROBOT : (start?.type ?? meant.id);
}

/** The course as a device after the first sees it: its board and robot are the first one's. */
export function sceneOfFurther({ scene, start }: Pick<FurtherWish, 'scene' | 'start'>): Scene {
  return { ...scene, board: null, robot: start ?? { ...scene.robot, type: null, options: {} } };
}

/** A course made for another robot may name options that this one does not have; they are ignored. */
function chooseOptions(
  robot: RobotType,
  { scene, robotOptions = {} }: HardwareWish,
): { readonly values: OptionValues } | { readonly problem: string } {
  const known = robot.options;
  const wished = optionProblem(known, robotOptions);
  if (wished !== null) return { problem: `${robot.name}: ${wished}` };
  const inScene = robot.id === scene.robot.type ? optionProblem(known, scene.robot.options) : null;
  if (inScene !== null) return { problem: `robot.options: ${inScene}` };
  return { values: completeOptions(known, { ...scene.robot.options, ...robotOptions }) };
}

function unknown(
  what: string,
  id: string,
  known: readonly { readonly id: string }[],
  all = `${what}s`,
): { readonly problem: string } {
  return { problem: `Unknown ${what} "${id}". Known ${all}: ${known.map((type) => type.id).join(', ')}.` };
}

/** Puts the place in the scene's file before a problem that comes from there. */
function placed(
  isInScene: boolean,
  where: string,
  { problem }: { readonly problem: string },
): { readonly problem: string } {
  return { problem: isInScene ? `${where}: ${problem}` : problem };
}

/** The board whose own module is imported; `null` if that leaves the choice open. */
function boardByImports(imported: ReadonlySet<string>): BoardType | null {
  const [usual] = boardTypes;
  if (usual?.modules.some((name) => imported.has(name))) return null;
  return boardTypes.find((type) => type.modules.some((name) => imported.has(name))) ?? null;
}

/**
 * The first robot one of whose modules, or a driver by others under a usual name, is imported. Without one, the first
 * robot that carries the named board, or the first of all.
 */
function robotByImports(imported: ReadonlySet<string>, board: BoardType | null): RobotType | null {
  const byImport = robotTypes.find((type) => bringsOneOf(type, imported)) ?? robotOfDrivers(imported);
  return byImport ?? robotTypes.find((type) => board === null || type.board === board.id) ?? null;
}
