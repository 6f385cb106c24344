/**
 * A course and its parts as columns of bytes (`columns.ts`), for links. The order in which the codecs are made is the
 * format: a change needs a new version of the link (`link.ts`). A test with a kept link checks that.
 */
import { fromBase64, toBase64 } from '#core/base64';
import { isEighth, type Additions } from '#scene/additions';
import type { NewObject } from '#scene/news';
import {
  helps,
  robotColors,
  sceneLimits,
  type Background,
  type Chase,
  type Label,
  type Mover,
  type Point,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Start,
  type Stroke,
  taskRules,
  type Task,
  type TaskRule,
  type TaskCard,
  type TaskText,
  type Wall,
  type Zone,
} from '#scene/scene';

import { Columns, constant, mapped, record, type Codec } from './codec';
import { strokeColor } from './stroke-color-codec';
import type { ValueReader, ValueWriter } from './value-port';

/** Codecs that several parts of a project share, and their columns. */
export interface SharedCodecs {
  readonly columns: Columns;
  readonly text: Codec<string>;
  readonly word: Codec<string>;
  readonly options: Codec<Readonly<Record<string, string>>>;
}

export function sharedCodecs(): SharedCodecs {
  const columns = new Columns();
  const text = columns.text();
  const word = columns.word(text);
  return { columns, text, word, options: dictionary(columns, word, word, sceneLimits.options) };
}

/** An object from names to values, in its order. */
export function dictionary<T>(
  columns: Columns,
  key: Codec<string>,
  value: Codec<T>,
  max: number,
): Codec<Readonly<Record<string, T>>> {
  const entry: Codec<readonly [string, T]> = {
    write(out, [name, it]) {
      key.write(out, name);
      value.write(out, it);
    },
    read: (from) => [key.read(from), value.read(from)],
  };
  return mapped(columns.list(entry, max), (it) => Object.entries(it), Object.fromEntries<T>);
}

/** Makes the codec for the points of a line from the codec of its first point; it differs between versions of links. */
export type PathCodec = (columns: Columns, start: Codec<Point>) => Codec<readonly Point[]>;

/** The codec of a course. */
export function sceneCodec({ columns, text, word, options }: SharedCodecs, paths: PathCodec): Codec<Scene> {
  const size = pairOf(columns.uint(), columns.uint());
  const place = pairOf(columns.coordinate(), columns.coordinate());
  const heading = columns.number();
  const robot = record<RobotStart>({
    type: columns.optional(word),
    at: place,
    heading,
    scale: columns.number(),
    options,
  });
  const task = record<Task>({ seconds: columns.optional(columns.number()), noTouch: columns.flag() });
  const background = record<Background>({
    at: place,
    size,
    cells: pairOf(columns.uint(), columns.uint()),
    levels: base64Codec(columns, text),
    picture: pictureCodec(columns, text),
  });
  return record<Scene>({
    name: text,
    description: text,
    size,
    board: columns.optional(word),
    robot,
    task,
    background: columns.optional(background),
    objects: columns.list(objectCodec(columns, { text, word, size, place, paths }), sceneLimits.objects),
  });
}

interface Parts {
  readonly text: Codec<string>;
  readonly word: Codec<string>;
  readonly size: Codec<Point>;
  readonly place: Codec<Point>;
  readonly paths: PathCodec;
}

/**
 * An object that has been in links from the first on; starts (`startsCodec`) and newer kinds (`news-codec.ts`) stand
 * apart.
 */
type LinkObject = Exclude<SceneObject, Start | NewObject>;

/** The numbers of the kinds of objects in a link: their places here. */
export const linkOrder: LinkObject['type'][] = [
  'wall',
  'block',
  'fixed-block',
  'stroke',
  'target',
  'checkpoint',
  'forbidden',
  'spikes',
  'mover',
  'label',
];

/** The codecs that several kinds share. */
export interface SharedByKinds {
  readonly columns: Columns;
  readonly id: Codec<string>;
  readonly place: Codec<Point>;
  readonly size: Codec<Point>;
  readonly angle: Codec<number>;
  readonly text: Codec<string>;
  readonly paths: PathCodec;
  readonly zone: Readonly<Pick<Fields<Zone>, 'round' | 'number' | 'blocks'>>;
}
type Fields<T> = { readonly [K in keyof T]-?: Codec<T[K]> };
type LinkKind = (shared: SharedByKinds) => Codec<LinkObject>;

const boxOf = ({ id, place, size, angle }: SharedByKinds) => ({ id, at: place, size, angle });
const zoneOf =
  (type: Zone['type']): LinkKind =>
  (shared) =>
    record<Zone>({ type: constant(type), ...boxOf(shared), ...shared.zone });

/**
 * Every kind's codec. They are made in this order, that of the first version of links: the order in which they make
 * their columns is the format.
 */
