import type { Pose, Vec } from '#core/geometry';
import { ownHeightOf } from '#scene/kinds/heights';
import type { Scene, SceneObject } from '#scene/scene';
import { lengthOf, type Outline } from '#scene/outline';

import kindNames from '../../course/editor/words/kinds';
import { namesOf } from '../../course/editor/words/object-words';
import { valueText } from '../../course/editor/words/value-text';
import { shownLanguage, t } from '../../kit/i18n';
import { numberText } from '../../kit/i18n/number-text';
import { metAlong } from './met-along';
import narrationWords from './words';
import { poseText } from './sentences';
import { fromRobot, isOn, nearestOfLine, partsNow, vecOf } from './solids';

const words = narrationWords.explore;

/** The question: a course as it is now, and the place to describe it from. */
export interface Asked {
  readonly scene: Scene;
  /** Poses of blocks and moving obstacles, by their id; missing ones are where the course has them. */
  readonly moved: Readonly<Record<string, Pose>>;
  /** The robot, or `null` where there is none. */
  readonly robot: Pose | null;
  /** The convex parts of the robot's body in its frame, at its size. */
  readonly body: readonly Outline[];
  /** The crosshair of the keyboard, world mm, while it shows: then everything is described from there; else `null`. */
  readonly crosshair: Vec | null;
}

/** An answer, and where in the arena (world mm) the thing is. */
export interface Told {
  readonly words: string;
  readonly atMm: Vec;
}

/** Walks through what lies in a course. */
export interface Explorer {
  /** Describes the next thing, or the one before. The first one is the robot, and so is the one after the last. */
  step(asked: Asked, back: boolean): Told;
}

/** The order of the kinds: what is to be done, what leads there, what is in the way. */
const ORDER: readonly SceneObject['type'][] = [
  ...(['checkpoint', 'target', 'stroke', 'wall', 'block', 'fixed-block', 'mover', 'spikes', 'forbidden', 'paper', 'lamp', 'barrier', 'tunnel', 'tag', 'label'] as const),
  'start',
]; // prettier-ignore

export function createExplorer(): Explorer {
  /** The last announced object; `undefined`: none yet, `null`: the robot. */
  let last: string | null | undefined;
  return {
    step(asked, back) {
      const things = [null, ...inOrder(asked.scene).map(({ id }) => id)];
      const from = last === undefined ? (back ? 0 : -1) : things.indexOf(last);
      const at = last !== undefined && from < 0 ? 0 : (from + (back ? -1 : 1) + things.length) % things.length;
      last = things[at] ?? null;
      const object = asked.scene.objects.find(({ id }) => id === last);
      return object === undefined ? tellAll(asked) : tellThing(object, asked);
    },
  };
}

/**
 * The objects by kind, as `ORDER` has it; checkpoints by their numbers, the others of a kind in the order of the
 * course.
 */
export function inOrder({ objects }: Scene): readonly SceneObject[] {
  const number = (object: SceneObject): number => (object.type === 'checkpoint' ? object.number : 0);
  return [...objects].sort((a, b) => ORDER.indexOf(a.type) - ORDER.indexOf(b.type) || number(a) - number(b));
}

/** Announces the present place, and the number of things in the course. */
function tellAll(asked: Asked): Told {
  const count = asked.scene.objects.length;
  const things = count === 1 ? t(words.one) : t(words.many, { count });
  return { words: `${placeText(asked)} ${count === 0 ? t(words.none) : things}`, atMm: originOf(asked) };
}

