import { unread } from '#check/hand-in/unread';
import { looksLikeSeries, parseSeries, type ReadSeries } from '#check/series/read-series';
import { isClassFile } from '#school-class/class-file';
import { parseScene, parseSceneValue } from '#scene/parse';
import { SCENE_FORMAT, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { looksLikeEarlierLevel, sceneOfEarlierLevel } from '#project/earlier-levels';
import { formatOf, isProjectFile, parseProject, parseProjectValue } from '#project/file';
import type { ReadyCourses } from '#project/link/link';
import { MAIN, projectLimits, type Project } from '#project/project';
import { courseOfMap } from '#rescue-line/course-of-map';
import { looksLikeMap, readMap } from '#rescue-line/read-map';
import { looksLikeTournament } from '#lab/tournament/format';
import { isTapeFile } from '#tape/tape';
import {
  unreadable,
  type CourseDocument,
  type Document,
  type FileProblem,
  type SeriesDocument,
  type TextDocument,
  type Unreadable,
} from './document';
import { documentOfWorld } from './webtigerpython';

/**
 * Reads a text of JSON of any known kind: a project, a course, a map of a rescue line, a world of WebTigerPython, a level of an
 * earlier simulator, a series, a recorded run, a tournament.
 * Never throws.
 */
export function documentOfText(text: string, courses: ReadyCourses): TextDocument {
  if (looksLikeSeries(text)) return seriesDocument(parseSeries(text, courses));
  if (looksLikeTournament(text)) return { kind: 'tournament', text };
  if (isTapeFile(text)) return { kind: 'recording', text, atUs: 0 };
  const value = valueOf(text);
  // A text that is not JSON, or far too long, gets the messages of a project file.
  if (value === undefined || isProjectFile(value)) return projectDocument(value, text);
  if (isClassFile(value)) return CLASS;
  const format = formatOf(value);
  if (format === undefined && looksLikeMap(value)) return mapDocument(value);
  const world = format === undefined ? documentOfWorld(value) : null;
  if (world !== null) return world;
  if (format !== SCENE_FORMAT && looksLikeEarlierLevel(value)) {
    const level = sceneOfEarlierLevel(value);
    if ('scene' in level) return courseDocument(level.scene);
    const { problem, place } = level;
    const params = {};
    return wrongInside(problem, [{ code: 'not-a-level', path: place, value: '', params, message: problem }]);
  }
  if (format !== SCENE_FORMAT) return NEITHER;
  const parsed = parseSceneValue(value);
  return 'scene' in parsed ? courseDocument(parsed.scene) : wrongInside(parsed.problem, parsed.problems);
}

/** True if a text begins as our files do. */
export const isOurs = (text: string): boolean => /^\ufeff?\s*\{\s*"format"\s*:\s*"parcours-/.test(text);

/**
 * The task in a document: a project, or a course with an empty program.
 *
 * @returns or why there is none
 */
export function taskIn(document: Document): { readonly project: Project } | Unreadable {
  if (document.kind === 'project' || document.kind === 'unreadable') return document;
  if (document.kind === 'course')
    return { project: { files: [{ name: MAIN, text: '' }], scene: document.scene, course: null } };
  if (document.kind === 'tournament') return TOURNAMENT;
  return document.kind === 'series' ? SERIES : NEITHER;
}

/** A series that was read, or why it cannot be. */
export const seriesDocument = (read: ReadSeries): SeriesDocument | Unreadable =>
  'series' in read ? { kind: 'series', series: read.series } : wrongInside(read.problem, read.problems);

function projectDocument(value: unknown, text: string): TextDocument {
  const parsed = value === undefined ? parseProject(text) : parseProjectValue(value);
  if ('problem' in parsed) return wrongInside(parsed.problem, parsed.problems);
  return { kind: 'project', project: parsed.project, isCourseChanged: false };
}

function mapDocument(value: unknown): CourseDocument | Unreadable {
  const read = readMap(value);
  if ('problem' in read) return wrongInside(read.problem, read.problems);
  const { scene, notes } = courseOfMap(read.map);
  // The largest maps have more lines than a course may hold.
  const parsed = parseScene(serializeScene(scene));
  return 'scene' in parsed
    ? { ...courseDocument(parsed.scene), mapNotes: notes }
    : wrongInside(parsed.problem, parsed.problems);
}

const courseDocument = (scene: Scene): CourseDocument => ({
  ...{ kind: 'course', scene, device: null },
  ...{ isFromWebTigerPython: false, notes: [], mapNotes: [] },
});

function wrongInside(message: string, problems: readonly FileProblem[]): Unreadable {
  const code = problems[0]?.code === 'newer-version' ? 'newer' : 'project';
  return { kind: 'unreadable', ...unread(code, { detail: message }), message, problems };
}

/** The JSON value of a text; `undefined`: none, or longer than any file of ours. */
function valueOf(text: string): unknown {
  if (text.length > projectLimits.textCharacters) return undefined;
  try {
    return JSON.parse(text.startsWith('\ufeff') ? text.slice(1) : text);
  } catch {
    return undefined;
  }
}

const notOurs = (
  code: 'not-a-project' | 'is-a-class' | 'wrong-type',
  path: string,
  value: string,
  message: string,
): Unreadable => wrongInside(message, [{ code, path, value, params: {}, message }]);

const NEITHER = notOurs(
  'not-a-project',
  ...(['format', ''] as const),
  'This is neither a project nor a course: "format" is missing or unknown.',
);

/** A series in the place of a task or a hand-in. */
export const SERIES = notOurs(
  'wrong-type',
  ...(['', '"parcours-series"'] as const),
  'is a series itself; a series holds tasks only. Add its tasks one by one.',
);

/** The file of a tournament in the place of a task or a hand-in. */
export const TOURNAMENT: Unreadable = {
  ...unreadable(unread('tournament').problem),
  message: 'is a tournament. Play it again with parcours tournament --verify, or open it on the page.',
};

/** The file of a class in the place of work. */
const CLASS = notOurs(
  'is-a-class',
  ...(['format', '"parcours-class"'] as const),
  'is the file of a class. Open it on the page under Classes, or give it to parcours class.',
);
