import { describe, expect, it } from 'vitest';
import { follow } from './follow';
import { looksLikeMap, readMap } from './read-map';
import { bend, demoMap, exit, mapFile, straight, tileOf } from './testing/maps';

const mapOf = (value: unknown) => {
  const read = readMap(value);
  return 'map' in read ? read.map : expect.fail(read.problem);
};
const problemOf = (value: unknown): string => {
  const read = readMap(value);
  return 'problem' in read ? read.problem : expect.fail('was read');
};
const wayOf = (value: unknown) => {
  const { steps, end } = follow(mapOf(value));
  return { places: steps.map(({ tile: { at } }) => `${String(at.x)},${String(at.y)}`), end };
};

describe('a map of the editor', () => {
  it('is followed tile by tile to its end, as its paths say', () => {
    expect(wayOf(demoMap())).toEqual({
      places: ['0,0', '1,0', '2,0', '2,1', '2,2', '1,2', '0,2'],
      end: 'exit',
    });
  });

  it('is the same whether its tiles are an object or a list', () => {
    const { tiles } = demoMap() as { readonly tiles: Readonly<Record<string, object>> };
    const list = Object.entries(tiles).map(([key, tile]) => {
      const [x, y, z] = key.split(',').map(Number);
      return { ...tile, x, y, z };
    });
    expect(wayOf(mapFile(list))).toEqual(wayOf(demoMap()));
  });

  it('knows the last tile by its id, too', () => {
    const last = { ...exit(90), tileType: { _id: '58cfd6549792e9313b1610e0', image: 'x.png', paths: {} } };
    expect(wayOf(mapFile({ '0,0,0': straight(), '1,0,0': last })).end).toBe('exit');
  });

  it('passes a crossing twice', () => {
    const crossing = tileOf('tile-35', 0, { left: 'right', right: 'left', top: 'bottom', bottom: 'top' }, { type: { intersections: 1 } }); // prettier-ignore
    const loop = mapFile(
      { '0,1,0': straight(), '1,1,0': crossing, '2,1,0': bend(90), '2,0,0': bend(0), '1,0,0': bend(270), '1,2,0': exit(180) },
      { startTile: { x: 0, y: 1, z: 0 } },
    ); // prettier-ignore
    expect(wayOf(loop)).toEqual({ places: ['0,1', '1,1', '2,1', '2,0', '1,0', '1,1', '1,2'], end: 'exit' });
  });

  it('goes on behind the evacuation zone at its second start', () => {
    const zone = tileOf('ev1', 0, {});
    const map = mapFile(
      { '0,0,0': straight(), '1,0,0': zone, '1,1,0': zone, '2,1,0': straight(), '3,1,0': exit(90) },
      { width: 4, startTile2: { x: 2, y: 1, z: 0 } },
    );
    expect(wayOf(map)).toEqual({ places: ['0,0', '2,1', '3,1'], end: 'exit' });
    expect(wayOf(mapFile({ '0,0,0': straight(), '1,0,0': zone }))).toEqual({ places: ['0,0'], end: 'zone' });
  });

  it('ends where the line does, and never runs round for ever', () => {
    expect(wayOf(mapFile({ '0,0,0': straight(), '1,0,0': straight() })).end).toBe('nothing');
    const ring = { '0,0,0': bend(270), '1,0,0': bend(0), '1,1,0': bend(90), '0,1,0': bend(180) };
    expect(wayOf(mapFile(ring))).toEqual({ places: expect.any(Array), end: 'nothing' });
    expect(wayOf(mapFile(ring)).places).toHaveLength(4);
  });
});

describe('what is wrong with a map', () => {
  it('is told with place, value and way out', () => {
    const wrong = { ...straight(), rot: 45 };
    expect(problemOf(mapFile({ '0,0,0': wrong }))).toBe('tiles["0,0,0"].rot: 45 is unknown. Known: 0, 90, 180, 270.');
    expect(problemOf(mapFile({ '1,0,0': straight() }))).toContain('startTile: there is no tile. Set the start');
    expect(problemOf(mapFile({ '0,0,0': tileOf('tile-0', 0, { left: 'up' }) }))).toContain('"up" is unknown. Known: top, right, bottom, left.'); // prettier-ignore
    expect(problemOf(mapFile({ '0,0,0': straight() }, { startTile: { x: 0, y: 0, z: 1 } }))).toContain('startTile.z: only the ground floor (0)'); // prettier-ignore
    expect(problemOf(mapFile({ '0,0,0': straight(), '99,0,0': straight() }))).toContain('99 is not within 0 … 32');
    expect(problemOf(mapFile({ here: straight() }))).toContain('tiles["here"]');
    expect(problemOf(mapFile({ '0,0,0': 7 }))).toContain('must be an object');
    expect(problemOf({ startTile: 1, tiles: {} })).toContain('startTile: must be an object');
  });

  it('is told of far too many tiles without reading them', () => {
    const tiles = Object.fromEntries(Array.from({ length: 1_501 }, (_, index) => [`${String(index)},0,0`, 0]));
    expect(problemOf(mapFile(tiles))).toBe('tiles: 1501 tiles; there may be 0 … 1500.');
  });
});

describe('a map among other files', () => {
  it('is known by its start and its tiles', () => {
    expect(looksLikeMap(demoMap())).toBe(true);
    for (const other of [null, [], {}, { tiles: [] }, { startTile: {}, tiles: 3 }])
      expect(looksLikeMap(other)).toBe(false);
  });

  it('is known by the types of its tiles, too: then the missing start is told', () => {
    const { startTile: _start, ...rest } = demoMap() as Record<string, unknown>;
    expect(looksLikeMap(rest)).toBe(true);
    expect(problemOf(rest)).toContain('startTile');
  });
});