export const linkKinds: Readonly<Record<LinkObject['type'], LinkKind>> = {
  wall: ({ columns, id, place }) =>
    record<Wall>({ type: constant('wall'), id, from: place, to: place, thickness: columns.uint() }),
  stroke: ({ columns, id, place, paths }) =>
    record<Stroke>({
      type: constant('stroke'),
      id,
      points: paths(columns, place),
      width: columns.uint(),
      color: strokeColor(columns),
    }),
  mover: (shared) =>
    record<Mover>({
      type: constant('mover'),
      ...boxOf(shared),
      to: shared.place,
      speed: shared.columns.uint(),
      spiked: shared.columns.flag(),
    }),
  label: ({ columns, id, place, text, angle }) =>
    record<Label>({ type: constant('label'), id, at: place, text, height: columns.uint(), angle }),
  block: (shared) => record({ type: constant('block'), ...boxOf(shared) }),
  'fixed-block': (shared) => record({ type: constant('fixed-block'), ...boxOf(shared) }),
  spikes: (shared) => record({ type: constant('spikes'), ...boxOf(shared) }),
  target: zoneOf('target'),
  checkpoint: zoneOf('checkpoint'),
  forbidden: zoneOf('forbidden'),
};

function objectCodec(columns: Columns, { word, ...parts }: Parts): Codec<SceneObject> {
  const type = columns.choice(linkOrder);
  const id = idCodec(columns, word);
  // Eighths of a full turn; other angles stand apart (`additionsCodec`).
  const angle = mapped(
    columns.uint(),
    (deg: number) => (isEighth(deg) ? deg / 45 : 0),
    (eighths) => 45 * eighths,
  );
  const zone = { round: columns.flag(), number: columns.uint(), blocks: columns.uint() };
  const shared: SharedByKinds = { columns, id, angle, zone, ...parts };
  const own = Object.fromEntries(Object.entries(linkKinds).map(([name, codec]) => [name, codec(shared)]));
  const codecOf = (name: SceneObject['type']): Codec<SceneObject> => {
    const codec = own[name];
    if (codec === undefined) throw new Error(`Links have no ${name}.`);
    return codec;
  };
  return {
    write(out, object) {
      if (!isLinkObject(object)) throw new Error(`Objects of the kind ${object.type} stand apart in a link.`);
      type.write(out, object.type);
      codecOf(object.type).write(out, object);
    },
    read: (from) => codecOf(type.read(from)).read(from),
  };
}

/** True if an object has its place among those of the first links. */
export const isLinkObject = (object: SceneObject): object is LinkObject =>
  linkOrder.some((type) => type === object.type);

function pairOf(x: Codec<number>, y: Codec<number>): Codec<Point> {
  return {
    write(out, point) {
      x.write(out, point[0]);
      y.write(out, point[1]);
    },
    read: (from) => [x.read(from), y.read(from)],
  };
}

/** An id such as `wall-12`: the word before the number, then the number as its step from the expected one. */
function idCodec(columns: Columns, word: Codec<string>): Codec<string> {
  const step = columns.uint();
  const numbers = new WeakMap<ValueWriter | ValueReader, Map<string, number>>();
  const nextOf = (of: ValueWriter | ValueReader): Map<string, number> => {
    const known = numbers.get(of) ?? new Map<string, number>();
    numbers.set(of, known);
    return known;
  };
  return {
    write(out, id) {
      const [, prefix = id, digits] = /^([^]*?)(0|[1-9]\d{0,8})$/.exec(id) ?? [];
      word.write(out, prefix);
      const expected = nextOf(out).get(prefix) ?? 1;
      const difference = Number(digits ?? 0) - expected;
      step.write(out, digits === undefined ? 0 : 1 + (difference < 0 ? -2 * difference - 1 : 2 * difference));
      if (digits !== undefined) nextOf(out).set(prefix, Number(digits) + 1);
    },
    read(from) {
      const prefix = word.read(from);
      const code = step.read(from);
      if (code === 0) return prefix;
      const difference = code % 2 === 1 ? (code - 1) / 2 : -code / 2;
      const number = (nextOf(from).get(prefix) ?? 1) + difference;
      nextOf(from).set(prefix, number + 1);
      return `${prefix}${String(number)}`;
    },
  };
}

/** Base64 as its bytes if they give the same text again, otherwise as text. */
function base64Codec(columns: Columns, text: Codec<string>): Codec<string> {
  const isBytes = columns.flag();
  const bytes = columns.bytes();
  return {
    write(out, value) {
      const decoded = fromBase64(value);
      const fits = decoded !== null && toBase64(decoded) === value;
      isBytes.write(out, fits);
      if (fits) bytes.write(out, decoded);
      else text.write(out, value);
    },
    read: (from) => (isBytes.read(from) ? toBase64(bytes.read(from)) : text.read(from)),
  };
}

/** A start of a further robot, and its place among the objects of its course. */
export type PlacedStart = Omit<Start, 'type'> & { readonly place: number };

/** The codec of the starts of further robots, which version 6 of links adds to a course. */
export function startsCodec({ columns, text, word, options }: SharedCodecs): Codec<readonly PlacedStart[]> {
  const start = record<PlacedStart>({
    place: columns.uint(),
    id: word,
    at: pairOf(columns.coordinate(), columns.coordinate()),
    heading: columns.number(),
    robot: columns.optional(word),
    options,
    name: text,
    color: columns.optional(columns.choice(robotColors)),
  });
  return columns.list(start, sceneLimits.objects);
}

