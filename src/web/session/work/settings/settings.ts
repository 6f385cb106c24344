import type { OptionValues } from '#core/option';
import { isRecord } from '#core/record';
import type { MyRobot } from '#my-robot/my-robot';
import { newWork } from '#project/project';
import { robotTypes } from '#robots/index';
import { SPEEDS, type Speed } from '#simulation/pace';
import { LANGUAGES, type Language } from '../../../kit/i18n/texts';
import { readLightWishes, type LightWishes } from './light-wish';
import { AUTO_DEVICE, AUTO_ROBOT, isDevice, isRobotChoice } from './devices';

/** Light or dark; `system` follows the device. */
export const THEMES = ['system', 'light', 'dark'] as const;
export type Theme = (typeof THEMES)[number];

/** The panels below the board. */
export const BOARD_PANELS = ['sensors', 'radio', 'log', 'hand'] as const;
export type BoardPanel = (typeof BOARD_PANELS)[number];

/** The units in which a lidar's picture is shown. */
export const LIDAR_UNITS = ['cm', 'mm'] as const;
export type LidarUnit = (typeof LIDAR_UNITS)[number];

/** The look of the app and its way of running, for the person who uses it. Sizes in CSS pixels. */
export interface Settings {
  readonly language: Language;
  readonly theme: Theme;
  readonly speed: Speed;
  readonly muted: boolean;
  /** Shows the robot's senses in the arena: the beam of its distance sensor, what its line sensors see, … */
  readonly cone: boolean;
  readonly spots: boolean;
  /** … the point around which it turns, and its trail. */
  readonly centre: boolean;
  readonly trace: boolean;
  /** True if the arena shows what the devices send by radio. */
  readonly packets: boolean;
  /** Form and place of chains of lights, as far as they were chosen. */
  readonly lights: LightWishes;
  readonly showBoard: boolean;
  readonly showArena: boolean;
  /** The microcomputer of the next run: an id of `devices`, or `auto`. */
  readonly device: string;
  /** Id of its firmware; empty, or one that the board does not have: the board's usual one. */
  readonly firmware: string;
  /** Id of a robot type, `none` for the bare board, or `auto`. */
  readonly robot: string;
  /** The changed options of robots: id of the robot → id of the option → id of the choice. It wins over the course. */
  readonly robotOptions: RobotOptions;
  /** The robot's likeness to a used one, 0 (ideal) … 1. */
  readonly reality: number;
  /** Number of the used robot, 1 … `LAST_SEED`: the same number always gives the same faults. */
  readonly seed: number;
  /** The pupil's own robot, as it was measured, or `null`. */
  readonly myRobot: MyRobot | null;
  /** True if the editor marks what would not run on the microcomputer. */
  readonly deviceCheck: boolean;
  /** The open panel below the board, or `null`. */
  readonly panel: BoardPanel | null;
  readonly lidarUnit: LidarUnit;
  /** True if the board on the robot feels the arena. */
  readonly arenaSenses: boolean;
  /** The course is built: the tools are there (`session/mode`). */
  readonly showTools: boolean;
  /** Somebody has looked back once: the mode is no longer new. */
  readonly lookedBack: boolean;
  /** The card of a task is unfolded; otherwise it is its title line. */
  readonly showCard: boolean;
  /** The commands to choose from are open below the program. */
  readonly showCommands: boolean;
  /** The picture follows the robot. */
  readonly follow: boolean;
  /** Describes the drive in words for screen readers; … */
  readonly tell: boolean;
  /** … and by tones, while the drive is described. */
  readonly tones: boolean;
  /** A small celebration when a task is passed. */
  readonly celebrate: boolean;
  /** The greeting of a first visit was answered. */
  readonly welcomed: boolean;
  /** The step at which the tour was left; `null`: it was never begun, or is over. */
  readonly tourStep: string | null;
  /** Width of the code pane, or `null` to follow the window's width. The others work in the same way. */
  readonly codePx: number | null;
  readonly boardPx: number | null;
  readonly consolePx: number | null;
  /** Height of code and board where the arena lies below them. */
  readonly topPx: number | null;
  /** Height of the board where it lies below the program. */
  readonly belowPx: number | null;
  /** The arena has two thirds of the window. */
  readonly cinema: boolean;
}

/** Chosen options by the robot's id. */
export type RobotOptions = Readonly<Record<string, OptionValues>>;

/** Number of used robots to choose from. */
export const LAST_SEED = 9999;

/** True for the number of a used robot: a whole number, 1 … `LAST_SEED`. */
export const isSeed = (value: unknown): value is number =>
  typeof value === 'number' && Number.isInteger(value) && value >= 1 && value <= LAST_SEED;

/** Settings of a first visit. */
export function defaultSettings(language: Language): Settings {
  return {
    language,
    theme: 'system',
    speed: 1,
    muted: false,
    cone: true,
    spots: false,
    centre: false,
    trace: false,
    packets: false,
    lights: {},
    showBoard: true,
    showArena: true,
    device: AUTO_DEVICE,
    firmware: '',
    robot: AUTO_ROBOT,
    robotOptions: {},
    reality: 0,
    seed: 1,
    myRobot: null,
    deviceCheck: true,
    panel: null,
    lidarUnit: 'cm',
    ...newWork,
    showTools: false,
    lookedBack: false,
    showCard: true,
    showCommands: false,
    follow: false,
    tell: false,
    tones: true,
    celebrate: true,
    welcomed: false,
    tourStep: null,
    codePx: null,
    boardPx: null,
    consolePx: null,
    topPx: null,
    belowPx: null,
    cinema: false,
  };
}

