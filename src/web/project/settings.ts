import { LANGUAGES, type Language } from '../i18n/texts';
import { SPEEDS, type Speed } from '../worker/protocol';
import { AUTO_DEVICE, AUTO_ROBOT, isDevice, isRobotChoice } from './devices';

/** Light or dark; `system` follows the device. */
export const THEMES = ['system', 'light', 'dark'] as const;
export type Theme = (typeof THEMES)[number];

/** What can be unfolded below the board. */
export const BOARD_PANELS = ['sensors', 'radio', 'log'] as const;
export type BoardPanel = (typeof BOARD_PANELS)[number];

/** What the app looks like and how it runs, for whoever sits at it. Sizes in CSS pixels. */
export interface Settings {
  readonly language: Language;
  readonly theme: Theme;
  readonly speed: Speed;
  readonly muted: boolean;
  readonly cone: boolean;
  readonly showBoard: boolean;
  readonly showArena: boolean;
  /** The microcomputer of the next run: an id of `devices`. */
  readonly device: string;
  /** Id of its firmware; empty, or one that the board does not have: the board's usual one. */
  readonly firmware: string;
  /** Id of a robot type, `none` for the bare board, or `auto`. */
  readonly robot: string;
  /** Whether the editor marks what would not run on the microcomputer. */
  readonly deviceCheck: boolean;
  /** What is unfolded below the board, or `null`. */
  readonly panel: BoardPanel | null;
  /** Whether the board on the robot feels the arena. */
  readonly arenaSenses: boolean;
  /** Width of the code pane, or `null`: as the window's width suggests. The others likewise. */
  readonly codePx: number | null;
  readonly boardPx: number | null;
  readonly consolePx: number | null;
  /** Height of code and board where the arena lies below them. */
  readonly topPx: number | null;
}

/** Settings of a first visit. */
export function defaultSettings(language: Language): Settings {
  return {
    language,
    theme: 'system',
    speed: 1,
    muted: false,
    cone: true,
    showBoard: true,
    showArena: true,
    device: AUTO_DEVICE,
    firmware: '',
    robot: AUTO_ROBOT,
    deviceCheck: true,
    panel: null,
    arenaSenses: false,
    codePx: null,
    boardPx: null,
    consolePx: null,
    topPx: null,
  };
}

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
  const flag = (key: 'muted' | 'cone' | 'showBoard' | 'showArena' | 'arenaSenses' | 'deviceCheck'): boolean =>
    typeof read[key] === 'boolean' ? read[key] : fallback[key];
  const id = (key: 'device' | 'firmware' | 'robot', fits: (value: string) => boolean): string =>
    typeof read[key] === 'string' && fits(read[key]) ? read[key] : fallback[key];
  const size = (key: 'codePx' | 'boardPx' | 'consolePx' | 'topPx'): number | null =>
    typeof read[key] === 'number' && Number.isFinite(read[key]) ? read[key] : null;
  return {
    language: LANGUAGES.find((language) => language === read.language) ?? fallback.language,
    theme: THEMES.find((theme) => theme === read.theme) ?? fallback.theme,
    speed: SPEEDS.find((speed) => speed === read.speed) ?? fallback.speed,
    muted: flag('muted'),
    cone: flag('cone'),
    showBoard: flag('showBoard'),
    showArena: flag('showArena'),
    device: id('device', isDevice),
    firmware: id('firmware', () => true),
    robot: id('robot', isRobotChoice),
    deviceCheck: flag('deviceCheck'),
    panel: BOARD_PANELS.find((panel) => panel === read.panel) ?? fallback.panel,
    arenaSenses: flag('arenaSenses'),
    codePx: size('codePx'),
    boardPx: size('boardPx'),
    consolePx: size('consolePx'),
    topPx: size('topPx'),
  };
}
