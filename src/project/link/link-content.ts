import { fnvOfBytes } from '#core/fnv';
import { additionsOf } from '#scene/additions';
import { tidied } from '#scene/groups';
import type { Scene, SceneObject, TaskRule } from '#scene/scene';

import { constant, mapped, record, type Codec } from './codec';
import { ColumnWriter } from './columns';
import { handCodec } from './hand-codec';
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
  sceneCodec,
  sharedCodecs,
  sharingCodec,
  startsCodec,
  taskExtrasCodec,
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
  /** What the task of a whole course has besides its rules; nothing before version 3. */
  readonly extras: TaskExtras;
  /** The settings' robot of one's own as JSON, checked like a file's; empty before version 4, and without one. */
  readonly myRobot: string;
  /** Several devices; `null` before version 5, and of a project that has one. */
  readonly devices: ProjectDevices | null;
  /** The starts of further robots in a whole course; none before version 6. */
  readonly starts: readonly PlacedStart[];
  /** How the robots share the task of a whole course; `null` before version 6. */
  readonly sharing: TaskRule | null;
  /** What is new of the objects of a whole course; nothing before version 7. */
  readonly additions: readonly PlacedAdditions[];
}

/** The content of a link, in the order of one version; it is the format (see `scene-codec.ts`). */
export interface ContentCodec {
  readonly codec: Codec<Content>;
  /** Number of columns. */
  readonly columns: number;
}

/** Version 1: for columns that are deflated. */
export const deflatedContent = contentCodec(pathCodec);

/** Version 2: for an adaptive model. */
export const modelledContent = contentCodec(handCodec);

/** Version 3: with the extras of a task, for either. */
export const deflatedTask = contentCodec(pathCodec, taskExtrasCodec);
export const modelledTask = contentCodec(handCodec, taskExtrasCodec);

/** Version 4: with a robot of one's own, too. */
export const deflatedRobot = contentCodec(pathCodec, taskExtrasCodec, jsonCodec);
export const modelledRobot = contentCodec(handCodec, taskExtrasCodec, jsonCodec);

/** Version 5: with several devices, too. */
export const deflatedDevices = contentCodec(pathCodec, taskExtrasCodec, jsonCodec, devicesCodec);
export const modelledDevices = contentCodec(handCodec, taskExtrasCodec, jsonCodec, devicesCodec);

/** Version 6: with starts of further robots and a task that they share, too. */
const withStarts = [taskExtrasCodec, jsonCodec, devicesCodec, startsCodec, sharingCodec] as const;
export const deflatedStarts = contentCodec(pathCodec, ...withStarts);
export const modelledStarts = contentCodec(handCodec, ...withStarts);

/** Version 7: with any angle, round bodies, polygons, locks and groups, too. */
export const deflatedShapes = contentCodec(pathCodec, ...withStarts, additionsCodec);
export const modelledShapes = contentCodec(handCodec, ...withStarts, additionsCodec);

function noStarts(): Codec<readonly PlacedStart[]> {
  return constant([]);
}

function noAdditions(): Codec<readonly PlacedAdditions[]> {
  return constant([]);
}

function noExtras(): Codec<TaskExtras> {
  return constant({});
}

function noRobot(): Codec<string> {
  return constant('');
}

function notShared(): Codec<null> {
  return constant(null);
}

function oneDevice(): Codec<null> {
  return constant(null);
}

function jsonCodec({ text }: SharedCodecs): Codec<string> {
  return text;
}

function contentCodec(
  paths: PathCodec,
  extrasCodec: (shared: SharedCodecs) => Codec<TaskExtras> = noExtras,
  robotCodec: (shared: SharedCodecs) => Codec<string> = noRobot,
  severalCodec: (shared: SharedCodecs) => Codec<ProjectDevices | null> = oneDevice,
  placesCodec: (shared: SharedCodecs) => Codec<readonly PlacedStart[]> = noStarts,
  rulesCodec: (shared: SharedCodecs) => Codec<TaskRule | null> = notShared,
  newCodec: (shared: SharedCodecs) => Codec<readonly PlacedAdditions[]> = noAdditions,
): ContentCodec {
  const shared = sharedCodecs();
  const { columns, word } = shared;
  const scene = linkSceneCodec(shared, paths);
  const codec = record<Content>({
    course: columns.optional(word),
    scene,
    settings: columns.optional(settingsCodec(shared)),
    files: filesCodec(shared),
    extras: extrasCodec(shared),
    myRobot: robotCodec(shared),
    devices: severalCodec(shared),
    starts: placesCodec(shared),
    sharing: rulesCodec(shared),
    additions: newCodec(shared),
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
  const { whole, starts, additions } = apart(scene);
  checkedScene.write(out, whole);
  const { figures, words } = out.bytes();
  const sum = fnvOfBytes(words, fnvOfBytes(figures));
  return [starts, additions].reduce((before, part) => (part.length === 0 ? before : fnvOfText(part, before)), sum);
}
const fnvOfText = (part: readonly unknown[], sum: number): number =>
  fnvOfBytes(new TextEncoder().encode(JSON.stringify(part)), sum);

const checkedScene = sceneCodec(sharedCodecs(), pathCodec);

/** A course as links have always had it, and what stands apart from it. */
export interface Apart {
  /** The course without its starts, and without what is new of the other objects. */
  readonly whole: Scene;
  readonly starts: readonly PlacedStart[];
  readonly additions: readonly PlacedAdditions[];
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
  return { whole: { ...scene, objects: objects.filter(({ type }) => type !== 'start') }, starts, additions };
}

/** The course put together again; unchecked as long as its parts are. */
export function joined({ whole, starts, additions }: Apart): Scene {
  const objects: SceneObject[] = [...whole.objects];
  for (const { place, ...start } of starts) objects.splice(place, 0, { type: 'start', ...start });
  for (const { place, ...said } of additions) {
    const object = objects[place];
    if (object) objects[place] = { ...object, ...said };
  }
  return { ...whole, objects };
}