/** Settings that are on or off. */
type Flag =
  | 'muted'
  | 'cone'
  | 'spots'
  | 'centre'
  | 'trace'
  | 'packets'
  | 'showBoard'
  | 'showArena'
  | 'arenaSenses'
  | 'deviceCheck'
  | 'showTools'
  | 'lookedBack'
  | 'showCard'
  | 'showCommands'
  | 'follow'
  | 'tell'
  | 'tones'
  | 'celebrate'
  | 'cinema';

/** Reads stored settings; what is missing or makes no sense is as in `fallback`. */
export function settingsFromText(text: string | null, fallback: Settings): Settings {
  let value: unknown = null;
  try {
    value = JSON.parse(text ?? 'null');
  } catch {
    return fallback;
  }
  if (typeof value !== 'object' || value === null) return fallback;
  const read = value as Record<keyof Settings, unknown>;
  const flag = (key: Flag): boolean => (typeof read[key] === 'boolean' ? read[key] : fallback[key]);
  const id = (key: 'device' | 'firmware' | 'robot', fits: (value: string) => boolean): string =>
    typeof read[key] === 'string' && fits(read[key]) ? read[key] : fallback[key];
  const size = (key: 'codePx' | 'boardPx' | 'consolePx' | 'topPx' | 'belowPx'): number | null =>
    typeof read[key] === 'number' && Number.isFinite(read[key]) ? read[key] : null;
  return {
    language: LANGUAGES.find((language) => language === read.language) ?? fallback.language,
    theme: THEMES.find((theme) => theme === read.theme) ?? fallback.theme,
    speed: SPEEDS.find((speed) => speed === read.speed) ?? fallback.speed,
    muted: flag('muted'),
    cone: flag('cone'),
    spots: flag('spots'),
    centre: flag('centre'),
    trace: flag('trace'),
    packets: flag('packets'),
    lights: readLightWishes(read.lights),
    showBoard: flag('showBoard'),
    showArena: flag('showArena'),
    device: id('device', isDevice),
    firmware: id('firmware', () => true),
    robot: id('robot', isRobotChoice),
    robotOptions: readRobotOptions(read.robotOptions),
    reality:
      typeof read.reality === 'number' && read.reality >= 0 && read.reality <= 1 ? read.reality : fallback.reality,
    seed: isSeed(read.seed) ? read.seed : fallback.seed,
    myRobot: myRobotFrom(read.myRobot),
    deviceCheck: flag('deviceCheck'),
    panel: BOARD_PANELS.find((panel) => panel === read.panel) ?? fallback.panel,
    lidarUnit: LIDAR_UNITS.find((unit) => unit === read.lidarUnit) ?? fallback.lidarUnit,
    arenaSenses: flag('arenaSenses'),
    showTools: flag('showTools'),
    lookedBack: flag('lookedBack'),
    showCard: flag('showCard'),
    showCommands: flag('showCommands'),
    follow: flag('follow'),
    tell: flag('tell'),
    tones: flag('tones'),
    celebrate: flag('celebrate'),
    // Anyone whose settings are older than the greeting knows the app.
    welcomed: read.welcomed !== false,
    tourStep: typeof read.tourStep === 'string' ? read.tourStep : null,
    codePx: size('codePx'),
    boardPx: size('boardPx'),
    consolePx: size('consolePx'),
    topPx: size('topPx'),
    belowPx: size('belowPx'),
    cinema: flag('cinema'),
  };
}

/**
 * A measured robot, or `null`. Its shape is looked at and no more: whatever brings one from elsewhere has read it, and the
 * code for that (`#my-robot/my-robot`) comes only where a robot is measured or brought.
 */
function myRobotFrom(value: unknown): MyRobot | null {
  if (!isRecord(value) || !isRecord(value['measured']) || !isRecord(value['traits'])) return null;
  const { name, robot, used, measured, traits } = value;
  const { motors, ultrasonic, line } = traits;
  const isWhole =
    [measured['drives'], measured['line'], line].every(isRecord) &&
    Array.isArray(measured['echoesMm']) &&
    areNumbers(motors, ['difference', 'charge', 'sag', 'friction']) &&
    areNumbers(ultrasonic, ['offsetMm', 'scale']);
  const isNamed = typeof name === 'string' && typeof used === 'boolean' && robotTypes.some(({ id }) => id === robot);
  return isWhole && isNamed ? (value as unknown as MyRobot) : null;
}

const areNumbers = (value: unknown, names: readonly string[]): boolean =>
  isRecord(value) && names.every((name) => Number.isFinite(value[name]));

/** Reads stored options, as far as this version of the app knows them: robots come and go, and so do their options. */
function readRobotOptions(value: unknown): RobotOptions {
  if (!isRecord(value)) return {};
  const robots = robotTypes.map(({ id, options }): [string, OptionValues] => {
    const own = value[id];
    const kept = options.filter((option) => isRecord(own) && option.choices.some((it) => it.id === own[option.id]));
    return [id, Object.fromEntries(kept.map((option) => [option.id, String(isRecord(own) ? own[option.id] : '')]))];
  });
  return Object.fromEntries(robots.filter(([, options]) => Object.keys(options).length > 0));
}
