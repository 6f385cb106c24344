/** The programs that a robot is measured with: the same on its microcomputer and here. */
import { findBoard } from '#board/boards/index';
import type { Texts } from '#core/languages';
import { LANGUAGES } from '#core/languages';
import type { RobotType } from '#robots/robot';
import distance from './programs/distance.py?languages';
import line from './programs/line.py?languages';
import straight from './programs/straight.py?languages';
import turn from './programs/turn.py?languages';

/** The steps of measuring, in their order. */
export const STEPS = ['straight', 'turn', 'distance', 'line'] as const;
export type Step = (typeof STEPS)[number];

const PROGRAMS = { straight, turn, distance, line } as const;

/** From button A to the start of a drive or turn, in ms: as in the programs. */
export const FINGER_MS = 1000;

/** Duration of each drive and of the turn, in ms, as in the programs. */
export const DRIVE_MS = { slow: 4000, usual: 2000, fast: 1000 } as const;
export const TURN_MS = 2000;

/** Names of the line sensors that read shades of grey, by the robot's id; the others know only light and dark. */
const GREY_SENSORS: Readonly<Record<string, readonly string[]>> = {
  'maqueen-plus-v2': ['L2', 'L1', 'M', 'R1', 'R2'],
  'maqueen-plus-v3': ['L2', 'L1', 'M', 'R1', 'R2'],
};

/** The line sensors of a robot whose readings a program can ask for, from left to right. */
export const greySensors = ({ id }: RobotType): readonly string[] => GREY_SENSORS[id] ?? [];

/** The steps that a robot of this type can do. */
export const stepsOf = (type: RobotType): readonly Step[] =>
  STEPS.filter((step) => step !== 'line' || greySensors(type).length > 0);

/** The program of a step for a robot of this type, in every language. */
export function programOf(step: Step, type: RobotType): Texts {
  const { source } = PROGRAMS[step];
  const board = findBoard(type.board)?.modules[0] ?? 'microbit';
  const names = type.measuring?.trimEnd() ?? `from ${type.modules[0] ?? ''} import *`;
  const adapted = (text: string): string =>
    text.replace('from microbit import', `from ${board} import`).replace(/from mbrobot\w* import \*/, names);
  return Object.fromEntries(LANGUAGES.map((language) => [language, adapted(source[language])])) as unknown as Texts;
}
