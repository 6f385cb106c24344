import { courseParts, withCourse } from './edit';
import { loneGroups } from './groups';
import { readJsonFile, summaryOf } from './json-file';
import { migrated, OLDEST_VERSION } from './migrations';
import { shown, type SceneProblem } from './problem';
import { readCourseChanges, readRobotChanges } from './read-course';
import { readObject } from './read-object';
import { readTypeId } from './kinds/reading/robot-values';
import { withRobot } from './robot-values';
import { Reader, type Fields } from './reader';
import {
  centreStart,
  countPoints,
  defaultScene,
  SCENE_FORMAT,
  SCENE_VERSION,
  sceneLimits,
  type Scene,
  type SceneObject,
} from './scene';

/** A scene, or everything that is wrong with the file; `problem` is the first one's message and how many follow. */
export type ParsedScene =
  { readonly scene: Scene } | { readonly problem: string; readonly problems: readonly SceneProblem[] };

/** Reads a course file. Never throws; a file with a problem loads nothing. */
export function parseScene(text: string): ParsedScene {
  const read = readJsonFile(text, 'course', sceneLimits.textCharacters);
  return 'problem' in read ? failed([read.problem]) : parseSceneValue(read.value);
}

/**
 * Reads a course that is already a JavaScript value, for instance out of a message. Never throws. Only the form is
 * judged: where things stand is left to `rules.ts`, so that half-done work can be kept.
 */
export function parseSceneValue(value: unknown): ParsedScene {
  const reader = new Reader();
  const file = newestFile(value, reader);
  if (file === null) return failed(reader.problems);
  const scene = readScene(file, reader);
  return reader.problems.length > 0 ? failed(reader.problems) : { scene };
}

const failed = (problems: readonly SceneProblem[]): ParsedScene => ({ problem: summaryOf(problems), problems });

/**
 * The file in the newest version; `null`: no course, or a version that this app does not know. Checked first, because a
 * newer file must not be judged by older rules.
 */
function newestFile(value: unknown, reader: Reader): Fields | null {
  const file = typeof value === 'object' && value !== null && !Array.isArray(value) ? (value as Fields) : {};
  if (file.format !== SCENE_FORMAT) {
    const what = `This is not a course file: "format" must be "${SCENE_FORMAT}".`;
    reader.report('not-a-scene', 'format', file.format, what);
    return null;
  }
  const { version } = file;
  const isWhole = typeof version === 'number' && Number.isInteger(version);
  if (isWhole && version >= OLDEST_VERSION && version <= SCENE_VERSION) return migrated(file, version);
  const params = { version: typeof version === 'number' ? version : shown(version), known: SCENE_VERSION };
  if (isWhole && version > SCENE_VERSION) {
    const what = `Scene version ${version} is newer than this app (${SCENE_VERSION}). Reload the page to update.`;
    reader.report('newer-version', 'version', version, what, params);
  } else {
    const what = `Scene version ${params.version} is unknown; this app reads versions ${OLDEST_VERSION} to ${SCENE_VERSION}.`;
    reader.report('unknown-version', 'version', version, what, params);
  }
  return null;
}

const SCENE_KEYS = ['format', 'version', ...courseParts, 'board', 'robot', 'objects'];

function readScene(value: Fields, reader: Reader): Scene {
  const fields = reader.fields(value, '', SCENE_KEYS);
  const course = withCourse(defaultScene(), readCourseChanges(fields, '', reader));
  const start = fields.robot === undefined ? {} : readRobotChanges(fields.robot, 'robot', reader);
  return {
    ...course,
    board: readTypeId(fields.board, 'board', reader),
    robot: withRobot(centreStart(course.size), start),
    objects: fields.objects === undefined ? [] : readObjects(fields.objects, reader),
  };
}

function readObjects(value: unknown, reader: Reader): SceneObject[] {
  const entries = reader.list(value, 'objects', { min: 0, max: sceneLimits.objects });
  const places = new Map<string, string>();
  const objects: SceneObject[] = [];
  let pointsLeft: number = sceneLimits.points;
  for (const [index, entry] of entries.entries()) {
    if (reader.isFull) break;
    const path = `objects[${index}]`;
    const object = readObject(entry, path, pointsLeft, reader);
    if (!object) continue;
    pointsLeft -= countPoints(object);
    if (object.id !== '') noteId(object.id, path, places, reader); // else it was reported already
    objects.push(object);
  }
  if (reader.problems.length === 0) reportLoneGroups(objects, reader);
  return objects;
}

function reportLoneGroups(objects: readonly SceneObject[], reader: Reader): void {
  const lone = loneGroups(objects);
  for (const [index, { group }] of objects.entries()) {
    if (group === undefined || !lone.has(group)) continue;
    const what = `"${group}" is the group of this object alone. Give it to a second object, or leave it out.`;
    reader.report('group-of-one', `objects[${index}].group`, group, what, { group });
  }
}

function noteId(id: string, path: string, places: Map<string, string>, reader: Reader): void {
  const other = places.get(id);
  if (other === undefined) {
    places.set(id, path);
    return;
  }
  const what = `"${id}" is already the id of ${other}. Give each object its own.`;
  reader.report('duplicate-id', `${path}.id`, id, what, { other });
}
