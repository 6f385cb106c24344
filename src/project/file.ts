import { readMyRobot } from '#my-robot/my-robot';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { parseSceneValue } from '#scene/parse';
import { shown } from '#scene/problem';
import { Reader, type Fields } from '#scene/reader';
import { serializeScene } from '#scene/serialize';

import type { ProjectProblem } from './problem';
import {
  defaultProjectSettings,
  FILE_BYTES,
  MAIN,
  nameProblem,
  projectLimits,
  utf8Bytes,
  type Project,
  type ProjectSettings,
  type SourceFile,
} from './project';

/** The name of the format in a project file. */
export const PROJECT_FORMAT = 'parcours-project';

/**
 * The newest version that this app writes and reads; what an older one can say is written in that. Its course has a
 * version of its own (`#scene/scene`). 2: with a robot of one's own.
 */
export const PROJECT_VERSION = 2;

/** Steps that bring a file of a version to the next one: version → step. A file of each version is kept in `kept/`. */
const migrations: Readonly<Record<number, (value: Fields) => Fields>> = {
  1: (value) => value,
};

/** A project, or everything that is wrong with the file; `problem` is the first one's message and how many follow. */
export type ParsedProject =
  { readonly project: Project } | { readonly problem: string; readonly problems: readonly ProjectProblem[] };

/**
 * A project as its file: readable JSON in a fixed order, ending in a newline. Reading it back gives an equal project, and
 * the same project always gives the same text.
 */
export function projectToText({ files, scene, course, settings }: Project): string {
  const lines = [
    `"format": ${JSON.stringify(PROJECT_FORMAT)}`,
    `"version": ${String(settings?.myRobot === undefined ? 1 : PROJECT_VERSION)}`,
    ...(course === null ? [] : [`"course": ${JSON.stringify(course)}`]),
    ...(settings === undefined ? [] : [`"settings": ${JSON.stringify(settings)}`]),
    `"files": [\n    ${files.map(({ name, text }) => JSON.stringify({ name, text })).join(',\n    ')}\n  ]`,
    // Texts in JSON contain no line ends of their own: all line ends belong to the layout.
    `"scene": ${serializeScene(scene).trimEnd().replaceAll('\n', '\n  ')}`,
  ];
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

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
export const formatOf = (value: unknown): unknown => (isFields(value) ? value['format'] : undefined);

/** Whether a JSON value says that it is a project file, of any version. */
export const isProjectFile = (value: unknown): value is Fields => formatOf(value) === PROJECT_FORMAT;

const isFields = (value: unknown): value is Fields =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

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
    return { problem: versionProblem(version) };
  for (let step = version; step < PROJECT_VERSION; step += 1) fields = migrations[step]?.(fields) ?? fields;
  return { fields };
}

function versionProblem(version: unknown): ProjectProblem {
  const known = PROJECT_VERSION;
  const isNewer = typeof version === 'number' && Number.isInteger(version) && version > known;
  const params = { version: typeof version === 'number' ? version : shown(version).slice(0, 20), known };
  const message = isNewer
    ? `Project version ${String(version)} is newer than this app (${String(known)}). Reload the page to update.`
    : `Project version ${String(params.version)} is unknown; this app reads version ${String(known)}.`;
  return {
    code: isNewer ? 'newer-version' : 'unknown-version',
    path: 'version',
    value: shown(version),
    params,
    message,
  };
}

function readProject(value: Fields): ParsedProject {
  const reader = new Reader();
  const { course, settings, files, scene } = reader.fields(value, '', [
    'format',
    'version',
    'course',
    'settings',
    'files',
    'scene',
  ]);
  const id = course === undefined || course === null ? null : reader.text(course, 'course', projectLimits.idCharacters);
  const chosen = settings === undefined ? undefined : readSettings(settings, reader);
  const { files: read, problems } = readFiles(files, reader);
  const parsed = parseSceneValue(scene);
  const wrong: readonly ProjectProblem[] = [
    ...reader.problems,
    ...problems,
    ...('problems' in parsed ? parsed.problems.map(inScene) : []),
  ];
  if (wrong.length > 0 || !('scene' in parsed)) return failed(wrong);
  const project: Project = { files: read, scene: parsed.scene, course: id };
  return { project: chosen === undefined ? project : { ...project, settings: chosen } };
}

function inScene(problem: ProjectProblem): ProjectProblem {
  const path = problem.path === '' ? 'scene' : `scene.${problem.path}`;
  return { ...problem, path, message: `scene: ${problem.message}` };
}

