import { CALLIOPE_1_2 } from '#board/boards/board-of-device';
import type { BoardType, FirmwareType } from '#board/boards/board-type';
import { boardTypes, findBoard } from '#board/boards/index';
import { findRobot } from '#robots/index';
import { AUTO } from '#simulation/hardware';
import { NO_ROBOT } from '#simulation/run-setup';

import type { TextKey } from '../../../kit/i18n/texts';

/** The choice that leaves the board to the course and the program's imports. */
export const AUTO_DEVICE = AUTO;

/** The same for the robot. */
export const AUTO_ROBOT = AUTO;

/** A microcomputer that can be chosen. */
export interface Device {
  /** Its id in the settings. */
  readonly id: string;
  readonly name: string;
  /** Id of the board type it runs as. */
  readonly board: string;
  /** Further information, if there is any. */
  readonly about: TextKey | null;
  /** A text on how it differs from the picture of its board, if it does. */
  readonly picture: TextKey | null;
}

/** Calliope mini 1 and 2 have another chip and no MicroPython of their own; their programs run on the board of the mini 3. */
const OLDER_CALLIOPE: Device = {
  ...CALLIOPE_1_2,
  name: 'Calliope mini 1/2',
  about: 'device.aboutCalliope12',
  picture: 'device.pictureCalliope12',
};

const ABOUT: Readonly<Record<string, TextKey>> = {
  'microbit-v2': 'device.aboutMicrobit',
  'calliope-mini-3': 'device.aboutCalliope3',
};

/** Every microcomputer that can be chosen by name. */
export const devices: readonly Device[] = [
  ...boardTypes.map(({ id, name }) => ({ id, name, board: id, about: ABOUT[id] ?? null, picture: null })),
  OLDER_CALLIOPE,
];

/** True if the settings may name this as the device. */
export const isDevice = (id: string): boolean => id === AUTO_DEVICE || devices.some((device) => device.id === id);

/** True if the settings may name this as the robot. */
export const isRobotChoice = (id: string): boolean => id === AUTO_ROBOT || id === NO_ROBOT || findRobot(id) !== null;

/** The requested board of a run: an id, or `auto`. */
export const boardWish = (device: string): string => devices.find(({ id }) => id === device)?.board ?? AUTO;

/** The firmware of this name where the board has it, else the board's usual one. */
export function firmwareOf(board: BoardType, id: string): FirmwareType {
  return board.firmwares.find((firmware) => firmware.id === id) ?? board.firmwares[0];
}

/** Name of a microcomputer: as it was chosen, else that of its board. */
export function deviceName(device: string, board: BoardType | undefined): string {
  const chosen = devices.find(({ id }) => id === device);
  return chosen?.name ?? board?.name ?? findBoard(boardTypes[0]?.id ?? '')?.name ?? '';
}
