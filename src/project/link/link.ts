/**
 * A project as the part of an address behind `#`: it opens on another device without any server, because browsers do
 * not send that part.
 *
 *     p=2.<base64url>        2: version of all that follows; 1 for what is large, 3 for a task with more than rules, 4 for a
 *                            robot of one's own, 5 for several devices, 6 for starts of further robots and a task
 *                            that they share, 7 for any angle, round bodies, polygons, locks and groups, 8 for the
 *                            name and the colour of the first robot, 9 for a task for a class or what is handed in, 10 for
 *                            heights of things, 11 for colours of fields and things, and all that `#scene/news` names
 *     <base64url>            checksum of all that follows (4 bytes, FNV-1a, lowest first), the content (`link-bytes.ts`)
 *
 * An unchanged ready course is only named. Only A–Z a–z 0–9 - _ . = occur, which link detectors accept.
 */
import { isRecord } from '#core/record';
import { sealed, unsealed } from '#core/sealed';
import { defaultScene, SCENE_FORMAT, SCENE_VERSION, type Scene, type Task } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { parseProjectValue, PROJECT_FORMAT, PROJECT_VERSION } from '../file';
import { bytesOfContent, contentOfBytes, UNPACKED_BYTES, type LinkBytes, type Room } from './link-bytes';
import { apart, putTogether, sceneChecksum, type Content } from './link-content';
import { newsOfText } from './news-codec';
import { deviceValue } from '../read-devices';
import { MODELLED_BYTES } from './model-coder';
import type { ProjectProblem } from '../problem';
import { defaultProjectSettings, MAIN, type Project, type ProjectDevices } from '../project';

/** The newest version of links that this app makes and reads. */
export const LINK_VERSION = 11;

/** The name of a link's content in the fragment. */
export const LINK_NAME = 'p';

/** Longest link that is made and read. Chosen: Chromium accepts two million characters, others less. */
export const LINK_CHARACTERS = 500_000;

/** A background, and the picture of a task, are included only while the link stays this short. Chosen: chats and mail programs cut longer ones. */
export const BACKGROUND_LINK_CHARACTERS = 8_000;

export type { Room } from './link-bytes';

/** The ready courses by their ids; `null` for an unknown id. */
export type ReadyCourses = (id: string) => Scene | null;

/**
 * The parts that did not fit into a link: the background's picture (sensors do not need it), the whole background,
 * the task's picture.
 */
export type Omitted = 'picture' | 'background' | 'task-picture';

/** A link, and what did not fit. */
export interface MadeLink {
  /** The part of the address behind `#`. */
  readonly fragment: string;
  readonly omitted: readonly Omitted[];
}

/** The content of a link, or why it cannot be opened. */
export type ReadLink =
  | {
      readonly project: Project;
      /** The ready course that it names has changed since the link was made. */
      readonly isCourseChanged: boolean;
    }
  | { readonly problem: LinkProblem };

/** Why a link cannot be opened. */
export interface LinkProblem {
  readonly code: 'damaged' | 'newer-version' | 'too-large' | 'too-long' | 'unknown-course' | 'invalid';
  /** One English sentence with the way out. */
  readonly message: string;
  readonly params: Readonly<Record<string, string | number>>;
  /** The faults of the content of an undamaged link that makes no project. */
  readonly problems: readonly ProjectProblem[];
}

/**
 * Makes the link of a project.
 *
 * @param program whether the files are included; without them the link opens with an empty program
 * @returns `null` if it would be longer than `LINK_CHARACTERS` or unpack to more than `UNPACKED_BYTES`
 */
export function linkOf(
  project: Project,
  { courses, program }: { readonly courses: ReadyCourses; readonly program: boolean },
): MadeLink | null {
  let last: MadeLink | null = null;
  for (const omitted of omissions(project.scene)) {
    const scene = omitted.reduce((left, part) => without[part](left), project.scene);
    const fragment = makeLink({ ...project, scene }, courses, program);
    last = fragment === null ? null : { fragment, omitted };
    if (fragment !== null && fragment.length <= BACKGROUND_LINK_CHARACTERS) break;
  }
  return last;
}

