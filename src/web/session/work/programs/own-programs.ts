/**
 * The pupil's own programs of the ready courses, stored in the browser beside the stars: the last one, and the one that
 * has won most. A course's arena is not stored, it comes with the page.
 */
import { MAIN, type Project, type SourceFile } from '#project/project';
import { isRecord } from '#core/record';
import type { RunSetup } from '#simulation/run-setup';

import { notesOn } from '#core/memo';
import type { WorkModel } from '../model/work-model';

/** A program of a course, with those of its further devices. */
export interface OwnProgram {
  /** Time when it was left or has won, in ms since 1970. */
  readonly atMs: number;
  /** The files of each device, in their order. */
  readonly files: readonly (readonly SourceFile[])[];
  /** Its stars: 1 to 3; left out: it is stored because it was the last one. */
  readonly stars?: number;
  /** In this simulated time, ms. */
  readonly timeMs?: number;
}

/** The stored programs of a course. */
export interface OwnPrograms {
  readonly last?: OwnProgram;
  readonly best?: OwnProgram;
}

/** Before the id of the course, in the name of an entry. */
const KEY = 'parcours.program.';

type Kept = Pick<WorkModel, 'programs'>;

/** The pupil's programs of a course, as far as there are any and they can be read. */
export function programsOf({ programs }: Kept, course: string): OwnPrograms {
  try {
    const read: unknown = JSON.parse(programs?.getItem(KEY + course) ?? '{}');
    if (!isRecord(read)) return {};
    const { last, best } = read;
    return { ...(isOwn(last) && { last }), ...(isOwn(best) && { best }) };
  } catch {
    return {};
  }
}

/** Stores the open program as the last one of its course, unless it is as it came, or belongs to a teacher's task. */
export function leaveProgram(work: Kept & Pick<WorkModel, 'work'>, atMs: number): void {
  const { project } = work.work.value;
  if (project.course === null || project.task !== undefined || isAsOpened(project)) return;
  keepLast(work, project.course, { atMs, files: filesByDevice(project) });
}

/** Stores a program as the last one of a course, unless a later one is stored. */
export function keepLast(work: Kept, course: string, last: OwnProgram): void {
  const kept = programsOf(work, course);
  if ((kept.last?.atMs ?? 0) <= last.atMs) write(work, course, { ...kept, last });
}

/**
 * Stores a program that has won, unless one before has won more, or as much in no more time.
 *
 * @returns `false`: the browser has no room left
 */
export function keepBest(work: Kept, course: string, best: Required<OwnProgram>): boolean {
  const kept = programsOf(work, course);
  const { stars = 0, timeMs = Infinity } = kept.best ?? {};
  const isBetter = best.stars > stars || (best.stars === stars && best.timeMs < timeMs);
  return !isBetter || write(work, course, { ...kept, best });
}

/** The files of a run, as a program of its course. */
export const filesOfRun = ({ devices }: Pick<RunSetup, 'devices'>): OwnProgram['files'] =>
  devices.map(({ files }) => {
    const names = [MAIN, ...Object.keys(files).filter((name) => name !== MAIN)];
    return names.map((name) => ({ name, text: files[name] ?? '' }));
  });

/** A course as something to work on, with another program for it; `null`: it has not as many devices. */
export function withProgram(project: Project, { files: [first, ...others] }: OwnProgram): Project | null {
  const { devices } = project;
  if (first === undefined || others.length !== (devices?.others.length ?? 0)) return null;
  if (devices === undefined) return { ...project, files: first };
  const further = devices.others.map((device, place) => {
    const own = others[place] ?? []; // none where it ran the program of another device
    return own.length === 0 ? device : { ...device, files: own };
  });
  return { ...project, files: first, devices: { ...devices, others: further } };
}

/** The files of each device of a project, in their order. */
export const filesByDevice = ({ files, devices }: Project): OwnProgram['files'] => [
  files,
  ...(devices?.others.map((device) => device.files) ?? []),
];

/** Programs as they came with a course or its solution, by the list of the first device's files. */
const opened = notesOn<Project['files'], Project['devices']>();
/** Notes that a project was opened as it comes with its course. */
export const noteOpened = ({ files, devices }: Project): void => void opened.set(files, devices);
/** True if nobody has written on a project since it was opened as it came. */
export const isAsOpened = ({ files, devices }: Project): boolean => opened.has(files) && opened.get(files) === devices;

function write({ programs }: Kept, course: string, kept: OwnPrograms): boolean {
  try {
    programs?.setItem(KEY + course, JSON.stringify(kept));
    return true;
  } catch {
    return false;
  }
}

const isOwn = (value: unknown): value is OwnProgram =>
  isRecord(value) &&
  typeof value['atMs'] === 'number' &&
  Array.isArray(value['files']) &&
  value['files'].every((files) => Array.isArray(files) && files.every(isFile)) &&
  isFile((value['files'] as unknown[][])[0]?.[0]);

const isFile = (value: unknown): boolean =>
  isRecord(value) && typeof value['name'] === 'string' && typeof value['text'] === 'string';
