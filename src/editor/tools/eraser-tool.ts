import type { Vec } from '#core/geometry';
import type { Replacement, SceneEdit } from '#scene/edit';
import { eraserAlong, erased, type Eraser } from '#scene/erase';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, type Bounds } from '#scene/outline';
import type { Scene, SceneObject, Stroke } from '#scene/scene';
import { simplified } from '#scene/simplify';
import { grown } from '../bounds';
import { endOf, isTap, startOf } from '../drag';
import { combined, removing, replacing, roomIn } from '../edits';
import { freeIds } from '../ids';
import { meets } from '../kinds/index';
import { comesNear, strokeLengthMm } from '../kinds/stroke';
import { toVec } from '../plane';
import { alongPath } from './path-fold';
import { thingsAt } from '../selection';
import type { Drag, Mark, Tool, ToolContext } from './tool';

/** Cuts strokes where it passes, and takes away all else that it passes over, unless only lines are wanted; what is locked stays. */
export const eraserTool: Tool = {
  id: 'eraser',
  cursor: 'cell',
  edit(drag, context): SceneEdit | null {
    const gone = thingsUnder(drag, context);
    return isOnThing(drag, gone) ? removing(gone.map(({ id }) => id)) : wiped(drag, context, gone);
  },
  marks(drag, context): readonly Mark[] {
    const gone = thingsUnder(drag, context);
    const outlines = gone.map((object): Mark => ({ type: 'goes', object }));
    if (isOnThing(drag, gone)) return outlines;
    return [...outlines, { type: 'eraser', at: endOf(drag), radiusMm: context.options.eraserWidth / 2 }];
  },
};

/** True for a tap on a thing, which takes just that: the line below it stays whole. */
const isOnThing = (drag: Drag, gone: readonly SceneObject[]): boolean => isTap(drag) && gone.length > 0;

/** The rests of the strokes that were cut, by the id of the whole stroke. */
type Cuts = ReadonlyMap<string, readonly Stroke[]>;

/** The eraser's path is processed in pieces, so that a long one costs no more per move than a short one. */
const cutsAlong = alongPath<Cuts>({
  block: 32, // chosen: a quarter to half a second of a pointer; cuts are rounded to whole mm so rarely that none is seen
  start: () => new Map(),
  after: (cuts, places, _drag, { scene, options }) => {
    const radiusMm = options.eraserWidth / 2;
    const eraser = eraserAlong(fewer(places), radiusMm);
    const around = grown(boundsOfOutline(places), radiusMm);
    const next = new Map(cuts);
    for (const object of scene.objects) {
      if (object.type !== 'stroke' || object.lock || !boundsMeet(boundsOf(object), around)) continue;
      const before = cuts.get(object.id) ?? [object];
      const after = before.flatMap((piece) => piecesLeft(piece, eraser, around));
      if (after.length !== before.length || after.some((piece, index) => piece !== before[index]))
        next.set(object.id, after);
    }
    return next;
  },
});

/** A path with fewer places, nowhere farther off than the rounding and `BESIDE_MM`. */
const fewer = (places: readonly Vec[]): readonly Vec[] => simplified(places, BESIDE_MM).map(toVec);

const BESIDE_MM = 0.5; // chosen: less than what is rounded

function piecesLeft(piece: Stroke, eraser: Eraser, around: Bounds): readonly Stroke[] {
  if (!boundsMeet(boundsOf(piece), around) || !comesNear(piece, around)) return [piece];
  const lines = erased(piece, eraser);
  return lines === null ? [piece] : lines.map((points) => ({ ...piece, points }));
}

function wiped(drag: Drag, context: ToolContext, things: readonly SceneObject[]): SceneEdit | null {
  const { scene } = context;
  const cuts = cutsAlong(drag, context);
  const room = roomIn(scene);
  let objects = 0;
  let points = 0;
  for (const object of scene.objects) {
    const pieces = object.type === 'stroke' ? cuts.get(object.id) : undefined;
    if (!pieces || object.type !== 'stroke') continue;
    objects += pieces.length - 1;
    points += pieces.reduce((sum, piece) => sum + piece.points.length, -object.points.length);
  }
  const fits = objects <= room.objects && points <= room.points;
  const kept = fits ? cuts : new Map([...cuts].map(([id, pieces]) => [id, longest(pieces)]));
  return leaving(scene, kept, things);
}

/** In a full course, cutting would make too many: the longest piece stays, which never needs more room. */
function longest(pieces: readonly Stroke[]): readonly Stroke[] {
  const lengths = pieces.map(strokeLengthMm);
  const most = Math.max(...lengths);
  return pieces.filter((_, index) => lengths[index] === most).slice(0, 1);
}

/** The first piece keeps the stroke's id; a stroke of which nothing is left goes, like the things. */
function leaving(scene: Scene, cuts: Cuts, things: readonly SceneObject[]): SceneEdit | null {
  const freeId = freeIds(scene);
  const gone = things.map(({ id }) => id);
  const changes: Replacement[] = [];
  for (const [id, pieces] of cuts) {
    if (pieces.length === 0) gone.push(id);
    else
      changes.push({
        id,
        by: pieces.map((piece, index) => (index === 0 ? piece : { ...piece, id: freeId('stroke') })),
      });
  }
  return combined([replacing(changes), removing(gone)]);
}

/**
 * The things besides lines that are erased. A tap takes the topmost thing within half the reach (mistakes hurt), if no line lies above it;
 * a drag also takes all in its path.
 */
function thingsUnder(drag: Drag, context: ToolContext): readonly SceneObject[] {
  const { scene, options } = context;
  if (options.eraser === 'lines') return [];
  const [topmost] = thingsAt(scene, startOf(drag), drag.reachMm / 2);
  const passed = isTap(drag) ? new Set<string>() : new Set(passedAlong(drag, context));
  if (topmost !== undefined && topmost !== null) passed.add(topmost);
  return scene.objects.filter(({ id, type }) => type !== 'stroke' && passed.has(id));
}

const passedAlong = alongPath<ReadonlySet<string>>({
  block: 8, // chosen: nothing is rounded, and little is left to look at
  start: () => new Set(),
  after: (passed, path, _drag, { scene }) => {
    const next = new Set(passed);
    const places = fewer(path);
    const around = boundsOfOutline(places);
    for (const object of scene.objects) {
      if (object.type === 'stroke' || object.lock || next.has(object.id)) continue;
      if (!boundsMeet(boundsOf(object), around)) continue;
      if (isPassed(object, places)) next.add(object.id);
    }
    return next;
  },
});

const isPassed = (object: Scene['objects'][number], places: readonly Vec[]): boolean =>
  places.some((place, index) => meets(object, [places[index - 1] ?? place, place]));
