import { isRecord } from '#core/record';
import { parseEdit } from '#scene/check-edit';
import type { SceneEdit } from '#scene/edit';
import { summaryOf } from '#scene/json-file';
import { Reader, type Fields } from '#scene/reader';
import { sceneLimits } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import { hasTask } from '#simulation/task/task-brief';
import { SPEEDS } from '#simulation/pace';
import { readInputs } from '#tape/read-setup';
import type { ProjectProblem } from '#project/problem';
import type { Carried, Project, SourceFile } from '#project/project';
import { readFiles } from '#project/read-files';
import { lostIn, lostProblem } from './named-objects';
import { readAbout } from './about';
import { readExam, type Exam } from './exam';
import { levelLimits } from './chosen-level';
import { readLevels, type TaskLevel } from './levels';
import { readMostHint } from './most-hint';
import { readChecks } from './read-checks';
import {
  lockNames,
  noLocks,
  plainWorld,
  taskLimits,
  type Check,
  type ClassTask,
  type Locks,
  type WorldVariant,
} from './task';

/**
 * The newest version of a task's own data that this app reads. Version 2 has more kinds of checks, levels, exams and details for
 * teachers; what an older app knows is written as version 1.
 */
export const TASK_VERSION = 2;

/** A task, or everything that is wrong with it; `problem` is the first one's message and how many follow. */
export type ReadTask =
  { readonly task: ClassTask } | { readonly problem: string; readonly problems: readonly ProjectProblem[] };

/** The check of a project without data of a task: the goals of its course. */
const courseGoals: Check = { type: 'goals', id: 'goals', points: 1, needed: true };

/** The data of a task of a project that has none. */
const NOTHING: Carried = { version: TASK_VERSION };

/**
 * The task of a project. One without data of a task is checked for the goals of its course, in that course alone. Never
 * throws.
 */
export function taskOf(project: Project): ReadTask {
  const read = draftOf(project);
  if (!('task' in read)) return read;
  if (lacksGoals(read.task)) return refused('checks', NO_GOALS);
  const [lost] = lostIn(read.task);
  return lost === undefined ? read : refused(lost.path, lostProblem(lost));
}

/** The task of a project that was read before, on the other side of a thread. Throws if it has none. */
export function taskReadBefore(project: Project): ClassTask {
  const read = taskOf(project);
  if ('problem' in read) throw new Error(read.problem);
  return read.task;
}

/** True if the goals of the course are required but it has none. */
export const lacksGoals = ({ checks, project }: ClassTask): boolean =>
  checks.some(({ type }) => type === 'goals') && !hasTask(project.scene);

/** The task of a project while it is being made: its course may still lack goals. */
export function draftOf(project: Project): ReadTask {
  const { task: data = NOTHING, handIn: _, ...plain } = project;
  const { version } = data;
  if (version !== 1 && version !== TASK_VERSION) return refused('version', versionProblem(version));
  const reader = new Reader();
  const fields = reader.fields(data, 'task', [
    ...['version', 'handedOut', 'course', 'id', 'checks', 'worlds', 'least', 'seconds', 'stars', 'solution', 'locks'],
    ...['about', 'levels', 'level', 'exam', 'hint'],
  ]);
  const exam = readExam(fields['exam'], reader);
  const hint = readMostHint(fields['hint'], reader);
  const levels = readLevels(fields['levels'], reader, linesIn);
  if (fields['level'] !== undefined)
    reader.whole(fields['level'], 'task.level', { min: 0, max: levelLimits.levels.max - 1 });
  const about = readAbout(fields['about'], 'task.about', reader);
  const solution = solutionIn(fields, reader);
  const worlds = worldsIn(fields['worlds'], reader);
  const hiddenCount = worlds.filter(({ hidden }) => hidden).length;
  reader.flag(fields['handedOut'], 'task.handedOut', false);
  reader.text(fields['course'], 'task.course', taskLimits.idCharacters, '');
  const task: ClassTask = {
    project: plain,
    id: reader.text(fields['id'], 'task.id', taskLimits.idCharacters, ''),
    checks: fields['checks'] === undefined ? [courseGoals] : readChecks(fields['checks'], reader),
    worlds,
    least:
      fields['least'] === undefined ? null : reader.whole(fields['least'], 'task.least', { min: 0, max: hiddenCount }),
    seconds:
      fields['seconds'] === undefined ? null : reader.number(fields['seconds'], 'task.seconds', taskLimits.seconds),
    stars: fields['stars'] === undefined ? null : starsIn(fields['stars'], reader),
    solution: solution.files,
    locks: locksIn(fields['locks'], reader),
    ...(about !== undefined && { about }),
    ...(levels !== undefined && { levels }),
    ...(exam !== undefined && { exam }),
    ...(hint !== undefined && { hint }),
  };
  const problems: readonly ProjectProblem[] = [...reader.problems, ...solution.problems];
  return problems.length > 0 ? { problem: summaryOf(problems), problems } : { task };
}