/** The ways to leave parts out of a course, from none to most; the link of the last way is made whatever its length. */
function omissions({ background, task }: Scene): readonly (readonly Omitted[])[] {
  const ways: readonly (readonly Omitted[])[] = [
    [],
    ['picture'],
    ['task-picture'],
    ['picture', 'task-picture'],
    ['background'],
    ['background', 'task-picture'],
  ];
  const has: Readonly<Record<Omitted, boolean>> = {
    picture: background !== null && background.picture !== '',
    background: background !== null,
    'task-picture': task.card !== undefined && task.card.picture !== '',
  };
  return ways.filter((way) => way.every((part) => has[part]));
}

const without: Readonly<Record<Omitted, (scene: Scene) => Scene>> = {
  picture: (scene) => ({ ...scene, background: scene.background && { ...scene.background, picture: '' } }),
  background: (scene) => ({ ...scene, background: null }),
  'task-picture': (scene) => {
    const { card } = scene.task;
    return card === undefined ? scene : { ...scene, task: { ...scene.task, card: { ...card, picture: '' } } };
  },
};

function makeLink(project: Project, courses: ReadyCourses, program: boolean): string | null {
  const { files, scene, course, settings, devices, task, handIn } = project;
  const ready = course === null ? null : courses(course);
  const isReady = ready !== null && isSame(ready, scene);
  const { seconds, noTouch, robots, ...extras } = scene.task;
  const { whole, starts, additions, firstRobot, heights, news } = apart(scene);
  const { myRobot, ...chosen } = settings ?? {};
  const content: Content = {
    files: program ? files : [],
    course,
    settings: settings === undefined ? null : { ...defaultProjectSettings, ...chosen },
    scene: isReady ? { ready: sceneChecksum(scene) } : { whole: { ...whole, task: { seconds, noTouch } } },
    extras: isReady ? {} : extras,
    myRobot: myRobot === undefined ? '' : JSON.stringify(myRobot),
    devices: devices === undefined ? null : program ? devices : withoutPrograms(devices),
    starts: isReady ? [] : starts,
    sharing: isReady ? null : (robots ?? null),
    additions: isReady ? [] : additions,
    firstRobot: isReady ? null : firstRobot,
    carried: task === undefined && handIn === undefined ? '' : JSON.stringify({ task, handIn }),
    heights: isReady ? [] : heights,
    news: isReady ? '' : news,
  };
  const bytes = bytesOfContent(content);
  const link = bytes === null ? null : linkOfBytes(bytes);
  return link === null || link.length > LINK_CHARACTERS ? null : link;
}

/** Each device with an empty program of its own, or still with the one of another device. */
const withoutPrograms = ({ first, others }: ProjectDevices): ProjectDevices => ({
  first,
  others: others.map((device) => (device.sameAs === '' ? { ...device, files: [EMPTY_PROGRAM] } : device)),
});

const EMPTY_PROGRAM = { name: MAIN, text: '' };

/** The link that holds these bytes. */
export const linkOfBytes = ({ version, bytes }: LinkBytes): string =>
  `${LINK_NAME}=${String(version)}.${sealed(bytes)}`;

/** True if the part of an address behind `#` says that it is a link to a project. */
export const isProjectLink = (fragment: string): boolean => /^#?p=/.test(fragment);

/**
 * Reads the part of an address behind `#`, with or without it. Never throws; a link with a problem opens nothing.
 *
 * @param room of several links: what this one unpacks to is taken from it
 */
export function projectOfLink(fragment: string, courses: ReadyCourses, room: Room = { left: 0 }): ReadLink {
  if (fragment.length > LINK_CHARACTERS) {
    const params = { length: fragment.length, max: LINK_CHARACTERS };
    const message = `The link has ${String(fragment.length)} characters; the limit is ${String(LINK_CHARACTERS)}.`;
    return failed('too-long', message, params);
  }
  const [, version, data] = /^#?p=(\d{1,9})\.([\w-]+)=*$/.exec(fragment.trim()) ?? [];
  if (version === undefined || data === undefined) return damaged();
  if (Number(version) > LINK_VERSION) {
    const message = `The link is of version ${version}; this app reads version ${String(LINK_VERSION)}. Reload the page to update.`;
    return failed('newer-version', message, { version: Number(version), known: LINK_VERSION });
  }
  const known = ([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11] as const).find((one) => String(one) === version);
  const bytes = known === undefined ? null : unsealed(data);
  if (known === undefined || bytes === null) return damaged();
  const content = contentOfBytes({ version: known, bytes }, room);
  if (content === 'too-large') {
    const isModelled = known === 2 || (known > 2 && bytes[0] === 2);
    const max = isModelled ? MODELLED_BYTES : UNPACKED_BYTES;
    return failed('too-large', `The link unpacks to more than ${String(max)} bytes. It is not opened.`, { max });
  }
  return content === 'damaged' ? damaged() : readContent(content, courses);
}

