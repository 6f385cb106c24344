import type { Vec } from '#core/geometry';
import { TILE_MM, type League, type LeagueRules, type LeagueTile } from '#scene/league';
import { defaultScene, sceneDefaults, type Point, type Scene, type SceneObject } from '#scene/scene';
import { floorOf, rounded, type Floor, type Unnamed } from './floor';
import { follow, type Step, type Way } from './follow';
import { EXIT, keyOf, ZONE, unlikes, type LineMap, type MapTile } from './map';
import type { MapNote } from './notes';
import { pointRules } from './rules';
import { headingOver, opposite } from './side';
import { HALF_MM, LINE_MM, placeOnWay, shapeOf, turnedPlace } from './shapes';
import { zoneOf } from './zone';

/** Side of a green mark. */
const MARK_MM = 25;

/** Width of the red strip. */
const STRIP_MM = 25;

/** Chosen: as large as a milk carton; the robot has room beside it. The rules ask for 150 mm of height. */
const OBSTACLE_MM = 90;
const OBSTACLE_HEIGHT_MM = 150;

/** Maximum number of pictures that a note names. */
const NAMED = 6;

/** A map as a course, and what is not in it. */
export interface MapCourse {
  readonly scene: Scene;
  readonly notes: readonly MapNote[];
}

/** The rules of a map that does not say whose it is. */
export const USUAL_RULES: LeagueRules = 'line-2025';

/** Makes the course of a map: its tiles drawn anew, its obstacles and walls, and the way that is scored. */
export function courseOfMap(map: LineMap, rules: LeagueRules = USUAL_RULES): MapCourse {
  const way = follow(map);
  const floor = floorOf(map);
  const tiles = [...map.tiles.values()].filter(({ image }) => image !== ZONE);
  const zone = zoneOf(map, way, rules, floor);
  const league: League = { rules, tiles: way.steps.map((step, index) => leagueTile(step, index, floor)), ...zone.league };
  const lines = tiles.flatMap((tile) => linesOf(tile, floor));
  const objects = [...lines, ...zone.objects, ...obstaclesOf(way, floor)];
  const [first] = league.tiles;
  const start = defaultScene();
  const scene: Scene = {
    ...start,
    name: map.name,
    size: [map.columns * TILE_MM, map.rows * TILE_MM],
    robot: { ...start.robot, at: first?.at ?? [HALF_MM, HALF_MM], heading: first?.heading ?? 0 },
    task: { ...sceneDefaults.task, seconds: map.seconds ?? pointRules[rules].seconds },
    objects: numbered(objects),
    ...(league.tiles.length > 1 ? { league } : {}),
  };
  return { scene, notes: notesOn(map, way, tiles) };
} // prettier-ignore

/** A place on a tile in the arena. */
const placed = ({ at, turns }: MapTile, place: Vec, floor: Floor): Point => {
  const [middle, there] = [floor(at), turnedPlace(place, turns)];
  return rounded({ x: middle.x + there.x, y: middle.y + there.y });
};

function leagueTile({ tile, entry, exit, isAfterZone }: Step, index: number, floor: Floor): LeagueTile {
  const { gaps, crossings, obstacles, isCheckpoint } = tile;
  return {
    at: rounded(floor(tile.at)),
    heading: headingOver(exit ?? opposite(entry)),
    ...(gaps > 0 ? { gaps } : {}),
    ...(crossings > 0 ? { crossings } : {}),
    ...(obstacles > 0 ? { obstacles } : {}),
    ...(isCheckpoint && index > 0 ? { checkpoint: true } : {}),
    ...(isAfterZone ? { afterZone: true } : {}),
  };
}

/** The lines and marks of a tile; several are a group. */
function linesOf(tile: MapTile, floor: Floor): readonly Unnamed[] {
  const { lines, marks } = shapeOf(tile);
  const color = 'black' as const;
  const objects: readonly Unnamed[] = [
    ...lines.map((points): Unnamed => ({ type: 'stroke', points: points.map((point) => placed(tile, point, floor)), width: LINE_MM, color })),
    ...marks.map((mark): Unnamed => ({ type: 'paper', at: placed(tile, mark, floor), size: [MARK_MM, MARK_MM], angle: 0, color: 'green' })),
    ...(tile.image === EXIT ? [endStrip(tile, floor)] : []),
  ]; // prettier-ignore
  return objects.length < 2 ? objects : objects.map((object) => ({ ...object, group: `tile-${keyOf(tile.at)}` }));
}

/** The red strip across the last tile. */
function endStrip(tile: MapTile, floor: Floor): Unnamed {
  const size: Point = tile.turns % 2 === 0 ? [TILE_MM, STRIP_MM] : [STRIP_MM, TILE_MM];
  return { type: 'paper', at: rounded(floor(tile.at)), size, angle: 0, color: 'red' };
}

/** The obstacles along the way; each stands once, also where the robot comes twice. */
function obstaclesOf({ steps }: Way, floor: Floor): readonly Unnamed[] {
  const first = steps.filter((step, index) => steps.findIndex(({ tile }) => tile === step.tile) === index);
  return first.flatMap(({ tile, entry, exit }) =>
    Array.from({ length: tile.obstacles }, (_, index): Unnamed => {
      const middle = floor(tile.at);
      const there = placeOnWay(entry, exit ?? opposite(entry), (index + 1) / (tile.obstacles + 1));
      const at = rounded({ x: middle.x + there.x, y: middle.y + there.y });
      return { type: 'fixed-block', at, size: [OBSTACLE_MM, OBSTACLE_MM], angle: 0, height: OBSTACLE_HEIGHT_MM };
    }),
  );
}

/** Objects with ids: `stroke-1`, `stroke-2`, `paper-1`, … */
function numbered(objects: readonly Unnamed[]): readonly SceneObject[] {
  const counts = new Map<string, number>();
  return objects.map((object) => {
    const number = (counts.get(object.type) ?? 0) + 1;
    counts.set(object.type, number);
    return { ...object, id: `${object.type}-${String(number)}` } as SceneObject;
  });
}

function notesOn(map: LineMap, { steps, end }: Way, tiles: readonly MapTile[]): readonly MapNote[] {
  const drawn = tiles.filter((tile) => !shapeOf(tile).isAsDrawn);
  const images = [...new Set(drawn.map(({ image }) => image || '?'))].slice(0, NAMED).join(', ');
  const unlike = unlikes.flatMap((code): readonly MapNote[] => {
    const count = tiles.filter((tile) => tile.unlike.includes(code)).length;
    return count === 0 ? [] : [{ code, params: { count } }];
  });
  const last = steps.at(-1)?.tile.at ?? map.start;
  return [
    ...unlike,
    ...(map.upstairs > 0 ? [{ code: 'upstairs' as const, params: { count: map.upstairs } }] : []),
    ...(drawn.length > 0 ? [{ code: 'drawn' as const, params: { count: drawn.length, images } }] : []),
    ...(end === 'nothing' ? [{ code: 'open' as const, params: { x: last.x, y: last.y } }] : []),
  ];
}