const NO_GOALS =
  'task: the course has no goals, so there is nothing to check. Give it a target, or the task other checks.';

function versionProblem(version: unknown): string {
  const isNewer = typeof version === 'number' && version > TASK_VERSION;
  return isNewer
    ? `task: version ${String(version)} is newer than this app (${String(TASK_VERSION)}). Update Parcours.`
    : `task: "version" must be a whole number from 1 to ${String(TASK_VERSION)}.`;
}

function refused(path: string, message: string): ReadTask {
  const problem: ProjectProblem = { code: 'wrong-type', path: `task.${path}`, value: '', params: {}, message };
  return { problem: message, problems: [problem] };
}

const visibleFirst = (worlds: readonly WorldVariant[]): ClassTask['worlds'] => {
  const [first = plainWorld, ...others] = worlds.filter(({ hidden }) => !hidden);
  return [first, ...others, ...worlds.filter(({ hidden }) => hidden)];
};

/** The worlds, the visible ones first; without a visible one, the course as it is comes first. */
function worldsIn(value: unknown, reader: Reader): ClassTask['worlds'] {
  if (value === undefined) return [plainWorld];
  const list = reader.list(value, 'task.worlds', { min: 0, max: taskLimits.worlds });
  const worlds = list.map((world, index) => worldIn(world, `task.worlds[${String(index)}]`, reader));
  const all = worlds.some(({ hidden }) => !hidden) ? visibleFirst(worlds) : ([plainWorld, ...worlds] as const);
  for (const [index, { id }] of worlds.entries()) {
    if (all.findIndex((other) => other.id === id) === all.findIndex((other) => other === worlds[index])) continue;
    const path = `task.worlds[${String(index)}].id`;
    reader.report('duplicate-id', path, id, `another world has the id ${JSON.stringify(id)}.`);
  }
  return all;
}

function worldIn(value: unknown, path: string, reader: Reader): WorldVariant {
  const fields = reader.fields(value, path, [
    ...['id', 'hidden', 'start', 'seed', 'reality', 'edits', 'sensors', 'inputs'],
  ]);
  const { start, seed, reality } = fields;
  return {
    id: idIn(fields['id'], `${path}.id`, reader),
    hidden: reader.flag(fields['hidden'], `${path}.hidden`, true),
    start: start === undefined ? null : startIn(start, `${path}.start`, reader),
    seed: seed === undefined ? null : reader.whole(seed, `${path}.seed`, taskLimits.seed),
    reality: reality === undefined ? null : reader.number(reality, `${path}.reality`, { min: 0, max: 1 }),
    edits: editsIn(fields['edits'], `${path}.edits`, reader),
    sensors: sensorsIn(fields['sensors'], `${path}.sensors`, reader),
    inputs: inputsIn(fields['inputs'], `${path}.inputs`, reader),
  };
}

/** An id: a text that is not empty. */
export function idIn(value: unknown, path: string, reader: Reader): string {
  const id = reader.text(value, path, taskLimits.idCharacters);
  if (id === '' && typeof value === 'string') reader.report('missing', path, value, 'must not be empty.');
  return id;
}

function startIn(value: unknown, path: string, reader: Reader): WorldVariant['start'] {
  const fields = reader.fields(value, path, ['at', 'heading']);
  return {
    at: reader.point(fields['at'], `${path}.at`, sceneLimits.placeMm),
    heading: reader.number(fields['heading'], `${path}.heading`, sceneLimits.headingDeg, 0),
  };
}

function editsIn(value: unknown, path: string, reader: Reader): readonly SceneEdit[] {
  if (value === undefined) return [];
  const edits: SceneEdit[] = [];
  for (const [index, entry] of reader.list(value, path, { min: 0, max: taskLimits.edits }).entries()) {
    const parsed = parseEdit(entry);
    if ('edit' in parsed) edits.push(parsed.edit);
    else reader.report('damaged', `${path}[${String(index)}]`, undefined, parsed.problem);
  }
  return edits;
}

