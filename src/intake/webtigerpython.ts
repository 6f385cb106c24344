import { boardOf } from '#board/boards/board-of-device';
import { rewriteRepeat } from '#advice/repeat';
import { modulesImportedBy } from '#python/imports';
import { defaultProjectSettings, filesByName, type SourceFile } from '#project/project';
import { namesTogether, note } from '#project/webtigerpython/note';
import { programOfLink, type ProgramLinkProblem } from '#project/webtigerpython/program-link';
import { readWorld, withStartInside, type World } from '#project/webtigerpython/read-world';
import type { Linked } from '#project/webtigerpython/write-link';
import { defaultScene } from '#scene/scene';
import { AUTO, chooseHardware, type Hardware } from '#simulation/hardware';
import type { CourseDocument, ProgramDocument, RewrittenLine } from './document';

/**
 * The program of a link of WebTigerPython with its world, or its world alone. TigerJython's loops are written in Python,
 * and a start over the arena's edge is moved in; both is told.
 *
 * @param course id of the ready course that the address also names
 */
export function documentOfProgramLink(
  address: string,
  course: string | null,
): ProgramDocument | CourseDocument | { readonly problem: ProgramLinkProblem } {
  const read = programOfLink(address);
  if ('problem' in read) return read;
  const { device } = read;
  const { files, rewritten } = withoutRepeats(read.files);
  const world = read.world === null ? null : placed(read.world, files, device);
  const ofProgram = rewritten.length === 0 ? [] : [note('repeat', { lines: namesTogether(rewritten.map(placeOf)) })];
  const notes = [...ofProgram, ...(world?.notes ?? []), ...read.notes];
  if (files.length === 0 && world !== null)
    return { kind: 'course', scene: world.scene, device, isFromWebTigerPython: true, notes, mapNotes: [] };
  return { kind: 'program', files, device, course, scene: world?.scene ?? null, notes, rewritten };
}

/** The course in a world's file; `null`: the value is no such world. */
export function documentOfWorld(value: unknown): CourseDocument | null {
  const read = readWorld(value);
  return read && { kind: 'course', device: null, isFromWebTigerPython: true, ...placed(read, [], null), mapNotes: [] };
}

/** The files with Python's loops, and the lines that have changed. */
function withoutRepeats(files: readonly SourceFile[]): Pick<ProgramDocument, 'files' | 'rewritten'> {
  const read = files.map(({ name, text }) => ({
    name,
    ...(name.endsWith('.py') ? rewriteRepeat(text) : { text, lines: [] }),
  }));
  return {
    files: read.map(({ name, text }) => ({ name, text })),
    rewritten: read.flatMap(({ name, lines }) => lines.map((line) => ({ file: name, ...line }))),
  };
}

const placeOf = ({ file, line }: RewrittenLine): string =>
  file === 'main.py' ? String(line) : `${file}:${String(line)}`;

/** A world in which the robot that its program means does not lie over the edge. */
function placed({ scene, notes }: World, files: readonly SourceFile[], device: string | null): World {
  const hardware = hardwareOf({ files, scene, settings: { ...defaultProjectSettings, device: device ?? AUTO } });
  const robot = 'problem' in hardware ? null : hardware.robot;
  const inside = withStartInside(scene, robot?.body.outlineMm ?? []);
  return { scene: inside.scene, notes: [...notes, ...inside.notes] };
}

/** The hardware that a run of a project's first device chooses. */
export function hardwareOf({
  files,
  scene,
  settings = defaultProjectSettings,
}: Pick<Linked, 'files' | 'scene' | 'settings'>): Hardware | { readonly problem: string } {
  const { device, firmware, robot } = settings;
  const imports = modulesImportedBy(filesByName(files));
  return chooseHardware({ scene: scene ?? defaultScene(), imports, robot, board: boardOf(device), firmware });
}
