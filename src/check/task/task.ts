import type { SceneEdit } from '#scene/edit';
import type { Point, Scene } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import type { Speed } from '#simulation/pace';
import type { Project, SourceFile } from '#project/project';

/** A task for a class: a project, and what its hand-ins are checked for. */
export interface ClassTask {
  /** Course, start program, hardware and settings; without `task`. */
  readonly project: Project;
  /** Hand-ins name the task by it; empty: they need not. */
  readonly id: string;
  /** At least one. */
  readonly checks: readonly Check[];
  /** The visible ones first; without a visible one in the file, the course as it is comes first. */
  readonly worlds: readonly [WorldVariant, ...WorldVariant[]];
  /** Number of hidden worlds in which the checks must hold; `null`: in all. */
  readonly least: number | null;
  /** Simulated seconds after which a run is over; `null`: `usualSeconds`. */
  readonly seconds: number | null;
  /** Points for two and for three stars, the first one is for passing; `null`: no stars. */
  readonly stars: readonly [two: number, three: number] | null;
  /** A program that passes; `null`: none is given. */
  readonly solution: readonly SourceFile[] | null;
  readonly locks: Locks;
}

/**
 * A run without another limit ends after this many simulated seconds. Chosen: more than twice what a pupil who drives
 * slowly takes for the longest ready maze (127 s); a program that never ends costs seconds of wall time.
 */
const USUAL_SECONDS = 300;

/** Time limit of a run in simulated seconds if the task has none: that of the course, else `USUAL_SECONDS`. */
export const usualSeconds = ({ task }: Pick<Scene, 'task'>): number => task.seconds ?? USUAL_SECONDS;

/** Time limit of a run of this task in simulated seconds. */
export const secondsOf = ({ seconds, project }: ClassTask): number => seconds ?? usualSeconds(project.scene);

/** One of the conditions of a task. */
export type Check = CheckKind & {
  /** Unlike the others of the task. */
  readonly id: string;
  /** Points for passing it. */
  readonly points: number;
  /** True: without it the task is not passed; false: it only gives points. */
  readonly needed: boolean;
};

/** The requirement of a check. */
export type CheckKind =
  /** The course's own goals and rules. */
  | { readonly type: 'goals' }
  /**
   * Stands still for that long, in the zone of this id; `null`: in any target, or anywhere in a course without targets.
   */
  | { readonly type: 'stop'; readonly seconds: number; readonly zone: string | null }
  /** Rounds through all checkpoints in their order, and the targets. */
  | { readonly type: 'laps'; readonly count: number }
  /** All checkpoints, in any order. */
  | { readonly type: 'checkpoints' }
  /** At most this many touches of walls, blocks, obstacles and the edge. */
  | { readonly type: 'touches'; readonly most: number }
  /** All that has to be reached is reached within this simulated time. */
  | { readonly type: 'faster'; readonly seconds: number }
  | Shows
  | Fact;

/** Something that the board or the robot must once show, sound, send or write. */
export type Shows =
  /** Rows of digits as in `Image('09090:…')`: which LEDs are lit counts, not how brightly. */
  | { readonly type: 'display'; readonly image: string }
  /** Lights of the robot or of the board; `color`: one of them in this colour. */
  | { readonly type: 'light'; readonly which: LightPlace; readonly color: LightColor | null }
  /** A tone of about this frequency, or any sound. */
  | { readonly type: 'sound'; readonly hz: number | null }
  /** The text in what the program prints. */
  | { readonly type: 'console'; readonly text: string }
  /** A packet with the text in it. */
  | { readonly type: 'radio'; readonly text: string }
  /** This many rows in the data log with a value in this column; empty: any column. */
  | { readonly type: 'log'; readonly rows: number; readonly column: string };

/** Which of the lights. */
export const lightPlaces = ['any', 'left', 'right', 'both'] as const;
export type LightPlace = (typeof lightPlaces)[number];

/** Colours that a class has names for. */
export const lightColors = ['red', 'green', 'blue', 'yellow', 'cyan', 'magenta', 'white'] as const;
export type LightColor = (typeof lightColors)[number];

