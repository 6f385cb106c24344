import { createRng, type Rng } from '#core/rng';
import { TILE_MM, type League, type LeagueRules } from '#scene/league/league';
import type { Block, Paper, Point, Wall } from '#scene/scene';
import type { Floor, Unnamed } from './floor';
import type { Way } from './follow';
import { keyOf, ZONE, type LineMap, type Place } from './map';
import { pointRules } from './rules';
import { HALF_MM } from './shapes';
import { opposite, stepOver, type Side } from './side';

/** The evacuation zone of a map: its things, and its place in the league; nothing if it has none. */
export interface MapZone {
  readonly objects: readonly Unnamed[];
  readonly league: Pick<League, 'zone'>;
}

/** An opening in the walls of the zone: a tile of the zone, and the side over which one comes in. */
interface Opening {
  readonly at: Place;
  readonly side: Side;
}

const WALL = { thickness: 10, height: 100 } as const;
const STRIP_MM = { long: 250, wide: 25 } as const;

/** Length of the legs of a safe place. */
const SAFE_MM = 300;

/** Victims where a map does not say how many. */
const USUAL_VICTIMS = { living: 2, dead: 1 } as const;

/** Chosen: as far as that from walls, safe places and each other the middle of a victim is; a robot comes round it. */
const ROOM_MM = 160;

/** The zone, its walls, strips, safe places and victims; these lie where a fixed seed puts them. */
export function zoneOf(map: LineMap, way: Way, rules: LeagueRules, floor: Floor): MapZone {
  const cells = [...map.tiles.values()].filter(({ image }) => image === ZONE).map(({ at }) => at);
  if (cells.length === 0) return { objects: [], league: {} };
  const middles = cells.map(floor);
  const xs = middles.map(({ x }) => x);
  const ys = middles.map(({ y }) => y);
  const low: Point = [Math.min(...xs) - HALF_MM, Math.min(...ys) - HALF_MM];
  const high: Point = [Math.max(...xs) + HALF_MM, Math.max(...ys) + HALF_MM];
  const at: Point = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  const size: Point = [high[0] - low[0], high[1] - low[1]];
  const { entrance, exit } = openingsOf(way);
  const openings = [entrance, exit].filter((one) => one !== null);
  const rng = createRng(1).fork('rescue-zone');
  const corners = freeCorners({ at, size }, openings, floor, rng);
  const isEntry = pointRules[rules].victims.kind === 'points';
  const safe = isEntry ? corners.slice(0, 1) : corners.slice(0, 2);
  const colors = isEntry ? (['black'] as const) : (['green', 'red'] as const);
  const objects: readonly Unnamed[] = [
    ...(entrance === null ? [] : [strip(entrance, 'silver', floor)]),
    ...(exit === null ? [] : [strip(exit, 'black', floor)]),
    ...safe.map((corner, index) => triangle(corner, colors[index] ?? 'black')),
    ...victimsOf(map, { at, size }, safe, isEntry, rng),
    ...wallsOf(cells, openings, floor, map),
  ];
  return { objects, league: { zone: { at, size } } };
}

/** The openings through which the way leads into the zone and out of it. */
function openingsOf({ steps, end }: Way): { readonly entrance: Opening | null; readonly exit: Opening | null } {
  const after = steps.findIndex(({ isAfterZone }) => isAfterZone);
  const before = steps.at(after < 0 ? -1 : after - 1);
  const behind = after < 0 ? undefined : steps[after];
  const isLed = after >= 0 || end === 'zone';
  return {
    entrance: isLed && before !== undefined && before.exit !== null ? openingAt(before.tile.at, before.exit) : null,
    exit: behind === undefined ? null : openingAt(behind.tile.at, behind.entry),
  };
}

/** The opening over a side of the tile beside the zone. */
function openingAt({ x, y }: Place, side: Side): Opening {
  const step = stepOver(side);
  return { at: { x: x + step.x, y: y + step.y }, side: opposite(side) };
}

const isUpright = (side: Side): boolean => side % 2 === 1;

/** The middle of a side of a tile in the arena. */
function sideMiddle({ at, side }: Opening, floor: Floor): Point {
  const { x, y } = floor(at);
  const step = stepOver(side);
  return [x + step.x * HALF_MM, y - step.y * HALF_MM];
}

/** A strip across an opening. */
function strip(opening: Opening, color: Paper['color'], floor: Floor): Unnamed {
  const { long, wide } = STRIP_MM;
  const size: Point = isUpright(opening.side) ? [wide, long] : [long, wide];
  return { type: 'paper', at: sideMiddle(opening, floor), size, angle: 0, color };
}

