/**
 * Our own dialect as types: every command with its fields and its answer, every event. Nothing here exists at run time,
 * so that the client (`../client`) can be typed by it and stays free of dependencies. The schemas
 * (`command-schemas.ts`) validate incoming messages; the compiler checks them against these types.
 *
 * Every message is `{ parcours: 1, type, … }`. A command with an `id` is answered, in the order of the commands, by `{
 * parcours: 1, reply: id, ok: true, … }` or `{ parcours: 1, reply: id, ok: false, code, message, path }`.
 */
import type { Rgb } from '#core/rgb';
import type { Language } from '#core/languages';
import type { ProjectSettings, SourceFile } from '#project/project';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { PlacedPose } from '#simulation/input';
import type { RunPhase, Speed } from '#simulation/pace';
import type { RobotSnapshot } from '#simulation/snapshot';
import type { EndedWord, PacketReport, RobotReport } from '#simulation/report';
import type { Ended } from '#simulation/simulation';
import type { Verdict } from '#simulation/task/verdict';
import type { Shown } from '#vm/debug/shown';
import type { BreakPoint, Step } from '#vm/debug/stops';

import type { ArenaMode, Part } from '../simulator';

/** The version of this dialect. A new version is a change that an older host would not understand. */
export type ProtocolVersion = 1;

/** Common fields of every message. */
export interface Envelope {
  readonly parcours: ProtocolVersion;
}

/** A host's number for a command. */
export type CommandId = number | string;

/** A course in the form of its file: default values are left out, also within the objects (`src/scene/FORMAT.md`). */
export type SceneFile = Partial<Omit<Scene, 'robot' | 'task' | 'objects'>> & {
  readonly format: 'parcours-scene';
  readonly version: number;
  readonly robot?: Partial<Scene['robot']>;
  readonly task?: Partial<Scene['task']>;
  readonly objects?: readonly { readonly type: string; readonly id: string; readonly [property: string]: unknown }[];
};

/** Name of a microcomputer of the project, where there are several; left out: the first. */
export interface OfDevice {
  readonly device?: string;
}

/** A project in the form of its file. */
export interface ProjectFile {
  readonly format: 'parcours-project';
  readonly version: number;
  /** Id of the ready course from which it started. */
  readonly course?: string;
  readonly settings?: ProjectSettings;
  readonly files: readonly SourceFile[];
  /** In a project with several microcomputers: the name of the first, and the further ones. */
  readonly devices?: { readonly first: string; readonly others: readonly object[] };
  readonly scene: SceneFile;
}

/** The hardware of a run: robot, its options, microcomputer and firmware. */
export interface RobotChoice {
  /** Id of a robot type, `none` for the bare board, or `auto`. */
  readonly robot: string;
  /** Id of the robot → id of the option → id of the choice. */
  readonly robotOptions: Readonly<Record<string, Readonly<Record<string, string>>>>;
  /** Id of the microcomputer, or `auto`. */
  readonly device: string;
  /** Id of its firmware; empty: the usual one. */
  readonly firmware: string;
}

/** Settings of the page for a host. */
export interface PageSettings {
  readonly language: Language;
  readonly theme: 'system' | 'light' | 'dark';
  readonly muted: boolean;
  readonly parts: readonly Part[];
}

/** A pose on the floor: mm from the arena's lower left corner, degrees counter-clockwise from +x. */
export type FloorPose = PlacedPose;

/** The page's abilities: every name that its commands, events and settings take. */
export interface Abilities {
  readonly commands: readonly string[];
  readonly events: readonly string[];
  readonly devices: readonly string[];
  readonly robots: readonly string[];
  /** Missing in pages up to 0.1.0. */
  readonly courses?: readonly string[];
  readonly languages: readonly Language[];
  readonly speeds: readonly Speed[];
  readonly parts: readonly Part[];
  readonly limits: {
    readonly files: number;
    readonly fileBytes: number;
    readonly serialCharacters: number;
    readonly waitingCommands: number;
    readonly snapshotHz: number;
    readonly outputCharactersPerSecond: number;
  };
}

