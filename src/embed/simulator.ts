/**
 * The commands and events of an embedding page: the one port behind every dialect. The app
 * implements it (`src/web/exchange/host`); protocol adapters (`adapter.ts`) translate it to a dialect.
 */
import type { Language } from '#core/languages';
import type { Project, ProjectSettings, SourceFile } from '#project/project';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { InputAction } from '#simulation/input';
import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import type { RunPhase, Speed } from '#simulation/pace';
import type { Ended } from '#simulation/simulation';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';

import type { BreakPoint, EmbeddedDebugger } from './debugger';
import type { Refusal } from './refusal';

export type { Refusal } from './refusal';

/** The parts of the page that a host can show. `tools`: the course editor's beside the arena. */
export const PARTS = ['bar', 'code', 'board', 'arena', 'tools', 'console'] as const;
export type Part = (typeof PARTS)[number];

/** The modes of the arena, in the order in which they are shown: driving, building the course, looking back at a run. */
export const ARENA_MODES = ['drive', 'build', 'lookBack'] as const;
export type ArenaMode = (typeof ARENA_MODES)[number];

/** A host's settings of the page. None are kept in the browser: without the host, the pupil's own choices come back. */
export interface HostSettings extends Partial<Omit<ProjectSettings, 'myRobot'>> {
  readonly language?: Language;
  readonly theme?: 'system' | 'light' | 'dark';
  readonly speed?: Speed;
  readonly muted?: boolean;
  readonly parts?: readonly Part[];
  /** Words of the host for parts of the page, by names of the micro:bit dialect: `button-a`, `start-simulator`, … */
  readonly labels?: Readonly<Record<string, string>>;
}

/** Name of a further device that an event comes from; left out: the first. */
interface FromDevice {
  readonly device?: string;
}

/** The app's events for a host. Everything is plain data. */
export type SimulatorEvent =
  | { readonly type: 'phase'; readonly phase: RunPhase }
  /** A run begins: its program is the present one of `project()`. */
  | { readonly type: 'started' }
  /** Output of the program and the REPL, as on the serial line of our board: lines may end in `\n` or `\r\n`. */
  | ({ readonly type: 'output'; readonly text: string } & FromDevice)
  | ({ readonly type: 'program-ended'; readonly ended: Ended; readonly verdict: Verdict | null } & FromDevice)
  | ({ readonly type: 'program-restarted' } & FromDevice)
  /** `dropped`: packets before these that were not kept, because the program sends faster than anyone could read. */
  | ({ readonly type: 'radio'; readonly packets: readonly RadioPacket[]; readonly dropped?: number } & FromDevice)
  | ({ readonly type: 'log'; readonly events: readonly TimedLogEvent[] } & FromDevice)
  /** A program stands before a line: after a break point or a step, also one into the past. */
  | ({ readonly type: 'held'; readonly timeUs: number } & BreakPoint & FromDevice)
  /** Another moment of the past is looked at; `null`: the present is. */
  | { readonly type: 'looking'; readonly timeUs: number | null }
  /** The break points were changed, no matter who did it. */
  | ({ readonly type: 'break-points'; readonly points: readonly BreakPoint[] } & FromDevice)
  /** About once a frame while something moves. */
  | { readonly type: 'snapshot'; readonly snapshot: Snapshot }
  /** The course was edited or replaced, no matter who did it. */
  | { readonly type: 'scene'; readonly scene: Scene }
  /** The files were changed, no matter who did it. */
  | ({ readonly type: 'files'; readonly files: readonly SourceFile[] } & FromDevice)
  /** The user pressed, touched or set a sensor on the page; the host did not. */
  | ({
      readonly type: 'sensed';
      readonly action: Extract<InputAction, { type: 'button' | 'touch' | 'sensor' }>;
    } & FromDevice)
  /** Settings that hosts know of were changed, no matter who did it. */
  | { readonly type: 'settings'; readonly settings: HostSettings }
  /** An input that the run refused, in one English sentence. */
  | { readonly type: 'refused'; readonly message: string }
  /** The run could not start or failed inside, in one English sentence. */
  | { readonly type: 'failed'; readonly message: string };

/** The app, as a host sees it. Wrong values are refused, never thrown. */
export interface EmbeddedSimulator {
  phase(): RunPhase;
  /** Simulated time of the run, in µs. */
  nowUs(): number;
  snapshot(): Snapshot | null;
  ended(): Ended | null;
  /** Id of the board for the next run. */
  board(): string;
  /** The present work with its settings. */
  project(): Project;
  mode(): ArenaMode;
  settings(): Required<Omit<HostSettings, 'labels'>>;
  /** Values that were set by hand or by a host and hold for every run, by sensor id. */
  sensorWishes(): Readonly<Record<string, number>>;

  /** Opens a project, stopped. The previous work stays one click away if the page has storage. */
  openProject(project: Project): Refusal;
  /**
   * Replaces all files of the program; `main.py` must be among them. The course stays; a current run ends.
   *
   * @param device name of the device; left out: the first
   */
  setFiles(files: readonly SourceFile[], device?: string): Refusal;
  /** Opens a course, stopped. The program stays. */
  setScene(scene: Scene): Refusal;
  /** One step in the course editor; a current run goes on. */
  edit(edit: SceneEdit): Refusal;
  change(settings: HostSettings): Refusal;
  /** Enters a mode of the arena; one that is not offered now is refused. Building and looking back pause a run. */
  enterMode(mode: ArenaMode): Refusal;

  /** Starts a new run, also during a run. Resolves when the run is under way or could not start. */
  run(paused?: boolean): Promise<Refusal>;
  stop(): Promise<void>;
  reset(): Promise<void>;
  pause(): Refusal;
  resume(): Refusal;
  step(): Refusal;
  /**
   * Acts on the run: button, touch, sensor, serial text, radio, hand tool. Sensor values also hold for later runs.
   *
   * @param device name of the device; left out: the first, and for radio all
   */
  input(action: InputAction, device?: string): Refusal;
  clearConsole(): void;
  readonly debug: EmbeddedDebugger;

  /** While set, the page's Run button calls this instead: the host sends the program first. `null`: back to normal. */
  onRunAsked(ask: (() => void) | null): void;
  /** Calls `listener` with every event from now on. @returns a function that ends this */
  listen(listener: (event: SimulatorEvent) => void): () => void;
}
