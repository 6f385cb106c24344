import { fnvOfBytes } from '#core/fnv';
import { additionsOf } from '#scene/additions';
import { tidied } from '#scene/groups';
import { ownHeightOf } from '#scene/kinds/heights';
import type { Scene, SceneObject, TaskRule } from '#scene/scene';

import { constant, mapped, record, type Codec } from './codec';
import { ColumnWriter } from './columns';
import { handCodec } from './hand-codec';
import { newsTextOf, type News, type PlacedNews } from './news-codec';
import { heightsCodec, type PlacedHeight } from './heights-codec';
import { pathCodec } from './path-codec';
import { MOST_DEVICES } from '../devices';
import {
  defaultProjectSettings,
  projectLimits,
  type FurtherDevice,
  type ProjectDevices,
  type ProjectSettings,
  type SourceFile,
} from '../project';
import {
  additionsCodec,
  dictionary,
  firstRobotCodec,
  isLinkObject,
  sceneCodec,
  sharedCodecs,
  sharingCodec,
  startsCodec,
  taskExtrasCodec,
  type FirstRobot,
  type PathCodec,
  type PlacedAdditions,
  type PlacedStart,
  type SharedCodecs,
  type TaskExtras,
} from './scene-codec';

/** The course in a link: the whole course without its starts, or the ready course of the project's `course` with its checksum. */
export type LinkScene = { readonly ready: number } | { readonly whole: Scene };

/** The settings in a link; the robot of one's own stands apart. */
type LinkSettings = Omit<ProjectSettings, 'myRobot'>;

/** The content of a link. */
export interface Content {
  readonly files: readonly SourceFile[];
  readonly course: string | null;
  readonly settings: LinkSettings | null;
  readonly scene: LinkScene;
  /** The properties of a whole course's task besides its rules; empty before version 3. */
  readonly extras: TaskExtras;
  /** The settings' robot of one's own as JSON, checked like a file's; empty before version 4, and without one. */
  readonly myRobot: string;
  /** Several devices; `null` before version 5, and of a project that has one. */
  readonly devices: ProjectDevices | null;
  /** The starts of further robots in a whole course; none before version 6. */
  readonly starts: readonly PlacedStart[];
  /** How the robots share the task of a whole course; `null` before version 6. */
  readonly sharing: TaskRule | null;
  /** The new properties of the objects of a whole course; empty before version 7. */
  readonly additions: readonly PlacedAdditions[];
  /** Name and colour of the first robot in a whole course; `null` before version 8, and without. */
  readonly firstRobot: FirstRobot | null;
  /** Task and hand-in as JSON, checked like a file's; empty before version 9, and without both. */
  readonly carried: string;
  /** The heights that objects of a whole course have of their own; empty before version 10. */
  readonly heights: readonly PlacedHeight[];
  /** The properties of a whole course that version 11 brought (`news-codec.ts`), as JSON; empty before, and without. */
  readonly news: string;
}

/** The content of a link, in the order of one version; it is the format (see `scene-codec.ts`). */
export interface ContentCodec {
  readonly codec: Codec<Content>;
  /** Number of columns. */
  readonly columns: number;
}

/** The parts of the content of a version; missing ones have their old meaning. */
interface Parts {
  readonly extras?: (shared: SharedCodecs) => Codec<TaskExtras>;
  readonly myRobot?: (shared: SharedCodecs) => Codec<string>;
  readonly devices?: (shared: SharedCodecs) => Codec<ProjectDevices | null>;
  readonly starts?: (shared: SharedCodecs) => Codec<readonly PlacedStart[]>;
  readonly sharing?: (shared: SharedCodecs) => Codec<TaskRule | null>;
  readonly additions?: (shared: SharedCodecs) => Codec<readonly PlacedAdditions[]>;
  readonly firstRobot?: (shared: SharedCodecs) => Codec<FirstRobot | null>;
  readonly carried?: (shared: SharedCodecs) => Codec<string>;
  readonly heights?: (shared: SharedCodecs) => Codec<readonly PlacedHeight[]>;
  readonly news?: (shared: SharedCodecs) => Codec<string>;
}

/** Version 1: for columns that are deflated. */
export const deflatedContent = contentCodec(pathCodec, {});

/** Version 2: for an adaptive model. */
export const modelledContent = contentCodec(handCodec, {});

/** The two ways to pack content: deflated columns, and a model for what is not too large for it. */
export interface Packing {
  readonly deflated: ContentCodec;
  readonly modelled: ContentCodec;
}

const task: Parts = { extras: taskExtrasCodec };
const robot: Parts = { ...task, myRobot: jsonCodec };
const several: Parts = { ...robot, devices: devicesCodec };
const places: Parts = { ...several, starts: startsCodec, sharing: sharingCodec };
const shapes: Parts = { ...places, additions: additionsCodec };
const names: Parts = { ...shapes, firstRobot: firstRobotCodec };
const forClass: Parts = { ...names, carried: jsonCodec };
const heights: Parts = { ...forClass, heights: heightsCodec };
const news: Parts = { ...heights, news: jsonCodec };

/** The versions that add something to the first two, each to the one before. */
export const laterVersions = {
  3: bothWays(task),
  4: bothWays(robot),
  5: bothWays(several),
  6: bothWays(places),
  7: bothWays(shapes),
  8: bothWays(names),
  9: bothWays(forClass),
  10: bothWays(heights),
  11: bothWays(news),
} as const;

function bothWays(parts: Parts): Packing {
  return { deflated: contentCodec(pathCodec, parts), modelled: contentCodec(handCodec, parts) };
}

function jsonCodec({ text }: SharedCodecs): Codec<string> {
  return text;
}