/** The answer to `hello`. */
export interface Welcome {
  /** The versions of this dialect that the page speaks. */
  readonly versions: readonly number[];
  /** The version of the app. */
  readonly app: string;
  /** Changes with every load of the page: a host recognises by it that the page was loaded anew. */
  readonly page: string;
  readonly abilities: Abilities;
}

/** The state of the run. */
export interface State {
  readonly phase: RunPhase;
  /** Simulated ms of the run. */
  readonly atMs: number;
  /** Names of the microcomputers, the first one's first, where there are several. */
  readonly devices?: readonly string[];
  /** Id of the board of the next run. */
  readonly board: string;
  /** How the program ended, or `null` before and while it runs. */
  readonly ended: EndedWord | null;
  readonly snapshot: PlainSnapshot | null;
  /** A moment of the past is looked at: time and snapshot are that moment's. Missing in pages up to 0.1.0. */
  readonly looking?: boolean;
  /** The mode of the arena. Missing in pages up to 1.0.0. */
  readonly mode?: ArenaMode;
  /** Values of sensors that hold for every run, by the sensor's id. */
  readonly sensors: Readonly<Record<string, number>>;
  readonly speed: Speed;
  readonly seed: number;
  readonly reality: number;
  readonly arenaSenses: boolean;
}

/** The exception that ended a program. */
export type PlainException = NonNullable<Ended['exception']>;

/** The robot's figures, as the command line reports them, and what it senses. */
export interface PlainRobot extends RobotReport {
  /** Duty of the motors, −1 … 1. */
  readonly motors: { readonly left: number; readonly right: number };
  /** Reading of the distance sensor, or `null`: nothing in range, or no such sensor. */
  readonly distanceMm: number | null;
  /** Depths of the lidar's 64 or 16 cells row by row from the upper left, in mm (`null`: nothing in range), or `null`: no lidar. */
  readonly lidarMm: readonly (number | null)[] | null;
  readonly lineSensors: readonly { readonly name: string; readonly bright: boolean; readonly reading?: number }[];
  /** The sight of its colour sensors. Missing without any, and in pages up to 1.0.0. */
  readonly colours?: readonly Pick<ColourSeen, 'side' | 'raw' | 'hue' | 'name'>[];
  /** The algorithm of its camera, and its last answer; `null`: the program has not asked within half a second. Missing without one, and in pages up to 1.0.0. */
  readonly camera?: Pick<NonNullable<RobotSnapshot['state']['camera']>, 'algorithm' | 'seen'>;
}

/** The sight of a colour sensor. */
type ColourSeen = NonNullable<RobotSnapshot['state']['colours']>[number];

/** Red, green, blue, 0 … 255 each. */
export type Colour = Rgb;

/** The run at one moment. */
export interface PlainSnapshot {
  /** Simulated ms. */
  readonly atMs: number;
  /** `program` until its end, then `world`. */
  readonly running: 'program' | 'world';
  readonly repl: boolean;
  readonly board: string;
  /** Digits 0 … 9 per LED, rows separated by colons. */
  readonly display: string;
  readonly buttons: { readonly a: boolean; readonly b: boolean };
  readonly touch: Readonly<Record<string, boolean>>;
  readonly sensors: Readonly<Record<string, number | string>>;
  readonly rgb: readonly Colour[];
  readonly motors: readonly number[];
  /** Frequency of the tone, or `null` for none. */
  readonly soundHz: number | null;
  readonly robot: PlainRobot | null;
  /** By the object's id. */
  readonly blocks: Readonly<Record<string, FloorPose>>;
  readonly movers: Readonly<Record<string, FloorPose>>;
  readonly verdict: Verdict | null;
  readonly lights: readonly { readonly pin: string; readonly colors: readonly Colour[] }[];
  /** The further microcomputers, where there are several; all else is the first one's. */
  readonly others?: readonly PlainDevice[];
}

/** A further microcomputer at one moment. */
export interface PlainDevice extends Omit<PlainSnapshot, 'atMs' | 'blocks' | 'movers' | 'verdict' | 'others'> {
  readonly name: string;
}

