import { isRecord } from '#core/record';
import { readMyRobot } from '#my-robot/my-robot';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { parseSceneValue } from '#scene/parse';
import { shown, versionProblem } from '#scene/problem';
import { Reader, type Fields } from '#scene/reader';
import { serializeScene } from '#scene/serialize';

import type { ProjectProblem } from './problem';
import { defaultProjectSettings, projectLimits, type Project, type ProjectSettings } from './project';
import { readCarried } from './read-carried';
import { devicesText, readDevices } from './read-devices';
import { readFiles } from './read-files';
import { readHardware } from './read-hardware';

/** The name of the format in a project file. */
export const PROJECT_FORMAT = 'parcours-project';

/**
 * The newest version that this app writes and reads; what an older one can say is written in that. Its course has a
 * version of its own (`#scene/scene`). 2: with a robot of one's own. 3: with several devices. 4: with a task for a class, or
 * handed in.
 */
export const PROJECT_VERSION = 4;

/** Steps that bring a file of a version to the next one: version → step. A file of each version is kept in `kept/`. */
const migrations: Readonly<Record<number, (value: Fields) => Fields>> = {
  1: (value) => value,
  2: (value) => value,
  3: (value) => value,
};

/** A project, or everything that is wrong with the file; `problem` is the first one's message and how many follow. */
export type ParsedProject =
  { readonly project: Project } | { readonly problem: string; readonly problems: readonly ProjectProblem[] };

/**
 * A project as its file: readable JSON in a fixed order, ending in a newline. Reading it back gives an equal project, and
 * the same project always gives the same text.
 */
export function projectToText(project: Project): string {
  const { files, scene, course, settings, devices, task, handIn } = project;
  const lines = [
    `"format": ${JSON.stringify(PROJECT_FORMAT)}`,
    `"version": ${String(versionFor(project))}`,
    ...(course === null ? [] : [`"course": ${JSON.stringify(course)}`]),
    ...(settings === undefined ? [] : [`"settings": ${JSON.stringify(settings)}`]),
    `"files": [\n    ${files.map(({ name, text }) => JSON.stringify({ name, text })).join(',\n    ')}\n  ]`,
    ...(devices === undefined ? [] : [`"devices": ${devicesText(devices)}`]),
    ...(task === undefined ? [] : [`"task": ${JSON.stringify(task)}`]),
    ...(handIn === undefined ? [] : [`"handIn": ${JSON.stringify(handIn)}`]),
    // Texts in JSON contain no line ends of their own: all line ends belong to the layout.
    `"scene": ${serializeScene(scene).trimEnd().replaceAll('\n', '\n  ')}`,
  ];
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

/** The oldest version that can say it all. */
const versionFor = ({ settings, devices, task, handIn }: Project): number => {
  if (task !== undefined || handIn !== undefined) return 4;
  return devices !== undefined ? 3 : settings?.myRobot !== undefined ? 2 : 1;
};

/** Reads a project file. Never throws; a file with a problem loads nothing. */
export function parseProject(text: string): ParsedProject {
  const read = readJsonFile(text, 'project', projectLimits.textCharacters);
  return 'problem' in read ? failed([read.problem]) : parseProjectValue(read.value);
}

/** Reads a project that is already a JavaScript value, for instance out of a message. Never throws. */
export function parseProjectValue(value: unknown): ParsedProject {
  const current = currentVersion(value);
  return 'problem' in current ? failed([current.problem]) : readProject(current.fields);
}

/** The format that a JSON value names, if any. */
export const formatOf = (value: unknown): unknown => (isRecord(value) ? value['format'] : undefined);

/** True if a JSON value says that it is a project file, of any version. */
export const isProjectFile = (value: unknown): value is Fields => formatOf(value) === PROJECT_FORMAT;

const failed = (problems: readonly ProjectProblem[]): ParsedProject => ({ problem: summaryOf(problems), problems });

/** Format and version come first: a newer file must not be judged by older rules. */
function currentVersion(value: unknown): { readonly fields: Fields } | { readonly problem: ProjectProblem } {
  if (!isProjectFile(value)) {
    const message = `This is not a project file: "format" must be "${PROJECT_FORMAT}".`;
    return { problem: { code: 'not-a-project', path: 'format', value: shown(formatOf(value)), params: {}, message } };
  }
  let fields = value;
  const version = fields['version'];
  if (typeof version !== 'number' || !Number.isInteger(version) || version < 1 || version > PROJECT_VERSION)
    return { problem: versionProblem('Project', version, PROJECT_VERSION) };
  for (let step = version; step < PROJECT_VERSION; step += 1) fields = migrations[step]?.(fields) ?? fields;
  return { fields };
}

function readProject(value: Fields): ParsedProject {
  const reader = new Reader();
  const { course, settings, files, devices, task, handIn, scene } = reader.fields(value, '', [
    ...['format', 'version', 'course', 'settings', 'files', 'devices', 'task', 'handIn', 'scene'],
  ]);
  const id = course === undefined || course === null ? null : reader.text(course, 'course', projectLimits.idCharacters);
  const chosen = settings === undefined ? undefined : readSettings(settings, reader);
  const { files: read, problems } = readFiles(files, 'files', reader);
  const carried = {
    ...(task !== undefined && { task: readCarried(task, 'task', reader) }),
    ...(handIn !== undefined && { handIn: readCarried(handIn, 'handIn', reader) }),
  };
  const several = devices === undefined ? undefined : readDevices(devices, reader);
  const parsed = parseSceneValue(scene);
  const wrong: readonly ProjectProblem[] = [
    ...reader.problems,
    ...problems,
    ...(several?.problems ?? []),
    ...('problems' in parsed ? parsed.problems.map(inScene) : []),
  ];
  if (wrong.length > 0 || !('scene' in parsed)) return failed(wrong);
  const project: Project = {
    files: read,
    scene: parsed.scene,
    course: id,
    ...(chosen !== undefined && { settings: chosen }),
    ...(several !== undefined && { devices: several.devices }),
    ...carried,
  };
  return { project };
}

function inScene(problem: ProjectProblem): ProjectProblem {
  const path = problem.path === '' ? 'scene' : `scene.${problem.path}`;
  return { ...problem, path, message: `scene: ${problem.message}` };
}

function readSettings(value: unknown, reader: Reader): ProjectSettings {
  const usual = defaultProjectSettings;
  const fields = reader.fields(value, 'settings', [...Object.keys(usual), 'myRobot']);
  const mine = fields['myRobot'];
  return {
    ...readHardware(fields, 'settings', reader),
    reality: reader.number(fields['reality'], 'settings.reality', projectLimits.reality, usual.reality),
    seed: reader.whole(fields['seed'], 'settings.seed', projectLimits.seed, usual.seed),
    arenaSenses: reader.flag(fields['arenaSenses'], 'settings.arenaSenses', usual.arenaSenses),
    ...(mine === undefined ? {} : { myRobot: readMyRobot(mine, 'settings.myRobot', reader) }),
  };
}
