import { TILE_MM, type League, type LeagueRules, type LeagueTile } from '#scene/league/league';
import { defaultScene, sceneDefaults, type Scene, type SceneObject } from '#scene/scene';
import { floorOf, rounded, type Floor, type Unnamed } from './floor';
import { follow, type Step, type Way } from './follow';
import { ZONE, unlikes, type LineMap, type MapTile } from './map';
import type { MapNote } from './notes';
import { pointRules } from './rules';
import { headingOver, opposite } from './side';
import { HALF_MM, shapeOf } from './shapes';
import { linesOf, obstaclesOf } from './tile-objects';
import { zoneOf } from './zone';

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
    league,
  };
  return { scene, notes: notesOn(map, way, tiles) };
} // prettier-ignore

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

/** Objects with ids: `stroke-1`, `stroke-2`, `paper-1`, … */
function numbered(objects: readonly Unnamed[]): readonly SceneObject[] {
  const counts = new Map<string, number>();
  return objects.map((object) => {
    const number = (counts.get(object.type) ?? 0) + 1;
    counts.set(object.type, number);
    return { ...object, id: `${object.type}-${String(number)}` };
  });
}

function notesOn(map: LineMap, { steps, end }: Way, tiles: readonly MapTile[]): readonly MapNote[] {
  // A seesaw is told on its own.
  const drawn = tiles.filter((tile) => !shapeOf(tile).isAsDrawn && !tile.unlike.includes('seesaw'));
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
