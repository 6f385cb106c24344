import { parseSceneValue } from '#scene/parse';
import type { Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

/** A file of the pupil. */
export interface SourceFile {
  readonly name: string;
  readonly text: string;
}

/** What a pupil works on: files and a course. Immutable; every change makes a new one. */
export interface Project {
  /** main.py first, the others in the order of their tabs. */
  readonly files: readonly SourceFile[];
  readonly scene: Scene;
  /** Id of the ready course it started from, or `null`. */
  readonly course: string | null;
}

/** The program's file: always there, never renamed. */
export const MAIN = 'main.py';

/** Longest file name of the board's file system. */
export const NAME_CHARACTERS = 120;

/** Largest file that can be loaded, in bytes: far more than the board's file system holds, so that the device's own error shows. */
export const FILE_BYTES = 256 * 1024;

/** What is wrong with a name for a file, or `null`. `own` is the name the file has now. */
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

/** A name as meant: without spaces around it, ending in `.py` where no ending is given. */
export function completeName(typed: string): string {
  const name = typed.trim();
  return name === '' || name.includes('.') ? name : `${name}.py`;
}

/** A name like `name` that no file has yet: `drive.py`, `drive2.py`, `drive3.py`, … */
export function freeName(name: string, files: readonly SourceFile[]): string {
  const [, stem = name, ending = ''] = /^(.*?)(\.[^.]*)?$/.exec(name) ?? [];
  for (let number = 2; ; number += 1) {
    const candidate = `${stem}${number}${ending}`;
    if (!files.some((file) => file.name === candidate)) return candidate;
  }
}

/** The files as a run takes them. */
export function filesByName(files: readonly SourceFile[]): Readonly<Record<string, string>> {
  return Object.fromEntries(files.map((file) => [file.name, file.text]));
}

/** A project as plain data for the browser's storage. */
export function packProject(project: Project): unknown {
  return { files: project.files, scene: JSON.parse(serializeScene(project.scene)) as unknown, course: project.course };
}

/** Reads what `packProject` made; `null` for anything else. */
export function unpackProject(value: unknown): Project | null {
  if (typeof value !== 'object' || value === null) return null;
  const { files, scene, course } = value as { files?: unknown; scene?: unknown; course?: unknown };
  if (!Array.isArray(files)) return null;
  const read = files.map(readFile);
  const parsed = parseSceneValue(scene);
  if (!('scene' in parsed) || read[0]?.name !== MAIN || read.includes(null)) return null;
  return {
    files: read.filter((file) => file !== null),
    scene: parsed.scene,
    course: typeof course === 'string' ? course : null,
  };
}

function readFile(value: unknown): SourceFile | null {
  if (typeof value !== 'object' || value === null) return null;
  const { name, text } = value as { name?: unknown; text?: unknown };
  return typeof name === 'string' && typeof text === 'string' ? { name, text } : null;
}