/** The additions of link version 7 to an object, and the object's place in its course. */
export type PlacedAdditions = Additions & { readonly place: number };

/** The codec of what version 7 of links adds to the objects of a course. */
export function additionsCodec({ columns, word }: SharedCodecs): Codec<readonly PlacedAdditions[]> {
  const corner = pairOf(columns.int(), columns.int());
  const stop = pairOf(columns.coordinate(), columns.coordinate());
  const chase = mapped(
    record<ChaseOrNull>({ zone: columns.optional(word), reach: columns.optional(columns.uint()) }),
    ({ zone, reach }: Chase) => ({ zone: zone ?? null, reach: reach ?? null }),
    (said): Chase => withoutNulls<Chase>(said),
  );
  const said = record<Required<SaidOrNull>>({
    angle: columns.optional(columns.number()),
    round: columns.optional(constant(true)),
    corners: columns.optional(columns.list(corner, sceneLimits.corners.max)),
    lock: columns.optional(constant(true)),
    group: columns.optional(word),
    stops: columns.optional(columns.list(stop, sceneLimits.stops)),
    waits: columns.optional(columns.list(columns.number(), sceneLimits.stops)),
    loops: columns.optional(constant(true)),
    phase: columns.optional(columns.number()),
    spin: columns.optional(columns.int()),
    chases: columns.optional(chase),
  });
  const place = columns.uint();
  const placed: Codec<PlacedAdditions> = {
    write(out, { place: at, ...given }) {
      place.write(out, at);
      said.write(out, { ...NOTHING_SAID, ...given });
    },
    read: (from) => ({ place: place.read(from), ...withoutNulls(said.read(from)) }),
  };
  return columns.list(placed, sceneLimits.objects);
}

/** Additions with `null` for those that are left out. */
type SaidOrNull = { readonly [K in keyof Additions]: Additions[K] | null };

/** A chase in the same manner. */
type ChaseOrNull = { readonly [K in keyof Required<Chase>]: NonNullable<Chase[K]> | null };

const NOTHING_SAID: Required<SaidOrNull> = {
  ...{ angle: null, round: null, corners: null, lock: null, group: null },
  ...{ stops: null, waits: null, loops: null, phase: null, spin: null, chases: null },
};

function withoutNulls<T>(said: { readonly [K in keyof T]: T[K] | null }): T {
  return Object.fromEntries(Object.entries(said).filter(([, value]) => value !== null)) as T;
}

/** The additions of link version 8: name and colour of the first robot. */
export type FirstRobot = Required<Pick<RobotStart, 'name' | 'color'>>;

/** The codec of the first robot's name and colour; `null`: it has neither. */
export function firstRobotCodec({ columns, text }: SharedCodecs): Codec<FirstRobot | null> {
  const color = columns.optional(columns.choice(robotColors));
  return columns.optional(record<FirstRobot>({ name: text, color }));
}

/** The codec of how robots share a task, which version 6 of links adds, too. */
export function sharingCodec({ columns }: SharedCodecs): Codec<TaskRule | null> {
  return columns.optional(columns.choice(taskRules));
}

/** The additions of link version 3 to a task; in earlier versions a task has none of them. */
export type TaskExtras = Pick<Task, 'allows' | 'stars' | 'card'>;

/** The codec of what a task has besides its rules. */
export function taskExtrasCodec({ columns, text, word }: SharedCodecs): Codec<TaskExtras> {
  const hints = columns.list(text, sceneLimits.hints);
  const translation = record<TaskText>({ language: word, title: text, text, hints });
  const extras = record<{ readonly [K in keyof Required<TaskExtras>]: NonNullable<TaskExtras[K]> | null }>({
    allows: columns.optional(columns.list(columns.choice(helps), helps.length)),
    stars: columns.optional(pairOf(columns.number(), columns.number())),
    card: columns.optional(
      record<TaskCard>({
        language: word,
        title: text,
        hints,
        translations: columns.list(translation, sceneLimits.translations),
        picture: pictureCodec(columns, text),
        solution: columns.flag(),
      }),
    ),
  });
  return mapped(
    extras,
    ({ allows = null, stars = null, card = null }) => ({ allows, stars, card }),
    ({ allows, stars, card }) => ({
      ...(allows === null ? {} : { allows }),
      ...(stars === null ? {} : { stars }),
      ...(card === null ? {} : { card }),
    }),
  );
}

/** `data:image/png;base64,…`: the part before the comma as text, the rest as base64. Empty: no picture. */
function pictureCodec(columns: Columns, text: Codec<string>): Codec<string> {
  const data = base64Codec(columns, text);
  return {
    write(out, value) {
      const comma = value.indexOf(',') + 1;
      text.write(out, value.slice(0, comma));
      data.write(out, value.slice(comma));
    },
    read: (from) => text.read(from) + data.read(from),
  };
}
