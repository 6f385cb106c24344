/**
 * What a page that embeds the app can do with it and hears of it: the one port behind every dialect. The app implements
 * it (`src/web/host`), doors (`door.ts`) speak it outwards in the words of a dialect.
 */
import type { Language } from '#core/texts';
import type { Project, ProjectSettings, SourceFile } from '#project/project';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { InputAction } from '#simulation/input';
import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import type { Ended, Snapshot, Verdict } from '#simulation/simulation';

/** Where a run stands: as on the page. `stopped` keeps the last picture, `ready` is everything at the start. */
export type Phase = 'ready' | 'starting' | 'running' | 'paused' | 'stopping' | 'stopped' | 'killed' | 'failed';

/** Simulated seconds per wall second; `max`: as fast as the machine can. */
export type HostSpeed = 0.25 | 0.5 | 1 | 2 | 4 | 8 | 'max';

/** The parts of the page that a host can show. `tools`: the course editor's beside the arena. */
export const PARTS = ['bar', 'code', 'board', 'arena', 'tools', 'console'] as const;
export type Part = (typeof PARTS)[number];

/** What a host sets of the page. Nothing of it is kept in the browser: the pupil's own choices come back without the host. */
export interface HostSettings extends Partial<ProjectSettings> {
  readonly language?: Language;
  readonly theme?: 'system' | 'light' | 'dark';
  readonly speed?: HostSpeed;
  readonly muted?: boolean;
  readonly parts?: readonly Part[];
  /** Words of the host for parts of the page, by the names of the micro:bit dialect: `button-a`, `start-simulator`, … */
  readonly labels?: Readonly<Record<string, string>>;
}

/** What the app tells a host. Everything is plain data. */
export type SimulatorEvent =
  | { readonly type: 'phase'; readonly phase: Phase }
  /** A run begins: its program is what `project()` has now. */
  | { readonly type: 'started' }
  /** What the program and the REPL print, as on the serial line of our board: lines may end in `\n` or `\r\n`. */
  | { readonly type: 'output'; readonly text: string }
  | { readonly type: 'program-ended'; readonly ended: Ended; readonly verdict: Verdict | null }
  | { readonly type: 'program-restarted' }
  /** `dropped`: packets before these that nobody kept, for the program sends faster than anyone could read. */
  | { readonly type: 'radio'; readonly packets: readonly RadioPacket[]; readonly dropped?: number }
  | { readonly type: 'log'; readonly events: readonly TimedLogEvent[] }
  /** About once a frame while something moves. */
  | { readonly type: 'snapshot'; readonly snapshot: Snapshot }
  /** The course is another one than before, edited or opened, by whomever. */
  | { readonly type: 'scene'; readonly scene: Scene }
  /** The files are others than before, likewise. */
  | { readonly type: 'files'; readonly files: readonly SourceFile[] }
  /** Something on the page pressed, touched or set a sensor: a person, not the host. */
  | { readonly type: 'sensed'; readonly action: Extract<InputAction, { type: 'button' | 'touch' | 'sensor' }> }
  /** A person changed settings that hosts know of. */
  | { readonly type: 'settings'; readonly settings: HostSettings }
  /** An input that the run did not take, in one English sentence. */
  | { readonly type: 'refused'; readonly message: string }
  /** The run could not start or broke inside, likewise. */
  | { readonly type: 'failed'; readonly message: string };

/** `null`: done. Else why not, in one English sentence that names the place and the value; nothing has changed then. */
export type Refusal = string | null;

/** The app as a host sees it. Wrong values are refused, never thrown. */
export interface EmbeddedSimulator {
  phase(): Phase;
  /** Simulated time of the run, in µs. */
  nowUs(): number;
  snapshot(): Snapshot | null;
  ended(): Ended | null;
  /** Id of the board that the next run has. */
  board(): string;
  /** The present work with the settings it runs on. */
  project(): Project;
  settings(): Required<Omit<HostSettings, 'labels'>>;
  /** Values that were set by hand or by a host and hold for every run, by sensor id. */
  sensorWishes(): Readonly<Record<string, number>>;

  /** Opens a project, stopped. What the pupil had before is kept one click away where the page has storage. */
  openProject(project: Project): Refusal;
  /** Replaces all files of the program; `main.py` must be among them. The course stays, a run that is going on ends. */
  setFiles(files: readonly SourceFile[]): Refusal;
  /** Opens a course, stopped; the program stays. */
  setScene(scene: Scene): Refusal;
  /** One step in the course editor; a run that is going on goes on. */
  edit(edit: SceneEdit): Refusal;
  change(settings: HostSettings): Refusal;

  /** Starts anew, also while a run is under way. Ends when the run is under way or could not start. */
  run(paused?: boolean): Promise<Refusal>;
  stop(): Promise<void>;
  reset(): Promise<void>;
  pause(): Refusal;
  resume(): Refusal;
  step(): Refusal;
  /** Does something to the run: a button, a finger, a sensor, serial text, radio, the hand. Sensors also hold for later runs. */
  input(action: InputAction): Refusal;
  clearConsole(): void;

  /** While set, the page's Run button asks this instead of running: the host brings the program first. `null`: back to normal. */
  onRunAsked(ask: (() => void) | null): void;
  /** Calls `listener` with everything that happens from now on. @returns ends it */
  listen(listener: (event: SimulatorEvent) => void): () => void;
}
