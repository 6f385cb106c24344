import { freeId, type SceneEdit } from '#scene/edit';
import { TILE_MM, type League, type LeagueTile } from '#scene/league/league';
import type { Point, Scene, SceneObject } from '#scene/scene';
import type { Step } from './follow';
import { EXIT, type MapTile } from './map';
import { USUAL_RULES } from './course-of-map';
import { pointRules } from './rules';
import { shapeOf, type TileShape } from './shapes';
import { headingOver, LEFT, RIGHT, TOP, turned, type Side } from './side';
import { linesOf, obstaclesOf } from './tile-objects';

/** The tiles of the shelf from which a line is built, one after the other. */
export const shelfTiles = ['straight', 'left', 'right', 'gap', 'toLeft', 'toRight', 'obstacle', 'checkpoint', 'end'] as const; // prettier-ignore
export type ShelfTile = (typeof shelfTiles)[number];

/** For a robot that comes from the left: where it leaves. */
const exits: Readonly<Record<ShelfTile, Side>> = {
  ...{ straight: RIGHT, gap: RIGHT, obstacle: RIGHT, checkpoint: RIGHT, end: RIGHT },
  ...{ left: TOP, toLeft: TOP, right: 2, toRight: 2 },
};

/** A tile of the shelf, as it lies for a robot with this heading. */
function tileFor(kind: ShelfTile, heading: number): MapTile {
  const exit = exits[kind];
  const isCrossing = kind === 'toLeft' || kind === 'toRight';
  const back: readonly (readonly [Side, Side])[] = isCrossing ? [[RIGHT, LEFT], [exit, turned(exit, 2)]] : [[exit, LEFT]]; // prettier-ignore
  return {
    at: { x: 0, y: 0 },
    // The end is drawn for who comes from below, all others for who comes from the left.
    turns: (((kind === 'end' ? 90 : 360) - heading) / 90 + 4) % 4,
    image: kind === 'end' ? EXIT : kind === 'gap' ? 'tile-49' : '',
    paths: new Map([[LEFT, exit], ...back]),
    gaps: kind === 'gap' ? 1 : 0,
    crossings: isCrossing ? 1 : 0,
    obstacles: kind === 'obstacle' ? 1 : 0,
    isCheckpoint: kind === 'checkpoint',
    unlike: [],
  };
}

/** The drawing of a tile of the shelf, for a robot that comes from the left. */
export const shelfShape = (kind: ShelfTile): TileShape => shapeOf(tileFor(kind, 0));

/** The place for the next tile: its middle, and the heading in which the robot comes; `null`: there is no room. */
export function nextPlace({ league, robot, size, objects }: Scene): { readonly at: Point; readonly heading: number } | null {
  const last = league?.tiles.at(-1);
  const heading = last?.heading ?? (((Math.round(robot.heading / 90) * 90) % 360) + 360) % 360;
  const at: Point = last === undefined ? [tileMiddle(robot.at[0]), tileMiddle(robot.at[1])] : ahead(last);
  const isInside = at.every((mm, axis) => mm > 0 && mm + TILE_MM / 2 <= (size[axis] ?? 0));
  const isTaken = league?.tiles.some((tile) => tile.at[0] === at[0] && tile.at[1] === at[1]) === true;
  const hasEnd = objects.some((object) => object.type === 'paper' && object.color === 'red' && isSame(object.at, last?.at));
  return isInside && !isTaken && !hasEnd ? { at, heading } : null;
} // prettier-ignore

const isSame = (a: Point, b: Point | undefined): boolean => b !== undefined && a[0] === b[0] && a[1] === b[1];

/** The middle of the tile in which a place lies. */
const tileMiddle = (mm: number): number => Math.floor(mm / TILE_MM) * TILE_MM + TILE_MM / 2;

function ahead({ at: [x, y], heading }: LeagueTile): Point {
  const [dx, dy] = [[1, 0], [0, 1], [-1, 0], [0, -1]][heading / 90] ?? [0, 0]; // prettier-ignore
  return [x + TILE_MM * (dx ?? 0), y + TILE_MM * (dy ?? 0)];
}

/**
 * The edit that lays a tile of the shelf at the end of the line; the first one begins a line where the robot stands.
 *
 * @returns `null` if there is no room for it
 */
export function layTile(scene: Scene, kind: ShelfTile): SceneEdit | null {
  const place = nextPlace(scene);
  if (place === null) return null;
  const { at, heading } = place;
  const tile = tileFor(kind, heading);
  const floor = () => ({ x: at[0], y: at[1] });
  const entry = turned(LEFT, (360 - heading) / 90);
  const exit = turned(exits[kind], (360 - heading) / 90);
  const step: Step = { tile, entry, exit, isAfterZone: false };
  const objects = withIds(scene, [...linesOf(tile, floor), ...obstaclesOf({ steps: [step] }, floor)]);
  const { league, task, robot } = scene;
  const next: LeagueTile = {
    ...{ at, heading: headingOver(exit) },
    ...(tile.gaps > 0 ? { gaps: tile.gaps } : {}),
    ...(tile.crossings > 0 ? { crossings: tile.crossings } : {}),
    ...(tile.obstacles > 0 ? { obstacles: tile.obstacles } : {}),
    ...(tile.isCheckpoint && league !== undefined ? { checkpoint: true } : {}),
  };
  const rules = league?.rules ?? USUAL_RULES;
  const longer: League = { ...league, rules, tiles: [...(league?.tiles ?? []), next] };
  const seconds = league === undefined ? (task.seconds ?? pointRules[rules].seconds) : task.seconds;
  return {
    type: 'all',
    edits: [
      { type: 'add', objects },
      { type: 'course', changes: { league: longer, task: { ...task, seconds } } },
      ...(league === undefined ? [{ type: 'robot', robot: { ...robot, at, heading } } as const] : []),
    ],
  };
}

/** Ids and a group that no object of the course has. */
function withIds(scene: Scene, objects: ReturnType<typeof linesOf>): readonly SceneObject[] {
  const ids: string[] = [];
  const groups = new Set(scene.objects.map(({ group }) => group));
  let number = 1;
  while (groups.has(`tile-${String(number)}`)) number += 1;
  return objects.map((object) => {
    const id = freeId(scene, object.type, ids);
    ids.push(id);
    const group = object.group === undefined ? {} : { group: `tile-${String(number)}` };
    return { ...object, id, ...group };
  });
}