function contentCodec(paths: PathCodec, parts: Parts): ContentCodec {
  const shared = sharedCodecs();
  const { columns, word } = shared;
  const scene = linkSceneCodec(shared, paths);
  const codec = record<Content>({
    course: columns.optional(word),
    scene,
    settings: columns.optional(settingsCodec(shared)),
    files: filesCodec(shared),
    extras: parts.extras?.(shared) ?? constant({}),
    myRobot: parts.myRobot?.(shared) ?? constant(''),
    devices: parts.devices?.(shared) ?? constant(null),
    starts: parts.starts?.(shared) ?? constant([]),
    sharing: parts.sharing?.(shared) ?? constant(null),
    additions: parts.additions?.(shared) ?? constant([]),
    firstRobot: parts.firstRobot?.(shared) ?? constant(null),
    carried: parts.carried?.(shared) ?? constant(''),
    heights: parts.heights?.(shared) ?? constant([]),
    news: parts.news?.(shared) ?? constant(''),
  });
  return { codec, columns: columns.used };
}

function filesCodec({ columns, word, text }: SharedCodecs): Codec<readonly SourceFile[]> {
  return columns.list(record<SourceFile>({ name: word, text }), projectLimits.files);
}

function devicesCodec(shared: SharedCodecs): Codec<ProjectDevices | null> {
  const { columns, word, text, options } = shared;
  const device = record<FurtherDevice>({
    name: text,
    device: word,
    firmware: word,
    robot: word,
    robotOptions: dictionary(columns, word, options, projectLimits.options),
    sameAs: text,
    files: filesCodec(shared),
  });
  return columns.optional(record<ProjectDevices>({ first: text, others: columns.list(device, MOST_DEVICES - 1) }));
}

function linkSceneCodec(shared: SharedCodecs, paths: PathCodec): Codec<LinkScene> {
  const isReady = shared.columns.flag();
  const sum = shared.columns.uint();
  const scene = sceneCodec(shared, paths);
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
function settingsCodec({ columns, word, options }: SharedCodecs): Codec<LinkSettings> {
  const chosen = record<LinkSettings>({
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

function isUsual(settings: LinkSettings): boolean {
  const { robotOptions, ...rest } = settings;
  const keys = Object.keys(rest) as (keyof typeof rest)[];
  return Object.keys(robotOptions).length === 0 && keys.every((key) => rest[key] === defaultProjectSettings[key]);
}

/** A checksum of a course that later versions of links and of the course's file do not change. */
export function sceneChecksum(scene: Scene): number {
  const out = new ColumnWriter();
  const { whole, starts, additions, firstRobot, heights, news } = apart(scene);
  checkedScene.write(out, whole);
  const { figures, words } = out.bytes();
  const sum = fnvOfBytes(words, fnvOfBytes(figures));
  const parts = [starts, additions, firstRobot === null ? [] : [firstRobot], heights, news === '' ? [] : [news]];
  return parts.reduce((before, part) => (part.length === 0 ? before : fnvOfText(part, before)), sum);
}
const fnvOfText = (part: readonly unknown[], sum: number): number =>
  fnvOfBytes(new TextEncoder().encode(JSON.stringify(part)), sum);

const checkedScene = sceneCodec(sharedCodecs(), pathCodec);

/** A course as links have always had it, and what stands apart from it. */
export interface Apart {
  /** The course without its starts and the objects of new kinds, and without what is new of the other objects. */
  readonly whole: Scene;
  readonly starts: readonly PlacedStart[];
  readonly additions: readonly PlacedAdditions[];
  readonly firstRobot: FirstRobot | null;
  readonly heights: readonly PlacedHeight[];
  readonly news: string;
}

/** Takes a course apart. */
export function apart(scene: Scene): Apart {
  const objects = tidied(scene.objects);
  const starts = objects.flatMap((object, place): PlacedStart[] => {
    if (object.type !== 'start') return [];
    const { id, at, heading, robot, options, name, color } = object;
    return [{ place, id, at, heading, robot, options, name, color }];
  });
  const additions = objects.flatMap((object, place): PlacedAdditions[] => {
    const said = additionsOf(object);
    return Object.keys(said).length === 0 ? [] : [{ place, ...said }];
  });
  const heights = objects.flatMap((object, place): PlacedHeight[] => {
    const height = ownHeightOf(object);
    return height === null ? [] : [{ place, height }];
  });
  const { name = '', color = null, ...robot } = scene.robot;
  const firstRobot = name === '' && color === null ? null : { name, color };
  const whole = { ...scene, robot, objects: objects.filter(isLinkObject) };
  return { whole, starts, additions, firstRobot, heights, news: newsTextOf(scene, objects) };
}

/** The course put together again; unchecked as long as its parts are. `news`: what its text says. */
export function putTogether({ whole, starts, additions, firstRobot, heights }: Omit<Apart, 'news'>, news: News): Scene {
  const objects: SceneObject[] = [...whole.objects];
  const placed = [
    ...starts.map(({ place, ...start }) => ({ place, object: { type: 'start', ...start } as const })),
    ...news.objects.filter(isWhole).map(({ place, said }) => ({ place, object: said as unknown as SceneObject })),
  ].sort((one, other) => one.place - other.place);
  for (const { place, object } of placed) objects.splice(place, 0, object);
  const changes = [...additions, ...heights, ...news.objects.filter((entry) => !isWhole(entry)).map(flat)];
  for (const { place, ...said } of changes) {
    const object = objects[place];
    if (object) objects[place] = { ...object, ...said };
  }
  return { ...whole, ...news.course, robot: { ...whole.robot, ...firstRobot }, objects };
}

/** True if the news of an object are all of it: its kind is new. */
const isWhole = ({ said }: PlacedNews): boolean => 'type' in said;

const flat = ({ place, said }: PlacedNews): { readonly place: number } => ({ ...said, place });
