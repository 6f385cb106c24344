import type { MyRobot } from '#my-robot/my-robot';
import type { Scene } from '#scene/scene';

/** A file of the pupil. */
export interface SourceFile {
  readonly name: string;
  readonly text: string;
}

/** A pupil's work: files, a course and their settings. Immutable; every change makes a new one. */
export interface Project {
  /** main.py first, the others in the order of their tabs. */
  readonly files: readonly SourceFile[];
  readonly scene: Scene;
  /** Id of the ready course it started from, or `null`. */
  readonly course: string | null;
  /** The settings of its run; left out: those chosen by the person who opens it. */
  readonly settings?: ProjectSettings;
  /** Its microcomputers; left out: there is one. */
  readonly devices?: ProjectDevices;
  /** The teacher's additions that make it a task for a class (`#check/task`); left out: none. */
  readonly task?: Carried;
  /** The pupil's additions to the program in a hand-in (`#check/hand-in`); left out: none. */
  readonly handIn?: Carried;
}

/**
 * Plain JSON that a project carries along. The room that it belongs to reads and checks it when it is needed; here it is only
 * held within limits (`read-carried.ts`).
 */
export type Carried = Readonly<Record<string, unknown>>;

/** The hardware that a program is meant for. */
export interface HardwareWish {
  /** Id of the microcomputer, or `auto`. */
  readonly device: string;
  /** Id of its firmware; empty: the board's usual one. */
  readonly firmware: string;
  /** Id of a robot type, `none` for the bare board, or `auto`. */
  readonly robot: string;
  /** Changed options of robots: id of the robot → id of the option → id of the choice. */
  readonly robotOptions: Readonly<Record<string, Readonly<Record<string, string>>>>;
}

/** A microcomputer of a project after the first one. */
export interface FurtherDevice extends HardwareWish {
  /** Unlike the others of the project. */
  readonly name: string;
  /** Its own files, main.py first; none if it runs those of another device. */
  readonly files: readonly SourceFile[];
  /** Name of the device with files of its own whose files it runs; empty: its own. */
  readonly sameAs: string;
}

/** The microcomputers of a project that has several. */
export interface ProjectDevices {
  /** Name of the first device, whose files and hardware are those of the project. */
  readonly first: string;
  readonly others: readonly FurtherDevice[];
}

/**
 * The settings that travel with a project, because a run depends on them; the hardware is that of the first device.
 * Language, theme and panes stay with the person.
 */
export interface ProjectSettings extends HardwareWish {
  /** How much the robot resembles a used one, 0 (ideal) … 1. */
  readonly reality: number;
  /** Which of the used robots it is, 1 … 9999. */
  readonly seed: number;
  /** True if the board on the robot measures the arena. */
  readonly arenaSenses: boolean;
  /** The pupil's own robot, as it was measured. */
  readonly myRobot?: MyRobot;
}

/** The hardware that the program's imports suggest. */
export const anyHardware: HardwareWish = { device: 'auto', firmware: '', robot: 'auto', robotOptions: {} };

/** Settings of a project that has none. */
export const defaultProjectSettings: ProjectSettings = {
  ...anyHardware,
  reality: 0,
  seed: 1,
  arenaSenses: false,
};

/**
 * The settings of new work: a ready course, an example, a program alone, the first one. What was made before keeps its
 * own, and a project without any the ones above.
 */
export const newWork = { arenaSenses: true } as const;

/** The program's file: always there, never renamed. */
export const MAIN = 'main.py';

/** Longest file name of the board's file system. */
export const NAME_CHARACTERS = 120;

/** Largest file that can be loaded, in bytes: far more than the board's file system holds, so that the device's own error shows. */
export const FILE_BYTES = 256 * 1024;

/** Maximum content of a project, besides its scene. Chosen: far beyond any lesson. */
export const projectLimits = {
  /** Maximum length of the whole file. */
  textCharacters: 12_000_000,
  files: 20,
  idCharacters: 100,
  /** Robots with changed options, and options of one robot. */
  options: 50,
  reality: { min: 0, max: 1 },
  seed: { min: 1, max: 9999 },
  /** A task or a hand-in as JSON. Chosen: some hidden worlds, each with thousands of inputs. */
  carriedCharacters: 2_000_000,
  carriedLevels: 30,
} as const;

/** The fault of a name for a file, or `null`. `own` is the file's present name. */
export function nameProblem(
  name: string,
  files: readonly SourceFile[],
  own?: string,
): 'nameEmpty' | 'nameTaken' | 'nameCharacters' | 'nameLong' | null {
  if (name === '') return 'nameEmpty';
  if (name.length > NAME_CHARACTERS) return 'nameLong';
  if (!/^[\p{L}\p{N}_][\p{L}\p{N}_.-]*$/u.test(name)) return 'nameCharacters';
  if (name !== own && files.some((file) => file.name === name)) return 'nameTaken';
  return null;
}

/** The intended name: without spaces around it, ending in `.py` if it has no ending. */
export function completeName(typed: string): string {
  const name = typed.trim();
  return name === '' || name.includes('.') ? name : `${name}.py`;
}

/** A name like `name`, with a number, that no file has yet: for `drive.py` it is `drive2.py`, `drive3.py`, … */
export function freeName(name: string, files: readonly SourceFile[]): string {
  const [, stem = name, ending = ''] = /^(.*?)(\.[^.]*)?$/.exec(name) ?? [];
  for (let number = 2; ; number += 1) {
    const candidate = `${stem}${String(number)}${ending}`;
    if (!files.some((file) => file.name === candidate)) return candidate;
  }
}

/** The files as a run takes them: name → text. */
export function filesByName(files: readonly SourceFile[]): Readonly<Record<string, string>> {
  return Object.fromEntries(files.map((file) => [file.name, file.text]));
}

/** Number of bytes of a text in UTF-8; half a surrogate pair counts as the three bytes of its replacement. */
export function utf8Bytes(text: string): number {
  let bytes = text.length;
  for (let index = 0; index < text.length; index += 1) {
    const unit = text.charCodeAt(index);
    if (unit < 0x80) continue;
    const isPair = unit >= 0xd800 && unit < 0xdc00 && (text.charCodeAt(index + 1) & 0xfc00) === 0xdc00;
    bytes += unit < 0x800 ? 1 : 2; // a pair has two units and four bytes
    if (isPair) index += 1;
  }
  return bytes;
}