/** Describes a thing: its name, its size, its height if it is no usual one, and its place. */
function tellThing(object: SceneObject, asked: Asked): Told {
  const origin = originOf(asked);
  const name = namesOf(asked.scene).get(object.id) ?? t(kindNames[object.type].one);
  if (object.type === 'wall' || object.type === 'barrier' || object.type === 'stroke') {
    const points = object.type === 'stroke' ? object.points : [object.from, object.to];
    const line = points.map(([x, y]) => ({ x, y }));
    const atMm = nearestOfLine(line, origin);
    const look = object.type === 'stroke' ? `${valueText(object.color)}, ` : '';
    const size = t(words.long, { cm: cm(lengthOfLine(line)) });
    return {
      words: `${name}, ${look}${size}${highText(object)}; ${t(words.nearest, { where: whereText(atMm, asked) })}.`,
      atMm,
    };
  }
  const pose = asked.moved[object.id];
  const atMm = pose === undefined ? { x: object.at[0], y: object.at[1] } : vecOf(pose);
  const size = !('size' in object) ? '' : `, ${t(words.size, { x: cm(object.size[0]), y: cm(object.size[1]) })}`;
  return { words: `${name}${size}${highText(object)}: ${whereText(atMm, asked)}.`, atMm };
}

/** To the mm: sensors may look over a thing or not. */
function highText(object: SceneObject): string {
  const mm = ownHeightOf(object);
  return mm === null ? '' : `, ${t(words.high, { cm: numberText(mm / 10, shownLanguage()) })}`;
}

/** Announces the present place, the ground there and the next thing in each direction. */
export function tellAround(asked: Asked): Told {
  const { scene, moved, robot, body, crosshair } = asked;
  const at = originOf(asked);
  const names = namesOf(scene);
  const under = inOrder(scene).filter((object) => partsNow(object, moved).length === 0 && isOn(object, at));
  const onText = under.length === 0 ? [] : [t(words.on, { names: under.map(({ id }) => names.get(id) ?? '').join(', ') })]; // prettier-ignore
  const isRobot = crosshair === null && robot !== null;
  const sides = isRobot ? (['front', 'left', 'back', 'right'] as const) : (['east', 'north', 'west', 'south'] as const);
  const met = sides.map((side, quarter) => {
    const headingRad = (isRobot ? robot.headingRad : 0) + (quarter * Math.PI) / 2;
    const pose = { xMm: at.x, yMm: at.y, headingRad };
    const { id, mm } = metAlong({ pose, scene, moved, body: isRobot ? body : [], quarter });
    const thing = id === null ? t(narrationWords.edge) : (names.get(id) ?? '');
    return t(words.met[side], { thing, cm: cm(mm) });
  });
  return { words: [placeText(asked), ...onText, ...met].join(' '), atMm: at };
}

/** The place from which everything is described: the crosshair, else the robot, else the middle of the arena. */
const originOf = ({ crosshair, robot, scene }: Asked): Vec =>
  crosshair ?? (robot === null ? { x: scene.size[0] / 2, y: scene.size[1] / 2 } : vecOf(robot));

function placeText(asked: Asked): string {
  if (asked.crosshair === null && asked.robot !== null) return poseText('here', asked.robot);
  const { x, y } = originOf(asked);
  return t(asked.crosshair === null ? words.middle : words.crosshair, { x: cm(x), y: cm(y) });
}

/**
 * A place in words: ahead and to the side of the robot; from the crosshair or without a robot by the points of the
 * compass.
 */
function whereText(at: Vec, asked: Asked): string {
  const { robot, crosshair } = asked;
  const origin = originOf(asked);
  const isRobot = crosshair === null && robot !== null;
  const { x, y } = isRobot ? fromRobot(robot, at) : { x: at.x - origin.x, y: at.y - origin.y };
  const along = isRobot ? ([words.front, words.back] as const) : ([words.east, words.west] as const);
  const across = isRobot ? ([words.left, words.right] as const) : ([words.north, words.south] as const);
  const parts = [part(x, along), part(y, across)].filter((it) => it !== null);
  return parts.length === 0 ? t(words.here) : parts.join(', ');
}

/** Nearer than half a cm is no distance. */
function part(mm: number, [ahead, behind]: readonly [typeof words.front, typeof words.front]): string | null {
  return cm(Math.abs(mm)) === 0 ? null : t(mm > 0 ? ahead : behind, { cm: cm(Math.abs(mm)) });
}

const lengthOfLine = (line: readonly Vec[]): number =>
  line.reduce((mm, to, i) => mm + lengthOf(to.x - (line[i - 1] ?? to).x, to.y - (line[i - 1] ?? to).y), 0);

const cm = (mm: number): number => Math.round(mm / 10);