function readContent(content: Content, courses: ReadyCourses): ReadLink {
  const { files, course, scene, devices } = content;
  const ready = 'ready' in scene ? courses(course ?? '') : null;
  if ('ready' in scene && ready === null) {
    const message = `The link names the ready course "${course ?? ''}", which this app does not have. Reload the page to update.`;
    return failed('unknown-course', message, { course: course ?? '' });
  }
  const settings = settingsIn(content);
  const carried = carriedIn(content);
  const news = newsOfText(content.news);
  if (settings === 'damaged' || carried === 'damaged' || news === null) return damaged();
  // Read like a file: the same rules judge the content of a link.
  const parsed = parseProjectValue({
    format: PROJECT_FORMAT,
    version: PROJECT_VERSION,
    course,
    ...(settings === null ? {} : { settings }),
    files: files.length === 0 ? [EMPTY_PROGRAM] : files,
    ...(devices === null ? {} : { devices: { first: devices.first, others: devices.others.map(deviceValue) } }),
    ...carried,
    scene:
      ready !== null || 'ready' in scene
        ? valueOf(defaultScene())
        : valueOf({ ...putTogether({ ...content, whole: scene.whole }, news), task: taskIn(content, scene.whole) }),
  });
  if ('problems' in parsed)
    return failed('invalid', `The link holds no project: ${parsed.problem}`, {}, parsed.problems);
  const project = ready === null ? parsed.project : { ...parsed.project, scene: ready };
  const isCourseChanged = 'ready' in scene && ready !== null && sceneChecksum(ready) !== scene.ready;
  return { project, isCourseChanged };
}

/** The task of a whole course. */
const taskIn = ({ extras, sharing }: Content, { task }: Scene): Task => ({
  ...task,
  ...extras,
  ...(sharing === null ? {} : { robots: sharing }),
});

/** The settings as a file holds them, or `null` without any. */
function settingsIn({ settings, myRobot }: Content): Readonly<Record<string, unknown>> | null | 'damaged' {
  if (settings === null || myRobot === '') return settings === null ? null : { ...settings };
  try {
    return { ...settings, myRobot: JSON.parse(myRobot) as unknown };
  } catch {
    return 'damaged';
  }
}

/** Task and hand-in as a file holds them. */
function carriedIn({ carried }: Content): Readonly<Record<string, unknown>> | 'damaged' {
  try {
    const value: unknown = carried === '' ? {} : JSON.parse(carried);
    if (!isRecord(value)) return 'damaged';
    const { task, handIn } = value;
    return { ...(task !== undefined && { task }), ...(handIn !== undefined && { handIn }) };
  } catch {
    return 'damaged';
  }
}

/** A course as its file holds it; one that comes from bytes may hold anything that its types allow. */
const valueOf = (scene: Scene): unknown => ({ format: SCENE_FORMAT, version: SCENE_VERSION, ...scene });

const isSame = (one: Scene, other: Scene): boolean => one === other || serializeScene(one) === serializeScene(other);

function failed(
  code: LinkProblem['code'],
  message: string,
  params: LinkProblem['params'],
  problems: readonly ProjectProblem[] = [],
): ReadLink {
  return { problem: { code, message, params, problems } };
}

/** The message about a damaged link, in English. */
export const DAMAGED_LINK = 'The link is damaged: a part of it is missing or changed. Copy it again, whole.';

const damaged = (): ReadLink => failed('damaged', DAMAGED_LINK, {});
