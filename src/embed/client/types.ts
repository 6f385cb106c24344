import type {
  CommandName,
  Commands,
  EventName,
  Events,
  FloorPose,
  PageSettings,
  Position,
  ProjectFile,
  RefusalCode,
  RobotChoice,
  SceneFile,
  State,
  Welcome,
} from '../parcours/protocol';
import type { ArenaMode } from '../simulator';
import type { SourceFile } from '#project/project';
import type { SceneEdit } from '#scene/edit';
import type { BreakPoint } from '#vm/debug/stops';

export type * from '../parcours/protocol';
export type { SourceFile } from '#project/project';
export type { SceneEdit } from '#scene/edit';
export type { EndedWord } from '#simulation/report';
export type { Verdict } from '#simulation/task/verdict';
export type { Shown } from '#vm/debug/shown';
export type { BreakPoint } from '#vm/debug/stops';

/** The simulator in another page, for its host. `device`: the name of a microcomputer; left out: the first. */
export interface Parcours {
  /** The page's answer to the last hello. */
  readonly welcome: Welcome;

  /** Opens a project, stopped: its file as text or value. */
  setProject(project: ProjectFile | string): Promise<void>;
  getProject(): Promise<ProjectFile>;
  /** Replaces all files of the program; `main.py` must be among them. */
  setFiles(files: readonly SourceFile[], device?: string): Promise<void>;
  getFiles(device?: string): Promise<readonly SourceFile[]>;
  /** Opens a course, stopped: its file as text or value. */
  setScene(scene: SceneFile | string): Promise<void>;
  getScene(): Promise<SceneFile>;
  /** Changes the course, also during a run. */
  edit(edit: SceneEdit): Promise<void>;
  setRobot(choice: Partial<RobotChoice>): Promise<void>;
  getRobot(): Promise<RobotChoice>;
  /** Language, theme, sound, shown parts, words of the board's controls. The browser keeps none of these. */
  setSettings(settings: Partial<PageSettings> & { readonly labels?: Readonly<Record<string, string>> }): Promise<void>;
  getSettings(): Promise<PageSettings>;
  /** Enters a mode of the arena; refused where it is not offered: a task may lock the course, a past needs a run. */
  setMode(mode: ArenaMode): Promise<void>;

  /** Starts a new run. Resolves when the program runs. */
  run(options?: { readonly paused?: boolean }): Promise<void>;
  /** Ends the run; the last picture stays. */
  stop(): Promise<void>;
  /** Ends the run and puts everything back to the start. */
  reset(): Promise<void>;
  pause(): Promise<void>;
  resume(): Promise<void>;
  /** Lets 20 ms of simulated time pass. */
  step(): Promise<void>;

  /** Gets the place of the program and its variables: at the moment that is looked at, else now. */
  getPosition(device?: string): Promise<Position>;
  /**
   * Sets the lines at which the program stops, replacing all earlier ones; `[]`: none. Another project or course
   * clears them.
   */
  setBreakPoints(points: readonly BreakPoint[], device?: string): Promise<void>;
  getBreakPoints(device?: string): Promise<readonly BreakPoint[]>;
  /**
   * A step by lines of a program that stands: `over`, `into`, `out`; the event `held` says where it ends. `back`, and any
   * step from a moment of the past, resolves when the line is shown.
   */
  stepLine(step: Commands['step-line']['fields']['step'], device?: string): Promise<void>;
  /** Lets a program that stands run on until a line begins; otherwise like `stepLine`. */
  runTo(place: BreakPoint, device?: string): Promise<void>;
  /** Pauses, and shows a moment that the run has been through, in simulated ms. */
  lookAt(atMs: number): Promise<void>;
  /** Shows the present again; the run stands until `resume`. */
  lookNow(): Promise<void>;
  /** Lets the run go on from the moment that is looked at. Resolves when it is there. */
  goOn(options?: { readonly paused?: boolean }): Promise<void>;

  /** Simulated seconds per second, 0.25 … 8, or `max`. */
  setSpeed(speed: Commands['speed']['fields']['speed']): Promise<void>;
  /** Which of the used robots it is, 1 … 9999. */
  setSeed(seed: number): Promise<void>;
  /** 0: ideal … 1: like a used school robot. */
  setReality(reality: number): Promise<void>;

  place(pose: FloorPose, device?: string): Promise<void>;
  placeBlock(block: string, pose: FloorPose): Promise<void>;
  press(button: 'a' | 'b', down: boolean, device?: string): Promise<void>;
  touch(pad: string, down: boolean, device?: string): Promise<void>;
  setSensor(sensor: string, value: number | string, device?: string): Promise<void>;
  /** Chooses whether compass, accelerometer and light sensor measure the arena. */
  setArenaSenses(on: boolean): Promise<void>;
  /** Types text into the serial line: for `input()` or the REPL. */
  serial(text: string, device?: string): Promise<void>;
  /** Raises KeyboardInterrupt in the program. */
  interrupt(device?: string): Promise<void>;
  /** Delivers a radio packet, as `radio.send` of another board sends it, or bytes: to all microcomputers, or to one. */
  radio(packet: string | readonly number[] | Uint8Array, device?: string): Promise<void>;
  clearConsole(): Promise<void>;

  getState(): Promise<State>;
  /** Which events are sent (at first all), and how many snapshots a second (at first 0), 0 … 60. */
  subscribe(wish: Commands['subscribe']['fields']): Promise<void>;

  /** Calls `listener` with every event of this kind from now on. @returns a function that ends this */
  on<E extends keyof ClientEvents>(event: E, listener: (data: ClientEvents[E]) => void): () => void;
  /** Sends any command by its name; the methods above use it. */
  send<N extends CommandName>(type: N, ...fields: FieldsOf<N>): Promise<Commands[N]['result']>;
  /** Says bye. Waiting commands are rejected with `closed`. */
  close(): void;
}

/** Fields of a command; none if it has none. */
export type FieldsOf<N extends CommandName> =
  Partial<Commands[N]['fields']> extends Commands[N]['fields']
    ? [fields?: Commands[N]['fields']]
    : [fields: Commands[N]['fields']];

/** The events of `on`: the page's events, and those of the connection. */
export type ClientEvents = { readonly [E in EventName]: Events[E] } & {
  /** The page was loaded anew and answers again: project and settings are those of a fresh page. */
  readonly restarted: Welcome;
};

/** Why a command was not carried out: the page's reasons, and the connection's. */
export type ErrorCode =
  | RefusalCode
  /** No answer in time: the page is missing, is not ours, or does not allow its host to command it. */
  | 'timeout'
  /** The page was loaded anew before it answered. */
  | 'restarted'
  /** The host has closed the connection. */
  | 'closed'
  /** The message cannot be sent because it is not plain data. */
  | 'not-plain'
  /** An attribute of the element has a value that makes no sense; `path` names it. */
  | 'wrong-attribute';

/** How to connect. */
export interface ConnectOptions {
  /** How long hello is repeated until the page answers, in ms. Default 30,000. */
  readonly timeoutMs?: number;
  /** How long a command may take, in ms. Default 60,000: a first run fetches the VM. */
  readonly commandTimeoutMs?: number;
  /** Origin of the page; by default that of the frame's `src`. A `Window` without it is greeted whatever it shows. */
  readonly origin?: string;
  /** Use a `MessagePort` of its own instead of the window. */
  readonly usePort?: boolean;
  /** Name of the host, for the page's log. */
  readonly client?: string;
  /** As for `subscribe`; holds from the start and again after a restart. */
  readonly subscribe?: Commands['subscribe']['fields'];
}