/** The walls between the zone and the rest; along the arena's edge there is one anyway. */
function wallsOf(
  cells: readonly Place[],
  openings: readonly Opening[],
  floor: Floor,
  map: LineMap,
): readonly Unnamed[] {
  // prettier-ignore
  const zone = new Set(cells.map(keyOf));
  const isOpen = (cell: Place, side: Side): boolean =>
    openings.some((opening) => opening.side === side && keyOf(opening.at) === keyOf(cell));
  return cells.flatMap((cell) =>
    ([0, 1, 2, 3] as const).flatMap((side): readonly Omit<Wall, 'id'>[] => {
      const step = stepOver(side);
      const [x, y] = [cell.x + step.x, cell.y + step.y];
      const isEdge = x < 0 || y < 0 || x >= map.columns || y >= map.rows;
      if (isEdge || zone.has(keyOf({ x, y })) || isOpen(cell, side)) return [];
      const [middleX, middleY] = sideMiddle({ at: cell, side }, floor);
      const [dx, dy] = isUpright(side) ? [0, HALF_MM] : [HALF_MM, 0];
      return [{ type: 'wall', from: [middleX - dx, middleY - dy], to: [middleX + dx, middleY + dy], ...WALL }];
    }),
  );
}

/** A corner of the zone: its place, and the directions into the zone. */
interface Corner {
  readonly at: Point;
  readonly inX: 1 | -1;
  readonly inY: 1 | -1;
}

/** The corners without an opening beside them, in the order in which safe places take them: the seed's. */
function freeCorners(
  zone: { readonly at: Point; readonly size: Point },
  openings: readonly Opening[],
  floor: Floor,
  rng: Rng,
): readonly Corner[] {
  // prettier-ignore
  const all = ([1, -1] as const).flatMap((inX) => ([1, -1] as const).map((inY): Corner => {
    const at: Point = [zone.at[0] - (inX * zone.size[0]) / 2, zone.at[1] - (inY * zone.size[1]) / 2];
    return { at, inX, inY };
  })); // prettier-ignore
  const near = ({ at }: Corner): boolean =>
    openings.some((opening) => {
      const [x, y] = sideMiddle(opening, floor);
      return Math.abs(x - at[0]) + Math.abs(y - at[1]) < TILE_MM;
    });
  const free = all.filter((corner) => !near(corner)).map((corner) => ({ corner, draw: rng.unit() }));
  return free.sort((one, other) => one.draw - other.draw).map(({ corner }) => corner);
}

/** A safe place: a triangle in a corner. */
function triangle({ at: [x, y], inX, inY }: Corner, color: Paper['color']): Unnamed {
  const half = SAFE_MM / 2;
  const at: Point = [x + inX * half, y + inY * half];
  const place = (dx: number, dy: number): Point => [inX * dx, inY * dy];
  const corners = [place(-half, -half), place(half, -half), place(-half, half)];
  return { type: 'paper', at, size: [SAFE_MM, SAFE_MM], angle: 0, corners, color };
}

function victimsOf(
  map: LineMap,
  zone: { readonly at: Point; readonly size: Point },
  safe: readonly Corner[],
  isEntry: boolean,
  rng: Rng,
): readonly Unnamed[] {
  // prettier-ignore
  const { living, dead } = map.victims;
  const said = living + dead > 0 ? map.victims : USUAL_VICTIMS;
  const colors = [...Array<'silver'>(said.living).fill('silver'), ...Array<'black'>(said.dead).fill('black')];
  const places: Point[] = [];
  const isFree = ([x, y]: Point): boolean =>
    places.every((other) => Math.max(Math.abs(other[0] - x), Math.abs(other[1] - y)) >= ROOM_MM) &&
    safe.every(({ at }) => Math.abs(at[0] - x) + Math.abs(at[1] - y) >= SAFE_MM + ROOM_MM);
  const within = (index: 0 | 1): number =>
    Math.round(zone.at[index] + (rng.unit() - 0.5) * Math.max(0, zone.size[index] - 2 * ROOM_MM));
  for (let tries = 0; tries < 500 && places.length < colors.length; tries++) {
    const place: Point = [within(0), within(1)];
    if (isFree(place)) places.push(place);
  }
  return places.flatMap((at, index) => victim(at, colors[index] ?? 'silver', isEntry));
}

/** A ball, or in the entry league a can on a green disc. */
function victim(at: Point, color: 'silver' | 'black', isEntry: boolean): readonly Unnamed[] {
  const body = (mm: number, height: number): Omit<Block, 'id'> => ({
    ...{ type: 'block', at, size: [mm, mm], angle: 0, round: true },
    ...{ height, color },
  });
  if (!isEntry) return [body(45, 45)];
  return [{ type: 'paper', at, size: [300, 300], angle: 0, round: true, color: 'green' }, body(66, 115)];
}
