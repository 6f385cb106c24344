/** Standing tags that are stuck to what moves: a block that can be pushed, or a moving obstacle. They go along with it. */
import { degOf, rotationRad } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Pose } from '#core/geometry';
import { memoOf } from '#core/memo';
import type { Block, Mover, SceneObject, Tag } from '../scene';
import { outlineHolds, shapeOutline, toOwnFrame } from '../shape/shape';

/** The thing that carries a tag. */
export interface Carrier {
  readonly id: string;
  /** The tag in its frame. */
  readonly tag: Pose;
}

/** A block that is shown elsewhere than the course has it. */
export interface Shifted {
  /** The block of the course; left out: it is that one. */
  readonly lay?: Block;
}

/** A tag of the course with its carrier. */
export interface CarriedTag {
  readonly tag: Tag;
  readonly carrier: Carrier;
  /** The carrier's place before a run moves it, where that is not the one of the course; `null`: it is. */
  readonly shifted: Pose | null;
}

/** A tag may stand so far from its thing, in mm. Chosen: half of a thick wall, as cameras see it before what it is stuck to. */
export const STUCK_MM = 15;

const moves = (object: SceneObject): object is Block | Mover => object.type === 'block' || object.type === 'mover';

/** The carriers of the tags of a course, by the tag's id. Tags that lie on the floor have none. */
export const carriersOf = memoOf((objects: readonly SceneObject[]): ReadonlyMap<string, Carrier> => {
  const movable = objects.filter(moves);
  const found = new Map<string, Carrier>();
  for (const tag of objects) {
    if (tag.type !== 'tag' || tag.flat === true) continue;
    const at = { x: tag.at[0], y: tag.at[1] };
    const thing = movable.find((one) => outlineHolds(shapeOutline(one), at, STUCK_MM));
    if (thing === undefined) continue;
    const { x, y } = toOwnFrame(thing, at);
    found.set(tag.id, {
      id: thing.id,
      tag: { xMm: x, yMm: y, headingRad: rotationRad(tag.angle) - rotationRad(thing.angle) },
    });
  }
  return found;
});

/** The place of a carried tag while its carrier is there. */
export function carriedPose({ tag }: Carrier, { xMm, yMm, headingRad }: Pose): Pose {
  const [cos, sin] = [exactCos(headingRad), exactSin(headingRad)];
  return {
    xMm: xMm + tag.xMm * cos - tag.yMm * sin,
    yMm: yMm + tag.xMm * sin + tag.yMm * cos,
    headingRad: headingRad + tag.headingRad,
  };
}

/** The places of the carried tags of a course now, by their ids, from where the things are that have moved. */
export function movedTags(
  objects: readonly SceneObject[],
  moved: Readonly<Record<string, Pose>>,
): Readonly<Record<string, Pose>> {
  const poses: Record<string, Pose> = {};
  for (const [id, carrier] of carriersOf(objects)) {
    const pose = moved[carrier.id];
    if (pose !== undefined) poses[id] = carriedPose(carrier, pose);
  }
  return poses;
}

/** The places of the tags at blocks that are shown elsewhere than the course has them, by the tags' ids. */
export function shiftedTags(objects: readonly (SceneObject & Shifted)[]): Readonly<Record<string, Pose>> {
  const moved = shiftedBlocks(objects);
  return Object.keys(moved).length === 0 ? {} : movedTags(objects.map(asInCourse), moved);
}

const asInCourse = (object: SceneObject & Shifted): SceneObject => object.lay ?? object;

function shiftedBlocks(objects: readonly (SceneObject & Shifted)[]): Readonly<Record<string, Pose>> {
  const moved: Record<string, Pose> = {};
  for (const object of objects) {
    if (object.type !== 'block' || object.lay === undefined) continue;
    const { id, at, angle } = object;
    moved[id] = { xMm: at[0], yMm: at[1], headingRad: rotationRad(angle) };
  }
  return moved;
}

/** The tags on blocks and moving obstacles: they go as those go. */
export const carriedTags = memoOf((objects: readonly (SceneObject & Shifted)[]): readonly CarriedTag[] => {
  if (!objects.some(({ type }) => type === 'tag')) return [];
  const [carriers, shifted] = [carriersOf(objects.map(asInCourse)), shiftedBlocks(objects)];
  return objects.flatMap((tag) => {
    const carrier = tag.type === 'tag' ? carriers.get(tag.id) : undefined;
    if (tag.type !== 'tag' || carrier === undefined) return [];
    return [{ tag, carrier, shifted: shifted[carrier.id] ?? null }];
  });
});

/** A carried tag with its carrier at a pose; `null`: where that is before a run. */
export function tagAt({ tag, carrier, shifted }: CarriedTag, pose: Pose | null): Tag {
  const place = pose ?? shifted;
  return place === null ? tag : placedTag(tag, carriedPose(carrier, place));
}

/** A tag as one that lies at a pose. */
const placedTag = (tag: Tag, { xMm, yMm, headingRad }: Pose): Tag => ({
  ...tag,
  at: [xMm, yMm],
  angle: degOf(headingRad),
});
