import { isRecord } from '#core/record';
import { summaryOf } from '#scene/json-file';
import { shown, type SceneProblem } from '#scene/problem';
import { Reader } from '#scene/reader';
import { sceneLimits } from '#scene/scene';
import { EXIT, keyOf, mapLimits, ZONE, type LineMap, type MapTile, type Place, type Unlike } from './map';
import { sideNames, type Side } from './side';

/** A map, or everything that is wrong with its file; `problem` is the first one's message and how many follow. */
export type ReadMap =
  { readonly map: LineMap } | { readonly problem: string; readonly problems: readonly SceneProblem[] };

type Fields = Readonly<Record<string, unknown>>;

/** True if a value is a map of a rescue line, or is meant to be one. */
export function looksLikeMap(value: unknown): boolean {
  if (!isRecord(value)) return false;
  const { tiles } = value;
  if (typeof tiles !== 'object' || tiles === null) return false;
  return Object.hasOwn(value, 'startTile') || Object.values(tiles).some((tile) => isRecord(tile) && 'tileType' in tile);
}

/** Reads a map. Properties that mean nothing for a course are passed over. Never throws. */
export function readMap(value: unknown): ReadMap {
  const reader = new Reader();
  const map = mapOf(recordIn(value, '', reader), reader);
  const { problems } = reader;
  return problems.length > 0 ? { problem: summaryOf(problems), problems } : { map };
}

function mapOf(file: Fields, reader: Reader): LineMap {
  const all = tilesIn(file['tiles'], reader);
  const ground = all.filter(({ floor }) => floor === 0);
  const tiles = new Map(ground.map(({ tile }) => [keyOf(tile.at), tile]));
  const start = placeIn(file['startTile'], 'startTile', reader);
  if (reader.problems.length === 0 && !tiles.has(keyOf(start)))
    reader.report(
      'unknown-value',
      'startTile',
      file['startTile'],
      'there is no tile. Set the start in the map’s editor.',
    );
  const { victims, duration, name } = file;
  const counts = isRecord(victims) ? victims : {};
  const most = (side: 'x' | 'y'): number => ground.reduce((so, { tile }) => Math.max(so, tile.at[side] + 1), 1);
  return {
    name: typeof name === 'string' ? name.slice(0, sceneLimits.nameCharacters) : '',
    columns: Math.max(most('x'), sizeIn(file, 'width', reader)),
    rows: Math.max(most('y'), sizeIn(file, 'length', reader)),
    seconds: typeof duration === 'number' && duration >= 1 && duration <= mapLimits.seconds ? Math.round(duration) : null,
    start,
    afterZone: afterZoneIn(file['startTile2'], tiles),
    victims: {
      living: countIn(counts, 'live', 'victims.live', mapLimits.victims, reader),
      dead: countIn(counts, 'dead', 'victims.dead', mapLimits.victims, reader),
    },
    tiles,
    upstairs: all.length - ground.length,
  }; // prettier-ignore
}

function recordIn(value: unknown, path: string, reader: Reader): Fields {
  if (isRecord(value)) return value;
  reader.wrongType(value, path, 'an object { … }');
  return {};
}

/** Columns or rows that the file says; 1 if it says none, as the tiles say enough. */
const sizeIn = (file: Fields, key: string, reader: Reader): number =>
  reader.whole(file[key], key, { min: 1, max: mapLimits.side }, 1);

const countIn = (fields: Fields, key: string, path: string, max: number, reader: Reader): number =>
  reader.whole(fields[key] ?? undefined, path, { min: 0, max }, 0);

function placeIn(value: unknown, path: string, reader: Reader): Place {
  const fields = recordIn(value, path, reader);
  const range = { min: 0, max: mapLimits.side - 1 };
  const { z = 0 } = fields;
  if (z !== 0) reader.report('unknown-value', `${path}.z`, z, 'only the ground floor (0) can be driven on. Begin there.', { known: 0 }); // prettier-ignore
  return { x: reader.whole(fields['x'], `${path}.x`, range), y: reader.whole(fields['y'], `${path}.y`, range) };
}

/** A place that is none stands for no second start. */
function afterZoneIn(value: unknown, tiles: ReadonlyMap<string, MapTile>): Place | null {
  if (!isRecord(value)) return null;
  const { x, y, z = 0 } = value;
  return typeof x === 'number' && typeof y === 'number' && z === 0 ? (tiles.get(keyOf({ x, y }))?.at ?? null) : null;
}

interface PlacedTile {
  readonly floor: number;
  readonly tile: MapTile;
}

/** The tiles, from an object by their places or from a list. */
function tilesIn(value: unknown, reader: Reader): readonly PlacedTile[] {
  const entries: readonly (readonly [string, unknown])[] = Array.isArray(value)
    ? value.map((entry: unknown, index) => [`tiles[${String(index)}]`, entry])
    : Object.entries(recordIn(value, 'tiles', reader)).map(([key, entry]) => [key, entry]);
  const max = mapLimits.tiles;
  if (entries.length > max) {
    const count = entries.length;
    reader.report('too-many', 'tiles', undefined, `${String(count)} tiles; there may be 0 … ${String(max)}.`, { count, min: 0, max }); // prettier-ignore
    return [];
  }
  return entries.flatMap(([key, entry]) => (reader.isFull ? [] : tileIn(key, entry, Array.isArray(value), reader)));
}

