/** Writes a course as a world of WebTigerPython: see `world.ts`. */
import { degOf } from '#core/angle';
import { exactAtan2 } from '#core/exact-math';
import type { Block, Scene, SceneObject, Wall } from '#scene/scene';

import { note, type Note, type NoteCode } from './note';
import {
  BLOCK_MM,
  degOfEighths,
  eighthsOfDeg,
  headingOfStart,
  startOfHeading,
  UNIT_MM,
  WALL_MM,
  type WorldValue,
} from './world';

/** A course as a world, and what of it a world cannot hold. */
export interface WrittenWorld {
  readonly world: WorldValue;
  readonly notes: readonly Note[];
}

/** Writes walls, blocks, start and arena. The rest is left out and told; so is what becomes otherwise. */
export function writeWorld(scene: Scene): WrittenWorld {
  const { size, robot, objects } = scene;
  const walls = objects.filter((object) => object.type === 'wall');
  const blocks = objects.filter(isBlock);
  const [x, y] = placeOf(robot.at[0], robot.at[1], scene);
  const eighths = startOfHeading(robot.heading);
  const world: WorldValue = {
    StartBox: [x, y, eighths],
    ...(blocks.length > 0 ? { Blockobjects: blocks.map((block) => blockEntry(block, scene)) } : {}),
    ...(walls.length > 0 ? { Wallobjects: walls.map((wall) => wallEntry(wall, scene)) } : {}),
    playgroundSize: [size[0] / UNIT_MM, size[1] / UNIT_MM],
  };
  const high = [...walls, ...blocks].filter(({ height }) => height !== undefined);
  const heights = counted('heights', high);
  const turned = (headingOfStart(eighths) - robot.heading) % 360 !== 0;
  const from = robot.heading;
  const start = turned ? [note('robotHeading', { from, to: headingOfStart(eighths) })] : [];
  return {
    world,
    notes: [...leftOut(objects), ...changedWalls(walls), ...changedBlocks(blocks), ...heights, ...start],
  };
}

const isBlock = (object: SceneObject): object is Block => object.type === 'block' || object.type === 'fixed-block';

/** Thousandths of a unit are kept: an end of a slanting wall must come back to its millimetre. */
const inThousandths = (units: number): number => Math.round(units * 1000) / 1000 + 0;

const placeOf = (xMm: number, yMm: number, { size }: Scene): readonly [x: number, y: number] => [
  inThousandths(xMm / UNIT_MM),
  inThousandths((size[1] - yMm) / UNIT_MM),
];

function wallEntry({ from, to }: Wall, scene: Scene): readonly number[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const place = placeOf(from[0] + dx / 2, from[1] + dy / 2, scene);
  return [...place, inThousandths(Math.sqrt(dx * dx + dy * dy) / UNIT_MM), eighthsOfDeg(degOf(exactAtan2(dy, dx)))];
}

const blockEntry = ({ type, at, angle }: Block, scene: Scene): readonly (number | boolean)[] => [
  ...placeOf(at[0], at[1], scene),
  type === 'block',
  eighthsOfDeg(angle),
];

/** The kinds of objects that a world does not have. */
const LEFT_OUT: Readonly<Partial<Record<SceneObject['type'], NoteCode>>> = {
  stroke: 'strokes',
  target: 'zones',
  checkpoint: 'zones',
  forbidden: 'zones',
  spikes: 'spikes',
  mover: 'movers',
  label: 'labels',
  start: 'starts',
};
const WRITTEN: readonly string[] = ['wall', 'block', 'fixed-block'];

function leftOut(objects: readonly SceneObject[]): readonly Note[] {
  const counts = new Map<NoteCode, number>();
  for (const { type } of objects) {
    const code = LEFT_OUT[type] ?? 'otherObjects';
    if (!WRITTEN.includes(type)) counts.set(code, (counts.get(code) ?? 0) + 1);
  }
  const edited = objects.filter(({ lock, group }) => lock !== undefined || group !== undefined);
  return [...Array.from(counts, ([code, count]) => note(code, { count })), ...counted('editing', edited)];
}

const counted = (code: NoteCode, found: readonly unknown[], params: Note['params'] = {}): readonly Note[] =>
  found.length > 0 ? [note(code, { ...params, count: found.length })] : [];

const changedWalls = (walls: readonly Wall[]): readonly Note[] => [
  ...counted('wallAngles', walls.filter(isSlanting)),
  ...counted(
    'wallThickness',
    walls.filter(({ thickness }) => thickness !== WALL_MM),
    { mm: WALL_MM },
  ),
];

function isSlanting({ from, to }: Wall): boolean {
  const [dx, dy] = [Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])];
  return dx !== 0 && dy !== 0 && dx !== dy;
}

const changedBlocks = (blocks: readonly Block[]): readonly Note[] => [
  ...counted(
    'blockAngles',
    blocks.filter(({ angle }) => degOfEighths(eighthsOfDeg(angle)) !== angle),
  ),
  ...counted(
    'blockSizes',
    blocks.filter(({ size }) => size.some((edge) => edge !== BLOCK_MM)),
    { mm: BLOCK_MM },
  ),
  ...counted(
    'blockShapes',
    blocks.filter(({ round, corners }) => round === true || corners !== undefined),
  ),
];