/** The place of a program, and its variables. */
export interface Position {
  /** Simulated ms of the device's clock. */
  readonly atMs: number;
  /** The file of the innermost of the program's own functions; `null`: none runs. */
  readonly file: string | null;
  readonly line: number | null;
  /** The program's own functions that run, innermost first. */
  readonly stack: readonly {
    /** `<module>` for a file, whose variables are the globals. */
    readonly function: string;
    readonly file: string;
    readonly line: number;
    readonly locals: Readonly<Record<string, Shown>>;
  }[];
  /** The names that the innermost function's file has made itself. */
  readonly globals: Readonly<Record<string, Shown>>;
}

/** A radio packet of the program: as text if `radio.send` made it, otherwise its bytes. */
export type PlainPacket = PacketReport;

/** An event of the board's data log. */
export type PlainLogEvent = { readonly atMs: number } & (
  | { readonly type: 'row'; readonly headings: readonly string[]; readonly values: readonly string[] }
  | { readonly type: 'clear' }
  | { readonly type: 'full' }
);

/** No fields, or an answer that contains only success. */
export type Nothing = object;

interface Command<Fields, Result> {
  readonly fields: Fields;
  readonly result: Result;
}

/** Every command: its fields, and the fields of its answer. */
export interface Commands {
  /** Begins. `session` is any text of the host's own: a second hello with it continues the same conversation. */
  hello: Command<
    { readonly session?: string; readonly client?: string; readonly versions?: readonly number[] },
    Welcome
  >;
  /** Ends the conversation; the page stays as it is. */
  bye: Command<Nothing, Nothing>;
  state: Command<Nothing, State>;
  subscribe: Command<{ readonly events?: readonly EventName[]; readonly snapshotHz?: number }, Nothing>;
  'get-project': Command<Nothing, { readonly project: ProjectFile }>;
  'set-project': Command<{ readonly project: ProjectFile | string }, Nothing>;
  'get-files': Command<OfDevice, { readonly files: readonly SourceFile[] }>;
  'set-files': Command<{ readonly files: readonly SourceFile[] } & OfDevice, Nothing>;
  'get-scene': Command<Nothing, { readonly scene: SceneFile }>;
  'set-scene': Command<{ readonly scene: SceneFile | string }, Nothing>;
  edit: Command<{ readonly edit: SceneEdit }, Nothing>;
  'get-robot': Command<Nothing, RobotChoice>;
  'set-robot': Command<Partial<RobotChoice>, Nothing>;
  'get-settings': Command<Nothing, PageSettings>;
  settings: Command<Partial<PageSettings> & { readonly labels?: Readonly<Record<string, string>> }, Nothing>;
  'set-mode': Command<{ readonly mode: ArenaMode }, Nothing>;
  run: Command<{ readonly paused?: boolean }, Nothing>;
  stop: Command<Nothing, Nothing>;
  reset: Command<Nothing, Nothing>;
  pause: Command<Nothing, Nothing>;
  resume: Command<Nothing, Nothing>;
  step: Command<Nothing, Nothing>;
  'get-break-points': Command<OfDevice, { readonly points: readonly BreakPoint[] }>;
  /** Replaces all break points of the device's program. */
  'set-break-points': Command<{ readonly points: readonly BreakPoint[] } & OfDevice, Nothing>;
  'get-position': Command<OfDevice, Position>;
  'step-line': Command<{ readonly step: Step | 'back' } & OfDevice, Nothing>;
  'run-to': Command<BreakPoint & OfDevice, Nothing>;
  'look-at': Command<{ readonly atMs: number }, Nothing>;
  'look-now': Command<Nothing, Nothing>;
  'go-on': Command<{ readonly paused?: boolean }, Nothing>;
  speed: Command<{ readonly speed: Speed }, Nothing>;
  seed: Command<{ readonly seed: number }, Nothing>;
  reality: Command<{ readonly reality: number }, Nothing>;
  place: Command<FloorPose & OfDevice, Nothing>;
  'place-block': Command<FloorPose & { readonly block: string }, Nothing>;
  press: Command<{ readonly button: 'a' | 'b'; readonly down: boolean } & OfDevice, Nothing>;
  touch: Command<{ readonly pad: string; readonly down: boolean } & OfDevice, Nothing>;
  sensor: Command<{ readonly sensor: string; readonly value: number | string } & OfDevice, Nothing>;
  'arena-senses': Command<{ readonly on: boolean }, Nothing>;
  serial: Command<{ readonly text: string } & OfDevice, Nothing>;
  interrupt: Command<OfDevice, Nothing>;
  /** Without a name it reaches all microcomputers. */
  radio: Command<({ readonly text: string } | { readonly bytes: readonly number[] }) & OfDevice, Nothing>;
  'clear-console': Command<Nothing, Nothing>;
}

