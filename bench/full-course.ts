import { exactCos, exactSin } from '#core/exact-math';
import { createRng } from '#core/rng';
import type { Point, Scene, SceneObject, Stroke } from '#scene/scene';

/** How much the course of `fullCourse` holds. */
export const FULL = { objects: 500, points: 20_000 } as const;

const STROKES = 200;
export const SIZE: Point = [3000, 2000];

/**
 * A course as full as budgets are promised for: a closed line to follow in the middle of scribbles, blocks, walls, zones and
 * obstacles, with a task. Always the same.
 *
 * @param start a course whose line, robot and board it takes
 * @param most how many points its lines have together
 */
export function fullCourse(start: Scene, most: number = FULL.points): Scene {
  const rng = createRng(20_000);
  const between = (low: number, high: number): number => Math.round(low + (high - low) * rng.unit());
  const line = start.objects.filter((object): object is Stroke => object.type === 'stroke');
  const objects: SceneObject[] = [];
  let points = line.reduce((sum, stroke) => sum + stroke.points.length, 0);
  for (let i = line.length; i < STROKES; i++) {
    const count = Math.floor((most - points) / (STROKES - i));
    points += count;
    objects.push(scribble(`scribble-${String(i)}`, count, between));
  }
  objects.push(...line);
  for (let i = objects.length; i < FULL.objects; i++) objects.push(thing(i, placeOf(i - STROKES), between));
  return { ...start, size: SIZE, task: { seconds: 3600, noTouch: false }, objects };
}

/** A wild curve of steps of 6 mm. */
function scribble(id: string, count: number, between: (low: number, high: number) => number): Stroke {
  let [x, y] = [between(0, SIZE[0]), between(900, SIZE[1])];
  let heading = between(0, 6);
  const points: Point[] = [];
  for (let i = 0; i < count; i++) {
    heading += between(-40, 40) / 100;
    x = Math.min(Math.max(x + 6 * exactCos(heading), 0), SIZE[0]);
    y = Math.min(Math.max(y + 6 * exactSin(heading), 0), SIZE[1]);
    points.push([Math.round(x), Math.round(y)]);
  }
  return { type: 'stroke', id, points, width: between(3, 30), color: 'black' };
}

/** Side of the square that each thing has for itself, and where the first of them begins: right of where the robot drives. */
const CELL = 100;
const FIRST: Point = [1300, 50];
const ROWS = 19;

const placeOf = (i: number): Point => [
  FIRST[0] + CELL * (Math.floor(i / ROWS) + 0.5),
  FIRST[1] + CELL * ((i % ROWS) + 0.5),
];

/** The middle of one of the things. */
export const aThingAt: Point = placeOf(0);

function thing(i: number, at: Point, between: (low: number, high: number) => number): SceneObject {
  const id = `thing-${String(i)}`;
  const box = { id, at, size: [between(20, 60), between(20, 60)] as Point, angle: 45 * (i % 8) };
  const zone = { ...box, round: i % 2 === 0, number: 0, blocks: 0 };
  // Five moving obstacles that push whatever is in their path.
  if (i % 60 === 7) return { ...box, type: 'mover', to: [at[0], at[1] + 300], speed: 100, spiked: false };
  switch (i % 8) {
    case 0:
    case 1:
    case 2:
      return { type: 'wall', id, from: [at[0] - 40, at[1]], to: [at[0] + between(0, 40), at[1]], thickness: 10 };
    case 3:
    case 4:
      return { ...box, type: 'fixed-block' };
    case 5:
    case 6:
      return { ...zone, type: i % 2 === 0 ? 'forbidden' : 'target', blocks: i % 2 };
    default:
      return { ...box, type: 'block' };
  }
}
