import type { SceneEdit } from '#scene/edit';
import type { Point, Scene } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import type { Speed } from '#simulation/pace';
import type { Project, SourceFile } from '#project/project';
import type { TaskAbout } from './about';
import type { Exam } from './exam';
import type { TaskLevel } from './levels';
import type { MostHint } from './most-hint';

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
  /** Details for teachers; left out: none. */
  readonly about?: TaskAbout;
  /** Start programs to choose from; left out: that of the project alone. */
  readonly levels?: readonly TaskLevel[];
  /** Left out: it is no exam. */
  readonly exam?: Exam;
  /** The most that hints to a pupil's program tell; left out: `USUAL_HINT`. */
  readonly hint?: MostHint;
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
  /** Reaches one of the zones of these ids, whichever; none given: one of the targets. */
  | { readonly type: 'reach'; readonly zones: readonly string[] }
  | Stop
  /** Is in a zone for that long, all visits together; `zone` as of `stop`. */
  | { readonly type: 'stay'; readonly seconds: number; readonly zone: string | null }
  /** Rounds through all checkpoints in their order, and the targets. */
  | { readonly type: 'laps'; readonly count: number }
  /** All checkpoints, in any order; `each`: points for each one besides those for all, `null`: none. */
  | { readonly type: 'checkpoints'; readonly each: number | null }
  /** A movable block lies in a zone with all its corners, and no robot holds it. */
  | { readonly type: 'belongs'; readonly object: string; readonly zone: string }
  /** The robot's body was over so much of the floor of the arena or of a zone on which a robot can be. */
  | { readonly type: 'covered'; readonly percent: number; readonly zone: string | null }
  /** Reaches this many tiles of a league’s line, the start aside; those of a section that was passed over do not count. */
  | { readonly type: 'tiles'; readonly count: number }
  /** Comes to this many points by the rules of the line’s league. */
  | { readonly type: 'score'; readonly least: number }
  /** At most this many touches of walls, blocks, obstacles and the edge. */
  | { readonly type: 'touches'; readonly most: number }
  /** All that has to be reached is reached within this simulated time. */
  | { readonly type: 'faster'; readonly seconds: number }
  /** All that has to be reached is not reached before this simulated time. */
  | { readonly type: 'later'; readonly seconds: number }
  | Shows
  | Fact;

/** Standing still for that long. */
export interface Stop {
  readonly type: 'stop';
  readonly seconds: number;
  /** Id of a zone in which; `null`: in any target, or anywhere in a course without targets. */
  readonly zone: string | null;
  /** The whole robot is in it, not only the middle of its axle. */
  readonly whole: boolean;
  /** Direction in degrees, as that of a start: 0 along x, counter-clockwise; `null`: any. */
  readonly heading: number | null;
  /** Degrees to either side of it that will do. */
  readonly within: number;
}

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

/** Types of checks of what a program shows, sounds, sends and writes. */
export const showsTypes = [
  ...(['display', 'light', 'sound', 'console', 'radio', 'log'] as const),
] as const satisfies readonly Shows['type'][];

/** All types of checks, in the order in which they are offered. */
export const checkTypes = [
  ...(['goals', 'reach', 'stop', 'stay', 'laps', 'checkpoints', 'belongs', 'covered'] as const),
  ...(['tiles', 'score'] as const),
  ...(['touches', 'faster', 'later'] as const),
  ...showsTypes,
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
  /** Tiles of a league's line, and its points. */
  tiles: { min: 1, max: 1000 },
  score: { min: 1, max: 100_000 },
  touches: { min: 0, max: 10_000 },
  zones: { min: 0, max: 50 },
  /** Angle to either side of a direction. */
  withinDeg: { min: 1, max: 180 },
  percent: { min: 1, max: 100 },
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

/** Angle to either side of a direction that is the same to the eye. Chosen. */
export const USUAL_WITHIN_DEG = 15;

/** The most points that a task gives. */
export function mostPoints({ checks, project }: Pick<ClassTask, 'checks' | 'project'>): number {
  return checks.reduce((sum, check) => sum + check.points + countsOf(check, project.scene), 0);
}

/** The most points of a check beyond those for passing it. */
function countsOf(check: Check, { objects }: Scene): number {
  if (check.type !== 'checkpoints' || check.each === null) return 0;
  return check.each * objects.filter(({ type }) => type === 'checkpoint').length;
}