function sensorsIn(value: unknown, path: string, reader: Reader): WorldVariant['sensors'] {
  if (value === undefined) return {};
  if (!isRecord(value)) {
    reader.wrongType(value, path, 'an object { … }');
    return {};
  }
  const entries = Object.entries(value);
  if (entries.length > taskLimits.sensors)
    reader.report('too-many', path, undefined, `${String(entries.length)} sensors are too many.`, {
      count: entries.length,
      min: 0,
      max: taskLimits.sensors,
    });
  return Object.fromEntries(
    entries.slice(0, taskLimits.sensors).map(([id, given]) => [id, sensorValue(given, path, reader)]),
  );
}

function sensorValue(value: unknown, path: string, reader: Reader): number | string {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  return reader.text(value, path, taskLimits.textCharacters);
}

/** The task maker writes inputs so; those of `run --input` are written otherwise. */
const INPUT_FORM =
  '. An input of a task is like { "timeUs": 1000000, "action": { "type": "button", "button": "a", "down": true } }';

function inputsIn(value: unknown, path: string, reader: Reader): readonly InputEvent[] {
  if (value === undefined) return [];
  const list = reader.list(value, path, { min: 0, max: taskLimits.inputs });
  try {
    return readInputs(list, path, INPUT_FORM);
  } catch (error) {
    if (!(error instanceof TypeError)) throw error;
    const [, place = path, message = error.message] = /^(\S+): ([^]*)$/.exec(error.message) ?? [];
    reader.report('damaged', place, undefined, message.slice(0, 300));
    return [];
  }
}

function starsIn(value: unknown, reader: Reader): ClassTask['stars'] {
  const [two, three] = reader.list(value, 'task.stars', { min: 2, max: 2 });
  const most = { min: 0, max: taskLimits.points.max * taskLimits.checks };
  return [reader.number(two, 'task.stars[0]', most), reader.number(three, 'task.stars[1]', most)];
}

function solutionIn(
  fields: Fields,
  reader: Reader,
): { readonly files: readonly SourceFile[] | null; readonly problems: readonly ProjectProblem[] } {
  return fields['solution'] === undefined
    ? { files: null, problems: [] }
    : readFiles(fields['solution'], 'task.solution', reader);
}

/** The locks of a task; none if they cannot be read. */
export function locksOf(task: Carried): Locks {
  const reader = new Reader();
  const locks = locksIn(task['locks'], reader);
  return reader.problems.length === 0 ? locks : noLocks;
}

/** The levels of a task; none if they cannot be read. */
export function levelsOf(task: Carried | undefined): readonly TaskLevel[] {
  const reader = new Reader();
  const levels = readLevels(task?.['levels'], reader, linesIn) ?? [];
  return reader.problems.length === 0 ? levels : [];
}

/** The exam of a task; `null`: it is none, or cannot be read. */
export function examIn(task: Carried | undefined): Exam | null {
  const reader = new Reader();
  const exam = readExam(task?.['exam'], reader) ?? null;
  return reader.problems.length === 0 ? exam : null;
}

/** `true`: no tool stays. */
function toolsIn(value: unknown, reader: Reader): Locks['tools'] {
  if (value === undefined || value === false) return null;
  if (value === true) return [];
  const tools = reader.list(value, 'task.locks.tools', { min: 0, max: taskLimits.tools });
  return tools.map((tool, index) => reader.text(tool, `task.locks.tools[${String(index)}]`, taskLimits.idCharacters));
}

/** `true`: as fast as in reality. */
function speedIn(value: unknown, reader: Reader): Locks['speed'] {
  if (value === undefined || value === false) return null;
  const speed = value === true ? 1 : SPEEDS.find((known) => known === value);
  if (speed === undefined)
    reader.wrongType(value, 'task.locks.speed', `true, false or one of ${JSON.stringify(SPEEDS)}`);
  return speed ?? null;
}

function locksIn(value: unknown, reader: Reader): Locks {
  if (value === undefined) return noLocks;
  const fields = reader.fields(value, 'task.locks', ['tools', ...lockNames, 'lines']);
  const flags = lockNames.flatMap((name) =>
    name === 'speed' ? [] : [[name, reader.flag(fields[name], `task.locks.${name}`, false)] as const],
  );
  return {
    ...(Object.fromEntries(flags) as Omit<Locks, 'speed' | 'tools' | 'lines'>),
    speed: speedIn(fields['speed'], reader),
    tools: toolsIn(fields['tools'], reader),
    lines: linesIn(fields['lines'], 'task.locks.lines', reader),
  };
}

/** Numbers of locked lines. */
function linesIn(value: unknown, path: string, reader: Reader): readonly number[] {
  const numbers = value === undefined ? [] : reader.list(value, path, { min: 0, max: taskLimits.lockedLines });
  return numbers.map((line, index) => reader.whole(line, `${path}[${String(index)}]`, { min: 1, max: 100_000 }));
}