function tileIn(key: string, value: unknown, isListed: boolean, reader: Reader): readonly PlacedTile[] {
  const path = isListed ? key : `tiles["${key.slice(0, 20)}"]`;
  const fields = recordIn(value, path, reader);
  const said = isListed ? [fields['x'], fields['y'], fields['z'] ?? 0] : key.split(',').map(numberOf);
  const [x, y, floor] = said.map((part, index) => reader.whole(part, `${path}.${'xyz'.charAt(index)}`, { min: 0, max: index === 2 ? mapLimits.floors : mapLimits.side - 1 })); // prettier-ignore
  if (x === undefined || y === undefined || floor === undefined) {
    reader.report('unknown-value', path, key, 'must be the place of a tile: "x,y,z".', {
      known: '"0,0,0", "1,0,0", …',
    });
    return [];
  }
  return [{ floor, tile: { at: { x, y }, ...kindIn(fields, path, reader), ...thingsOn(fields, path, reader) } }];
}

const numberOf = (text: string): unknown => (/^\d{1,4}$/.test(text) ? Number(text) : text);

/** The tile's type, and how it is turned. */
function kindIn(
  fields: Fields,
  path: string,
  reader: Reader,
): Pick<MapTile, 'turns' | 'image' | 'paths' | 'gaps' | 'crossings'> {
  // prettier-ignore
  const place = `${path}.tileType`;
  const type = recordIn(fields['tileType'], place, reader);
  const { rot = 0 } = fields;
  const turns = [0, 90, 180, 270].indexOf(typeof rot === 'number' ? rot : -1);
  const known = '0, 90, 180, 270';
  if (turns < 0) reader.report('unknown-value', `${path}.rot`, rot, `${shown(rot)} is unknown. Known: ${known}.`, { known }); // prettier-ignore
  const image = imageOf(type);
  return {
    turns,
    image,
    paths: pathsIn(type['paths'], `${place}.paths`, image, reader),
    gaps: countIn(type, 'gaps', `${place}.gaps`, mapLimits.perTile, reader),
    crossings: countIn(type, 'intersections', `${place}.intersections`, mapLimits.perTile, reader),
  };
}

/** The special tiles by the editor's own ids. */
const SPECIAL: Readonly<Record<string, string>> = {
  '58cfd6549792e9313b1610e0': EXIT,
  '58cfd6549792e9313b1610e1': ZONE,
  '58cfd6549792e9313b1610e2': ZONE,
  '58cfd6549792e9313b1610e3': ZONE,
};

function imageOf({ image, _id: id }: Fields): string {
  const special = typeof id === 'string' && Object.hasOwn(SPECIAL, id) ? SPECIAL[id] : undefined;
  if (special !== undefined) return special;
  const name =
    typeof image === 'string'
      ? image
          .slice(0, 60)
          .replace(/^.*\//, '')
          .replace(/\.\w+$/, '')
      : '';
  return /^ev[123]$/.test(name) ? ZONE : name;
}

function pathsIn(value: unknown, path: string, image: string, reader: Reader): ReadonlyMap<Side, Side> {
  if (value === undefined && (image === EXIT || image === ZONE || image === '')) return new Map();
  const sides = Object.entries(recordIn(value, path, reader)).filter(([from]) => from !== '_id');
  const paths = new Map<Side, Side>();
  for (const [from, to] of sides.slice(0, sideNames.length)) {
    const [enters, leaves] = [from, to].map((name) => sideNames.findIndex((side) => side === name));
    if (isSide(enters) && isSide(leaves)) paths.set(enters, leaves);
    else {
      const known = sideNames.join(', ');
      reader.report('unknown-value', `${path}.${from.slice(0, 20)}`, to, `${shown(to)} is unknown. Known: ${known}.`, { known }); // prettier-ignore
    }
  }
  return paths;
}

const isSide = (index: number | undefined): index is Side => index !== undefined && index >= 0;

function thingsOn(
  fields: Fields,
  path: string,
  reader: Reader,
): Pick<MapTile, 'obstacles' | 'isCheckpoint' | 'unlike'> {
  // prettier-ignore
  const items = isRecord(fields['items']) ? fields['items'] : {};
  const type = isRecord(fields['tileType']) ? fields['tileType'] : {};
  const has = (value: unknown): boolean => value === true || (typeof value === 'number' && value > 0);
  const unlike: Readonly<Record<Unlike, boolean>> = {
    seesaw: has(type['seesaw']),
    bumps: has(items['speedbumps']),
    ramp: has(items['rampPoints']),
    floors: typeof fields['levelUp'] === 'string' || typeof fields['levelDown'] === 'string',
  };
  return {
    obstacles: countIn(items, 'obstacles', `${path}.items.obstacles`, mapLimits.perTile, reader),
    isCheckpoint: fields['checkPoint'] === true,
    unlike: (Object.keys(unlike) as Unlike[]).filter((kind) => unlike[kind]),
  };
}
