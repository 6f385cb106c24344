/**
 * A course and its parts as columns of bytes (`columns.ts`), for links. The order in which the codecs are made is the
 * format: a change needs a new version of the link (`link.ts`). A test with a kept link checks that.
 */
import { fromBase64, toBase64 } from '#core/base64';
import {
  helps,
  sceneLimits,
  strokeColors,
  type Background,
  type Label,
  type Mover,
  type Point,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Stroke,
  type Task,
  type TaskCard,
  type TaskText,
  type Wall,
  type Zone,
} from '#scene/scene';

import { Columns, constant, mapped, record, type Codec } from './codec';
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

/** New types of objects go to the end. */
const objectTypes = [
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
] as const satisfies readonly SceneObject['type'][];

function objectCodec(columns: Columns, parts: Parts): Codec<SceneObject> {
  const type = columns.choice(objectTypes);
  const own = codecsByType(columns, parts);
  return {
    write(out, object) {
      type.write(out, object.type);
      own[object.type].write(out, object);
    },
    read: (from) => own[type.read(from)].read(from),
  };
}

/** Every type's codec, in the order in which the first version of links made them: that order is the format. */
function codecsByType(
  columns: Columns,
  { text, word, size, place, paths }: Parts,
): Readonly<Record<SceneObject['type'], Codec<SceneObject>>> {
  const id = idCodec(columns, word);
  const turn = columns.uint();
  const box = { id, at: place, size, turn };
  const zone = { ...box, round: columns.flag(), number: columns.uint(), blocks: columns.uint() };
  const codecs = {
    wall: record<Wall>({ type: constant('wall'), id, from: place, to: place, thickness: columns.uint() }),
    stroke: record<Stroke>({
      type: constant('stroke'),
      id,
      points: paths(columns, place),
      width: columns.uint(),
      color: columns.choice(strokeColors),
    }),
    mover: record<Mover>({
      type: constant('mover'),
      ...box,
      to: place,
      speed: columns.uint(),
      spiked: columns.flag(),
    }),
    label: record<Label>({ type: constant('label'), id, at: place, text, height: columns.uint(), turn }),
  };
  const zoneOf = (type: Zone['type']): Codec<Zone> => record<Zone>({ type: constant(type), ...zone });
  return {
    ...codecs,
    block: record({ type: constant('block'), ...box }),
    'fixed-block': record({ type: constant('fixed-block'), ...box }),
    spikes: record({ type: constant('spikes'), ...box }),
    target: zoneOf('target'),
    checkpoint: zoneOf('checkpoint'),
    forbidden: zoneOf('forbidden'),
  };
}

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

/** What version 3 of links adds to a task; in the versions before it, a task has none of it. */
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