function readSettings(value: unknown, reader: Reader): ProjectSettings {
  const usual = defaultProjectSettings;
  const fields = reader.fields(value, 'settings', [...Object.keys(usual), 'myRobot']);
  const mine = fields['myRobot'];
  const id = (key: 'device' | 'firmware' | 'robot'): string =>
    reader.text(fields[key], `settings.${key}`, projectLimits.idCharacters, usual[key]);
  return {
    device: id('device'),
    firmware: id('firmware'),
    robot: id('robot'),
    robotOptions: readRobotOptions(fields['robotOptions'], reader),
    reality: reader.number(fields['reality'], 'settings.reality', projectLimits.reality, usual.reality),
    seed: reader.whole(fields['seed'], 'settings.seed', projectLimits.seed, usual.seed),
    arenaSenses: reader.flag(fields['arenaSenses'], 'settings.arenaSenses', usual.arenaSenses),
    ...(mine === undefined ? {} : { myRobot: readMyRobot(mine, 'settings.myRobot', reader) }),
  };
}

function readRobotOptions(value: unknown, reader: Reader): ProjectSettings['robotOptions'] {
  const path = 'settings.robotOptions';
  const robots = readEntries(value, path, reader);
  return Object.fromEntries(
    robots.map(([robot, options]) => {
      const place = `${path}.${robot.slice(0, 40)}`;
      const own = readEntries(options, place, reader).map(([option, choice]): [string, string] => {
        return [option, reader.text(choice, `${place}.${option.slice(0, 40)}`, projectLimits.idCharacters)];
      });
      return [robot, Object.fromEntries(own)];
    }),
  );
}

function readEntries(value: unknown, path: string, reader: Reader): readonly (readonly [string, unknown])[] {
  if (value === undefined) return [];
  if (!isFields(value)) {
    reader.wrongType(value, path, 'an object { … }');
    return [];
  }
  const entries = Object.entries(value);
  for (const [key] of entries) {
    reader.text(key, path, projectLimits.idCharacters);
    if (key === '__proto__') reader.report('unknown-value', path, key, '"__proto__" cannot be an id.');
  }
  return reader.list(entries, path, { min: 0, max: projectLimits.options }) as typeof entries;
}

/** The files, and what is wrong with their names and sizes. */
function readFiles(value: unknown, reader: Reader): { files: readonly SourceFile[]; problems: ProjectProblem[] } {
  const entries = reader.list(value, 'files', { min: 1, max: projectLimits.files });
  const files: SourceFile[] = [];
  const problems: ProjectProblem[] = [];
  for (const [index, entry] of entries.entries()) {
    const path = `files[${String(index)}]`;
    const fields = reader.fields(entry, path, ['name', 'text']);
    const name = reader.text(fields['name'], `${path}.name`, projectLimits.textCharacters);
    const text = reader.text(fields['text'], `${path}.text`, projectLimits.textCharacters);
    if (typeof fields['name'] === 'string' && typeof fields['text'] === 'string')
      problems.push(...fileProblems({ name, text }, files, path));
    files.push({ name, text });
  }
  return { files, problems };
}

/** What is wrong with a file that comes after `before`. */
function fileProblems(file: SourceFile, before: readonly SourceFile[], path: string): ProjectProblem[] {
  const { name, text } = file;
  const wrong = nameProblem(name, before);
  const bytes = utf8Bytes(text);
  const problems: ProjectProblem[] = [];
  if (wrong !== null) {
    const message = `${path}.name: ${shown(name)} cannot be the name of a file: ${NAME_RULES[wrong]}`;
    problems.push({ code: 'file-name', path: `${path}.name`, value: shown(name), params: { rule: wrong }, message });
  } else if (before.length === 0 && name !== MAIN) {
    const message = `${path}.name: the first file must be ${MAIN}, not ${shown(name)}.`;
    problems.push({ code: 'no-main', path: `${path}.name`, value: shown(name), params: {}, message });
  }
  if (bytes > FILE_BYTES) {
    const message = `${path}.text: ${String(bytes)} bytes are too many; the limit is ${String(FILE_BYTES)}.`;
    const params = { length: bytes, max: FILE_BYTES };
    problems.push({ code: 'file-too-large', path: `${path}.text`, value: '', params, message });
  }
  return problems;
}

const NAME_RULES = {
  nameEmpty: 'it is empty.',
  nameTaken: 'another file has it.',
  nameCharacters: 'it may have letters, digits, "_", "-" and "." only.',
  nameLong: 'it is too long.',
} as const;
