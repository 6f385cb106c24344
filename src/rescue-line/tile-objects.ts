import type { Vec } from '#core/geometry';
import { TILE_MM } from '#scene/league/league';
import type { Point } from '#scene/scene';
import { rounded, type Floor, type Unnamed } from './floor';
import type { Way } from './follow';
import { EXIT, keyOf, type MapTile } from './map';
import { LINE_MM, placeOnWay, shapeOf, turnedPlace } from './shapes';
import { opposite } from './side';

/** Side of a green mark. */
const MARK_MM = 25;

/** Width of the red strip. */
const STRIP_MM = 25;

/** Chosen: as large as a milk carton; the robot has room beside it. The rules ask for 150 mm of height. */
const OBSTACLE_MM = 90;
const OBSTACLE_HEIGHT_MM = 150;

/** A place on a tile in the arena. */
const placed = ({ at, turns }: MapTile, place: Vec, floor: Floor): Point => {
  const [middle, there] = [floor(at), turnedPlace(place, turns)];
  return rounded({ x: middle.x + there.x, y: middle.y + there.y });
};

/** The lines and marks of a tile; several are a group. */
export function linesOf(tile: MapTile, floor: Floor): readonly Unnamed[] {
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
export function obstaclesOf({ steps }: Pick<Way, 'steps'>, floor: Floor): readonly Unnamed[] {
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
