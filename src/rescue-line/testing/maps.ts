/** A tile of the map editor, as its file has it. */
export interface FileTile {
  readonly [name: string]: unknown;
}

const ACROSS = { left: 'right', right: 'left' };
const BEND = { left: 'bottom', bottom: 'left' };

/** A tile with this picture and these ways. */
export const tileOf = (
  image: string,
  rot: number,
  paths: Readonly<Record<string, string>>,
  more: { readonly type?: object; readonly items?: object } & Readonly<Record<string, unknown>> = {},
): FileTile => {
  const { type = {}, items = {}, ...others } = more;
  return {
    rot,
    tileType: { image: `${image}.png`, gaps: 0, intersections: 0, seesaw: 0, paths, ...type },
    items: { obstacles: 0, speedbumps: 0, rampPoints: false, ...items },
    ...others,
  };
};

/** A straight tile. */
export const straight = (rot = 0, more: Parameters<typeof tileOf>[3] = {}): FileTile =>
  tileOf('tile-0', rot, ACROSS, more);

/** A quarter of a circle, from left to bottom. */
export const bend = (rot = 0): FileTile => tileOf('tile-12', rot, BEND);

/** The last tile. */
export const exit = (rot = 0): FileTile => tileOf('exit', rot, { bottom: 'top' });

/** A map with these tiles. */
export const mapFile = (tiles: object, more: object = {}): Readonly<Record<string, unknown>> => ({
  ...{ name: 'Demo', length: 3, width: 3, height: 1, duration: 480, finished: true, tileSet: 'x' },
  victims: { live: 0, dead: 0 },
  startTile: { x: 0, y: 0, z: 0 },
  startTile2: { x: -1, y: -1, z: -1 },
  tiles,
  ...more,
});

/** Seven tiles: a gap, a checkpoint, an obstacle, the end. A perfect run brings 125 points by the rules of 2025. */
export const demoMap = (): Readonly<Record<string, unknown>> =>
  mapFile({
    '0,0,0': straight(),
    '1,0,0': tileOf('tile-11_2', 0, ACROSS, { type: { gaps: 1 } }),
    '2,0,0': bend(),
    '2,1,0': straight(90, { checkPoint: true }),
    '2,2,0': bend(90),
    '1,2,0': straight(0, { items: { obstacles: 1 } }),
    '0,2,0': exit(270),
  });