/** A fact about the program, from its syntax tree. */
export type Fact =
  /** It has a `for` or `while`. */
  | { readonly type: 'loop' }
  /** It calls this function, or one of this object. */
  | { readonly type: 'calls'; readonly name: string }
  /** It has at most this many lines; empty ones and comments do not count. */
  | { readonly type: 'lines'; readonly most: number }
  /** No `delay` or `sleep` is longer. */
  | { readonly type: 'delay'; readonly most: number };

/** All types of checks, in the order in which they are offered. */
export const checkTypes = [
  ...(['goals', 'stop', 'laps', 'checkpoints', 'touches', 'faster'] as const),
  ...(['display', 'light', 'sound', 'console', 'radio', 'log'] as const),
  ...(['loop', 'calls', 'lines', 'delay'] as const),
] as const satisfies readonly CheckKind['type'][];

/** One variation of the task in which a hand-in is run. */
export interface WorldVariant {
  /** Unlike the others of the task. */
  readonly id: string;
  /** True: pupils do not see it. */
  readonly hidden: boolean;
  /** Start pose of the first robot; `null`: as in the course. */
  readonly start: { readonly at: Point; readonly heading: number } | null;
  /** `null`: the project's. */
  readonly seed: number | null;
  readonly reality: number | null;
  /** Changes to the course. */
  readonly edits: readonly SceneEdit[];
  /** Values that the board's sensors have from the start, by their ids. */
  readonly sensors: Readonly<Record<string, number | string>>;
  /** Inputs during the run. */
  readonly inputs: readonly InputEvent[];
}

/** The course as it is. */
export const plainWorld: WorldVariant = {
  ...{ id: 'visible', hidden: false, start: null, seed: null, reality: null },
  ...{ edits: [], sensors: {}, inputs: [] },
};

/** A world's name for people: the visible one's id is not a name. */
export const worldName = ({ id }: Pick<WorldVariant, 'id'>): string => (id === plainWorld.id ? '1' : id);

/**
 * Parts of the work that a pupil's page protects from changes: a help, no security. Important ones are verified when
 * hand-ins are checked.
 */
export interface Locks {
  /** The tools of the course editor that there are, by their ids; `null`: all. */
  readonly tools: readonly string[] | null;
  readonly course: boolean;
  readonly hand: boolean;
  /** The speed that holds; `null`: any. */
  readonly speed: Speed | null;
  readonly robot: boolean;
  readonly solution: boolean;
  /** Lines of `main.py` in the start program that stay as they are, from 1. */
  readonly lines: readonly number[];
}

/** The names of what can be locked as a whole. */
export const lockNames = ['course', 'hand', 'speed', 'robot', 'solution'] as const;

export type LockName = (typeof lockNames)[number];

/** Nothing is locked. */
export const noLocks: Locks = {
  ...{ tools: null, course: false, hand: false, speed: null, robot: false, solution: false },
  lines: [],
};

/** Limits of a task. Chosen: far beyond any lesson. */
export const taskLimits = {
  idCharacters: 100,
  checks: 50,
  points: { min: 0, max: 1000 },
  worlds: 50,
  /** Duration of a run. */
  seconds: { min: 1, max: 3600 },
  laps: { min: 1, max: 100 },
  touches: { min: 0, max: 10_000 },
  hz: { min: 1, max: 100_000 },
  rows: { min: 1, max: 10_000 },
  lines: { min: 1, max: 10_000 },
  delayMs: { min: 0, max: 3_600_000 },
  textCharacters: 1_000,
  seed: { min: 0, max: 0xffffffff },
  edits: 200,
  sensors: 50,
  inputs: 10_000,
  /** Numbers of tools left in the course editor and of locked lines. */
  tools: 50,
  lockedLines: 1000,
} as const;

/** The worlds that pupils do not see. */
export const hiddenWorlds = ({ worlds }: ClassTask): readonly WorldVariant[] => worlds.filter(({ hidden }) => hidden);

/** True if the program's text alone decides a check. */
export const isFact = (check: Check): check is Check & Fact =>
  check.type === 'loop' || check.type === 'calls' || check.type === 'lines' || check.type === 'delay';
