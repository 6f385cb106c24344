/** The pupil's works as the page lists them: each once, with all its programs. */
import type { Course } from '#catalogue/course';
import { missionRobots, type MissionRobot } from '#catalogue/mission-place';
import { ladderOf } from '#catalogue/missions';
import { isSame } from '#core/same';
import type { Project } from '#project/project';
import type { Scene } from '#scene/scene';

import { shownLanguage } from '../../kit/i18n';
import { readyCourse, readyCourses } from '../../session/work/catalogue/ready-courses';
import { isSameArena } from '../../session/work/catalogue/same-arena';
import type { WorkModel } from '../../session/work/model/work-model';
import { filesByDevice, programsOf, type OwnProgram } from '../../session/work/programs/own-programs';
import type { Previous } from '../../session/work/storage/history';
import { packedText } from '../../session/work/storage/stored-project';
import { hasNothingOwn } from '../../session/work/use-courses';
import { workName } from '../../session/work/work-name';

/** One of the pupil's programs for a work: open now, won most, left last, or among the earlier works. */
export type Version = OwnProgram & {
  readonly kind: 'open' | 'best' | 'last' | 'earlier';
  /** The earlier work that it belongs to; without one, only the programs are stored. */
  readonly entry?: Previous;
};

/** A work of the pupil. */
export interface WorkOfPupil {
  /** In the address of the page. */
  readonly id: string;
  readonly kind: 'mission' | 'class' | 'own';
  readonly name: string;
  readonly scene: Scene;
  /** The ready course that it is about; `null`: none. */
  readonly course: Course | null;
  /** The open one before all others, then the best, the last, and earlier ones from the newest on. */
  readonly versions: readonly Version[];
}

/** The missions of a robot, whether the pupil has begun with them or not. */
export interface Ladder {
  readonly robot: MissionRobot;
  readonly works: readonly WorkOfPupil[];
}

/** All works: the ladders that were begun or belong to the robot in use, and everything else, newest first. */
export interface Works {
  readonly ladders: readonly Ladder[];
  readonly others: readonly WorkOfPupil[];
}

/** Time of what is open: later than all that was left. */
export const OPEN_MS = Infinity;

type Kept = Pick<WorkModel, 'programs' | 'work'>;

/** The pupil's works. @param robot the ladder of this robot is there in any case */
export function worksOf(work: Kept, robot: string): Works {
  const entries = [...openEntry(work), ...work.work.value.previous];
  const ladders = missionRobots
    .map((one): Ladder => ({ robot: one, works: ladderOf(one).map((mission) => ofCourse(work, mission, entries)) }))
    .filter((ladder) => ladder.robot === robot || ladder.works.some(isBegun));
  const courses = readyCourses.filter(({ mission }) => mission === undefined);
  const others = [...courses.map((course) => ofCourse(work, course, entries)).filter(isBegun), ...groups(entries)];
  return { ladders, others: others.sort((one, other) => newestOf(other) - newestOf(one)) };
}

const isBegun = ({ versions }: WorkOfPupil): boolean => versions.length > 0;

/** The version that a work is opened with: the newest. */
export const lastOf = ({ versions }: WorkOfPupil): Version | null =>
  versions.reduce<Version | null>((last, one) => (last === null || one.atMs > last.atMs ? one : last), null);

/** Time of the newest version, in ms since 1970; 0: there is none. */
export const newestOf = (work: WorkOfPupil): number => lastOf(work)?.atMs ?? 0;

/** The room that its earlier works take, in characters. */
export const charactersOf = ({ versions }: WorkOfPupil): number =>
  versions.reduce((sum, { entry }) => sum + (entry === undefined ? 0 : packedText(entry.project).length), 0);

/** True if a tab that was closed has left it. */
export const isOfTab = ({ versions }: WorkOfPupil): boolean => versions.some(({ entry }) => entry?.isOfTab === true);

/** True if its name or one of its programs has these words, in whatever case. */
export function isFound({ name, versions }: WorkOfPupil, words: string): boolean {
  const text = words.trim().toLowerCase();
  const texts = versions.flatMap(({ files }) => files.flat().map((file) => file.text));
  return [name, ...texts].some((one) => one.toLowerCase().includes(text));
}

/** The open work as it will be among the earlier ones; none where nobody has written anything. */
function openEntry(work: Kept): readonly Previous[] {
  const { project, file } = work.work.value;
  if (hasNothingOwn(project)) return [];
  return [{ name: workName({ work }), atMs: OPEN_MS, project, ...(file !== undefined && { file }) }];
}

/** Everything that the pupil has of a ready course. */
function ofCourse(work: Kept, course: Course, entries: readonly Previous[]): WorkOfPupil {
  const { best, last } = programsOf(work, course.id);
  const mine = entries.filter(({ project }) => courseOf(project) === course.id).map(versionOf);
  const isOpen = ({ kind }: Version): boolean => kind === 'open';
  const all: readonly Version[] = [
    ...mine.filter(isOpen),
    ...(best === undefined ? [] : [{ ...best, kind: 'best' } as const]),
    ...(last === undefined ? [] : [{ ...last, kind: 'last' } as const]),
    ...mine.filter((version) => !isOpen(version)),
  ];
  const name = course.texts[shownLanguage()].name;
  const kind = course.mission === undefined ? 'own' : 'mission';
  return { id: course.id, kind, name, scene: course.scene, course, versions: eachOnce(all, course) };
}

/** Versions that differ in their programs, or have an arena of their own. */
function eachOnce(all: readonly Version[], { scene }: Course): readonly Version[] {
  const once: Version[] = [];
  for (const version of all) {
    const isOther = version.entry !== undefined && !isSameArena(version.entry.project.scene, scene);
    const place = isOther ? -1 : once.findIndex(({ files }) => isSame(files, version.files));
    const known = once[place];
    if (known === undefined) once.push(version);
    else once[place] = { ...version, ...known };
  }
  return once;
}

/** The works of no ready course: those of a task together, every other one by itself. */
function groups(entries: readonly Previous[]): readonly WorkOfPupil[] {
  const byId = new Map<string, Previous[]>();
  for (const entry of entries) {
    if (courseOf(entry.project) !== null) continue;
    const { task } = entry.project;
    const id = typeof task?.['id'] === 'string' ? `task-${encodeURIComponent(task['id'])}` : idOf(entry);
    byId.set(id, [...(byId.get(id) ?? []), entry]);
  }
  return [...byId].flatMap(([id, [first, ...more]]) => (first === undefined ? [] : [ofEntries(id, first, more)]));
}

function ofEntries(id: string, first: Previous, more: readonly Previous[]): WorkOfPupil {
  const { name, project } = first;
  const kind = project.task === undefined ? 'own' : 'class';
  return { id, kind, name, scene: project.scene, course: null, versions: [first, ...more].map(versionOf) };
}

const versionOf = (entry: Previous): Version => ({
  kind: entry.atMs === OPEN_MS ? 'open' : 'earlier',
  atMs: entry.atMs,
  files: filesByDevice(entry.project),
  entry,
});

/** The name of earlier work in the address of the page. */
export const idOf = ({ atMs }: Previous): string => (atMs === OPEN_MS ? 'open' : `work-${String(atMs)}`);

/** The ready course that a project is about; `null`: none, or a task that a teacher has set. */
const courseOf = ({ course, task }: Project): string | null =>
  course !== null && task === undefined && readyCourse(course) !== null ? course : null;