/** Name of a command. */
export type CommandName = keyof Commands;

/** A command as it is sent. */
export type CommandMessage<N extends CommandName = CommandName> = {
  [K in N]: Envelope & { readonly id?: CommandId; readonly type: K } & Commands[K]['fields'];
}[N];

/** Every event with its fields. */
export interface Events {
  phase: { readonly phase: RunPhase };
  started: Nothing;
  /** The program starts again within its run (Ctrl-D at the REPL). */
  'program-restarted': OfDevice;
  ended: OfDevice & {
    readonly ended: EndedWord;
    readonly exception: PlainException | null;
    /** Simulated ms. */
    readonly atMs: number;
    readonly robot: PlainRobot | null;
    readonly display: string;
    /** How well the course's task has been done so far, or `null` if the course has no task. */
    readonly verdict: Verdict | null;
  };
  /** Output of the program and the REPL; `omitted`: characters before it that came too fast and are left out. */
  output: OfDevice & { readonly text: string; readonly omitted?: number };
  snapshot: { readonly snapshot: PlainSnapshot };
  held: OfDevice & BreakPoint & { readonly atMs: number };
  looking: { readonly atMs: number | null };
  'break-points-changed': OfDevice & { readonly points: readonly BreakPoint[] };
  'scene-changed': { readonly name: string; readonly objects: number };
  'files-changed': OfDevice & { readonly names: readonly string[] };
  'settings-changed': {
    readonly settings: PageSettings & RobotChoice & Pick<State, 'speed' | 'seed' | 'reality' | 'arenaSenses'>;
  };
  sensed: OfDevice & { readonly sensor: string; readonly value: number | string };
  /** `omitted`: number of packets before these that came too fast and are left out. */
  radio: OfDevice & { readonly packets: readonly PlainPacket[]; readonly omitted?: number };
  /** `omitted`: number of rows. Events that the log was emptied or is full are never left out. */
  log: OfDevice & { readonly events: readonly PlainLogEvent[]; readonly omitted?: number };
  /** An input that the run refused. */
  refused: { readonly message: string };
  /** The run could not start or failed inside. */
  failed: { readonly message: string };
}

/** Name of an event. */
export type EventName = keyof Events;

/** An event as it is sent. */
export type EventMessage<N extends EventName = EventName> = {
  [K in N]: Envelope & { readonly type: K } & Events[K];
}[N];

/** Why a command was not carried out. */
export type RefusalCode =
  /** The page does not speak the version in `parcours`; the answer lists `versions`. */
  | 'unknown-version'
  /** The page does not know this host: `hello` comes first, also after the page was loaded anew. */
  | 'no-hello'
  | 'unknown-command'
  /** A field is missing, of the wrong type or out of its range: `path` names it. */
  | 'wrong-message'
  /** The message is larger than the command allows. */
  | 'too-large'
  /** A project, a course or an edit is not valid: `path` is the place in it. */
  | 'wrong-document'
  /** The page cannot do it now, or there is no such thing: the message says which. */
  | 'refused'
  /** Too many commands are waiting. */
  | 'busy'
  /** The app failed: please report it. */
  | 'broken';

/** The answer to a command that was carried out. */
export type DoneMessage<N extends CommandName = CommandName> = Envelope & {
  readonly reply: CommandId;
  readonly ok: true;
} & Commands[N]['result'];

/** The answer to a command that was not carried out; it has changed nothing. */
export interface RefusedMessage extends Envelope {
  readonly reply: CommandId;
  readonly ok: false;
  readonly code: RefusalCode;
  /** One English sentence. */
  readonly message: string;
  /** Place in the message, such as `project.scene.objects[2].at`; empty: the message as a whole. */
  readonly path: string;
  /** With `unknown-version`: the known versions. */
  readonly versions?: readonly number[];
}

/** All messages of the page in this dialect. */
export type FromPage = EventMessage | DoneMessage | RefusedMessage;
