import { EXIT, keyOf, ZONE, type LineMap, type MapTile } from './map';
import { opposite, stepOver, turned, type Side } from './side';

/** A tile on the way, and the sides (as it lies) over which the robot comes and goes. */
export interface Step {
  readonly tile: MapTile;
  readonly entry: Side;
  /** `null`: the way ends here. */
  readonly exit: Side | null;
  /** The robot comes here out of the evacuation zone. */
  readonly isAfterZone: boolean;
}

/** The way over a map, and how it ends: at the last tile, in the evacuation zone, at a floor above, or at nothing. */
export interface Way {
  readonly steps: readonly Step[];
  readonly end: 'exit' | 'zone' | 'floors' | 'nothing';
}

/** The side at which a robot leaves a tile, both as it lies; `null`: none. */
function exitOf({ paths, turns }: MapTile, entry: Side): Side | null {
  const exit = paths.get(turned(entry, -turns));
  return exit === undefined ? null : turned(exit, turns);
}

/** The tile that a robot comes to, and the side over which it comes. */
interface Arrival {
  readonly tile: MapTile;
  readonly entry: Side;
}

/** Follows the line from the start tile: each tile's `paths` say where it goes on. */
export function follow(map: LineMap): Way {
  const steps: Step[] = [];
  const passed = new Set<string>();
  const start = map.tiles.get(keyOf(map.start));
  let next: Arrival | null = start === undefined ? null : { tile: start, entry: firstEntry(map, start) };
  let isAfterZone = false;
  while (next !== null) {
    const { tile, entry }: Arrival = next;
    const mark = `${keyOf(tile.at)} ${String(entry)}`;
    if (passed.has(mark)) break;
    passed.add(mark);
    const exit = tile.image === EXIT ? null : exitOf(tile, entry);
    steps.push({ tile, entry, exit, isAfterZone });
    if (tile.image === EXIT) return { steps, end: 'exit' };
    if (tile.unlike.includes('floors')) return { steps, end: 'floors' };
    const to = exit === null ? undefined : beside(map, tile, exit);
    const isZone = to?.image === ZONE;
    if (isZone && steps.some((step) => step.isAfterZone)) return { steps, end: 'zone' };
    const behind = isZone ? behindZone(map) : null;
    if (isZone && behind === null) return { steps, end: 'zone' };
    isAfterZone = behind !== null;
    next = behind ?? (to === undefined || exit === null ? null : { tile: to, entry: opposite(exit) });
  }
  return { steps, end: 'nothing' };
}

/** The tile over a side of another one. */
export function beside(map: LineMap, { at }: MapTile, side: Side): MapTile | undefined {
  const { x, y } = stepOver(side);
  return map.tiles.get(keyOf({ x: at.x + x, y: at.y + y }));
}

/** The side over which the first tile is entered: that of the last of its ways that leads to a neighbour. */
function firstEntry(map: LineMap, start: MapTile): Side {
  const entries = [...start.paths.keys()].map((side) => turned(side, start.turns));
  const leading = entries.filter((entry) => {
    const exit = exitOf(start, entry);
    return exit !== null && beside(map, start, exit) !== undefined;
  });
  return leading.at(-1) ?? entries.at(-1) ?? 0;
}

/** The first tile after the zone, entered from its neighbour in the zone. */
function behindZone(map: LineMap): Arrival | null {
  const tile = map.afterZone && map.tiles.get(keyOf(map.afterZone));
  if (!tile) return null;
  const entry = ([0, 1, 2, 3] as const).find((side) => beside(map, tile, side)?.image === ZONE);
  return entry === undefined ? null : { tile, entry };
}
