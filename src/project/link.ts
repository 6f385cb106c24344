/**
 * A project as the part of an address behind `#`: it opens on another device without any server, because browsers keep
 * that part to themselves.
 *
 *     p=1.<base64url>        1: version of all that follows
 *     <base64url>            checksum of all that follows (4 bytes, FNV-1a, lowest first), length of the deflated
 *                            figures (3 bytes, lowest first), figures and words, each deflated (RFC 1951)
 *     figures, words         `columns.ts`; in which order: `contentCodec` below and `scene-codec.ts`
 *
 * A ready course that was not changed is named only. Only A–Z a–z 0–9 - _ . = occur, which collectors of links accept.
 */
import { defaultScene, SCENE_FORMAT, SCENE_VERSION, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { fromBase64Url, toBase64Url } from './base64';
import { mapped, record, type Codec } from './codec';
import { ColumnReader, ColumnWriter, DamagedBytes, type Bytes } from './columns';
import { packed, unpacked } from './deflate';
import { parseProjectValue, PROJECT_FORMAT, PROJECT_VERSION } from './file';
import type { ProjectProblem } from './problem';
import { defaultProjectSettings, MAIN, projectLimits, type Project, type ProjectSettings } from './project';
import { dictionary, sceneCodec, sharedCodecs, type SharedCodecs } from './scene-codec';
import { LIKELY_WORDS } from './words';

/** The version of links this app makes, and the newest it reads. */
export const LINK_VERSION = 1;

/** What a link's content is called in the fragment. */
export const LINK_NAME = 'p';

/** The most a link may unpack to, in bytes. */
export const UNPACKED_BYTES = 4 * 1024 * 1024;

/** Longest link that is made and read. Chosen: Chromium takes two million characters, others less. */
export const LINK_CHARACTERS = 500_000;

/** A background comes along only as long as the link stays this short. Chosen: chats and mail programs cut longer ones. */
export const BACKGROUND_LINK_CHARACTERS = 8_000;

/** The ready courses by their ids; `null`: there is none of this id. */
export type ReadyCourses = (id: string) => Scene | null;

/** A link, and what had no room in it: the picture of a background (the sensors read the same without), or all of it. */
export interface MadeLink {
  /** Goes behind the `#`. */
  readonly fragment: string;
  readonly omitted: readonly ('picture' | 'background')[];
}

/** What stands in a link, or why it cannot be opened. */
export type ReadLink =
  | {
      readonly project: Project;
      /** The ready course it names is not quite what it was when the link was made. */
      readonly isCourseChanged: boolean;
    }
  | { readonly problem: LinkProblem };

/** Why a link cannot be opened. */
export interface LinkProblem {
  readonly code: 'damaged' | 'newer-version' | 'too-large' | 'too-long' | 'unknown-course' | 'invalid';
  /** One English sentence with the way out. */
  readonly message: string;
  readonly params: Readonly<Record<string, string | number>>;
  /** What is wrong with the content of a link that is whole but makes no project. */
  readonly problems: readonly ProjectProblem[];
}

/** The course as it stands in a link: all of it, or the ready one of the project's `course` with its checksum. */
type LinkScene = { readonly ready: number } | { readonly whole: Scene };

interface Content {
  readonly files: readonly { readonly name: string; readonly text: string }[];
  readonly course: string | null;
  readonly settings: ProjectSettings | null;
  readonly scene: LinkScene;
}

/**
 * Makes the link of a project.
 *
 * @param program whether the files come along; without them the link opens with an empty program
 * @returns `null` when it would be longer than `LINK_CHARACTERS` or unpack to more than `UNPACKED_BYTES`
 */
export function linkOf(
  project: Project,
  { courses, program }: { readonly courses: ReadyCourses; readonly program: boolean },
): MadeLink | null {
  const { background } = project.scene;
  const whole = makeLink(project, courses, program);
  if (background === null || isShort(whole, BACKGROUND_LINK_CHARACTERS))
    return whole === null ? null : { fragment: whole, omitted: [] };
  const grid = makeLink(withBackground(project, { ...background, picture: '' }), courses, program);
  if (background.picture !== '' && isShort(grid, BACKGROUND_LINK_CHARACTERS))
    return { fragment: grid, omitted: ['picture'] };
  const bare = makeLink(withBackground(project, null), courses, program);
  return bare === null ? null : { fragment: bare, omitted: ['background'] };
}

const isShort = (link: string | null, max: number): link is string => link !== null && link.length <= max;

const withBackground = (project: Project, background: Scene['background']): Project => ({
  ...project,
  scene: { ...project.scene, background },
});

function makeLink({ files, scene, course, settings }: Project, courses: ReadyCourses, program: boolean): string | null {
  const ready = course === null ? null : courses(course);
  const content: Content = {
    files: program ? files : [],
    course,
    settings: settings ?? null,
    scene: ready !== null && isSame(ready, scene) ? { ready: sceneChecksum(scene) } : { whole: scene },
  };
  const out = new ColumnWriter();
  contentCodec.codec.write(out, content);
  const bytes = out.bytes();
  if (bytes.figures.length + bytes.words.length > UNPACKED_BYTES) return null;
  const link = linkOfBytes(bytes);
  return link.length > LINK_CHARACTERS ? null : link;
}

const SUM_BYTES = 4;
const HEAD_BYTES = SUM_BYTES + 3;

/** The link that holds these bytes. */
export function linkOfBytes({ figures, words }: Bytes): string {
  const deflated = packed(figures);
  const deflatedWords = packed(words, LIKELY_WORDS);
  const all = new Uint8Array(HEAD_BYTES + deflated.length + deflatedWords.length);
  all.set([deflated.length & 0xff, (deflated.length >>> 8) & 0xff, deflated.length >>> 16], SUM_BYTES);
  all.set(deflated, HEAD_BYTES);
  all.set(deflatedWords, HEAD_BYTES + deflated.length);
  const sum = checksum(all.subarray(SUM_BYTES));
  all.set([sum & 0xff, (sum >>> 8) & 0xff, (sum >>> 16) & 0xff, sum >>> 24]);
  return `${LINK_NAME}=${String(LINK_VERSION)}.${toBase64Url(all)}`;
}

/** Whether the part of an address behind `#` says that it is a link to a project. */
export const isProjectLink = (fragment: string): boolean => /^#?p=/.test(fragment);

/** Reads the part of an address behind `#`, with or without it. Never throws; a link with a problem opens nothing. */
export function projectOfLink(fragment: string, courses: ReadyCourses): ReadLink {
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
  const all = Number(version) === LINK_VERSION ? fromBase64Url(data) : null;
  if (all === null) return damaged();
  const bytes = unpackedBytes(all);
  if (bytes === 'too-large') {
    const max = UNPACKED_BYTES;
    return failed('too-large', `The link unpacks to more than ${String(max)} bytes. It is not opened.`, { max });
  }
  return bytes === 'damaged' ? damaged() : readBytes(bytes, courses);
}

/** Takes apart what `linkOfBytes` put together; both parts together stay within the limit. */
function unpackedBytes(all: Uint8Array): Bytes | 'damaged' | 'too-large' {
  const [a = 0, b = 0, c = 0, d = 0, low = 0, middle = 0, high = 0] = all;
  const end = HEAD_BYTES + (low | (middle << 8) | (high << 16));
  const sum = (a | (b << 8) | (c << 16) | (d << 24)) >>> 0;
  if (all.length <= end || checksum(all.subarray(SUM_BYTES)) !== sum) return 'damaged';
  const figures = unpacked(all.subarray(HEAD_BYTES, end), UNPACKED_BYTES);
  if (typeof figures === 'string') return figures;
  const words = unpacked(all.subarray(end), UNPACKED_BYTES - figures.length, LIKELY_WORDS);
  return typeof words === 'string' ? words : { figures, words };
}

function readBytes(bytes: Bytes, courses: ReadyCourses): ReadLink {
  let content: Content;
  try {
    const reader = new ColumnReader(bytes, contentCodec.columns);
    content = contentCodec.codec.read(reader);
    if (!reader.isAtEnd) return damaged();
  } catch (error) {
    if (error instanceof DamagedBytes) return damaged();
    throw error;
  }
  return readContent(content, courses);
}

function readContent({ files, course, settings, scene }: Content, courses: ReadyCourses): ReadLink {
  const ready = 'ready' in scene ? courses(course ?? '') : null;
  if ('ready' in scene && ready === null) {
    const message = `The link names the ready course "${course ?? ''}", which this app does not have. Reload the page to update.`;
    return failed('unknown-course', message, { course: course ?? '' });
  }
  // Read like a file: what is in a link is judged by the same rules.
  const parsed = parseProjectValue({
    format: PROJECT_FORMAT,
    version: PROJECT_VERSION,
    course,
    ...(settings === null ? {} : { settings }),
    files: files.length === 0 ? [{ name: MAIN, text: '' }] : files,
    scene: ready !== null || 'ready' in scene ? valueOf(defaultScene()) : valueOf(scene.whole),
  });
  if ('problems' in parsed)
    return failed('invalid', `The link holds no project: ${parsed.problem}`, {}, parsed.problems);
  const project = ready === null ? parsed.project : { ...parsed.project, scene: ready };
  const isCourseChanged = 'ready' in scene && ready !== null && sceneChecksum(ready) !== scene.ready;
  return { project, isCourseChanged };
}

/** A course as its file holds it; one that comes from bytes may hold anything its types allow. */
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

const damaged = (): ReadLink =>
  failed('damaged', 'The link is damaged: a part of it is missing or changed. Copy it again, whole.', {});

/** What a link holds. The order is the format: see `scene-codec.ts`. */
const contentCodec = makeContentCodec();

function makeContentCodec(): { readonly codec: Codec<Content>; readonly columns: number } {
  const shared = sharedCodecs();
  const { columns, text, word } = shared;
  const scene = linkSceneCodec(shared);
  const file = record<Content['files'][number]>({ name: word, text });
  const codec = record<Content>({
    course: columns.optional(word),
    scene,
    settings: columns.optional(settingsCodec(shared)),
    files: columns.list(file, projectLimits.files),
  });
  return { codec, columns: columns.used };
}

function linkSceneCodec(shared: SharedCodecs): Codec<LinkScene> {
  const isReady = shared.columns.flag();
  const sum = shared.columns.uint();
  const scene = sceneCodec(shared);
  return {
    write(out, value) {
      isReady.write(out, 'ready' in value);
      if ('ready' in value) sum.write(out, value.ready);
      else scene.write(out, value.whole);
    },
    read: (from) => (isReady.read(from) ? { ready: sum.read(from) } : { whole: scene.read(from) }),
  };
}

/** The usual settings are a single flag. */
function settingsCodec({ columns, word, options }: SharedCodecs): Codec<ProjectSettings> {
  const chosen = record<ProjectSettings>({
    device: word,
    firmware: word,
    robot: word,
    robotOptions: dictionary(columns, word, options, projectLimits.options),
    reality: columns.number(),
    seed: columns.uint(),
    arenaSenses: columns.flag(),
  });
  return mapped(
    columns.optional(chosen),
    (settings) => (isUsual(settings) ? null : settings),
    (settings) => settings ?? defaultProjectSettings,
  );
}

function isUsual(settings: ProjectSettings): boolean {
  const { robotOptions, ...rest } = settings;
  const keys = Object.keys(rest) as (keyof typeof rest)[];
  return Object.keys(robotOptions).length === 0 && keys.every((key) => rest[key] === defaultProjectSettings[key]);
}

/** A checksum of a course that later versions of the course's file do not change. */
function sceneChecksum(scene: Scene): number {
  const out = new ColumnWriter();
  checkedScene.write(out, scene);
  const { figures, words } = out.bytes();
  return checksum(words, checksum(figures));
}
const checkedScene = sceneCodec(sharedCodecs());

/** FNV-1a, 32 bits: enough to tell chance damage, not meant against anybody. */
function checksum(bytes: Uint8Array, before = 0x811c9dc5): number {
  let sum = before;
  for (const byte of bytes) sum = Math.imul(sum ^ byte, 0x01000193);
  return sum >>> 0;
}
