import { describe, expect, it } from 'vitest';
import { exactTan } from '#core/exact-math';
import { createRng, type Rng } from '#core/rng';
import { SR04_CONE } from '#robots/sonar';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { editProblem } from '#scene/check-edit';
import { paintColors } from '#scene/paint/paint';
import { defaultScene, type Point, type Scene, type SceneObject } from '#scene/scene';
import type { DepthView } from '#world/probes/depth-grid';
import { hashOf, testChassis } from '#world/testing/rig';
import { movableIds } from '../at-once';
import { CourseWorld } from './course-world';

/** Any kind of object, anywhere in the arena, with one of few ids, so that they meet often. */
function anything(rng: Rng): SceneObject {
  const whole = (low: number, high: number): number => low + Math.floor((high - low) * rng.unit());
  const point = (): Point => [whole(0, 1200), whole(0, 900)];
  const id = `o${String(whole(0, 20))}`;
  const box = { id, at: point(), size: [whole(20, 90), whole(20, 90)] as Point, angle: 45 * whole(0, 8) };
  switch (whole(0, 8)) {
    case 0:
      return { type: 'wall', id, from: point(), to: [whole(0, 1200), 901], thickness: 10 };
    case 1:
      return { ...box, type: 'fixed-block' };
    case 2:
      return { ...box, type: 'mover', to: point(), speed: whole(20, 500), spiked: false };
    case 3:
    case 4:
      return { ...box, type: 'block' };
    default: {
      const color = paintColors[whole(0, paintColors.length)] ?? 'black';
      return { type: 'stroke', id, points: Array.from({ length: whole(1, 6) }, point), width: whole(2, 60), color };
    }
  }
}

function anyEdit(rng: Rng, course: Scene): SceneEdit {
  const some = course.objects[Math.floor(course.objects.length * rng.unit())];
  const roll = rng.unit();
  if (roll < 0.02) return { type: 'clear' };
  if (roll < 0.06) return { type: 'all', edits: [{ type: 'clear' }, { type: 'add', objects: course.objects }] };
  if (some === undefined || roll < 0.5) return { type: 'add', objects: [anything(rng)] };
  if (roll < 0.7) return { type: 'remove', ids: [some.id] };
  const by = rng.unit() < 0.5 ? [{ ...anything(rng), id: some.id }] : [{ ...anything(rng), id: 'new' }, some];
  return { type: 'replace', changes: [{ id: some.id, by }] };
}

/** A robot drives around among random edits, one every 0.2 s. */
function wildRun(
  seed: number,
  edits: number,
  after?: (world: CourseWorld, course: Scene, began: Scene) => void,
): number[] {
  const rng = createRng(seed);
  const objects = Array.from({ length: 12 }, (_, i) => ({ ...anything(rng), id: `o${String(i)}` }));
  const began: Scene = { ...defaultScene(), objects };
  let course = began;
  const arena = new CourseWorld(began);
  const robot = arena.world.addChassis(testChassis(), { xMm: 600, yMm: 450, headingRad: 0 });
  const numbers: number[] = [];
  for (let i = 0; i < edits; i++) {
    const edit = anyEdit(rng, course);
    if (editProblem(course, edit) === null) {
      course = structuredClone(applyEdit(course, edit));
      arena.take(course);
      after?.(arena, course, began);
    }
    robot.setDuty(0, 2 * rng.unit() - 0.7);
    robot.setDuty(1, 2 * rng.unit() - 0.7);
    for (let step = 0; step < 50; step++) arena.world.step();
    for (const { xMm, yMm, headingRad } of [robot.pose(), ...Object.values(arena.blockPoses())])
      numbers.push(xMm, yMm, headingRad);
  }
  return numbers;
}

describe('a world that follows its course through random edits', { timeout: 60_000 }, () => {
  it.each([1, 2, 3])('has the floor and the movable blocks that it should have, seed %i', (seed) => {
    const rng = createRng(seed + 100);
    let movable: ReadonlySet<string> = new Set();
    let edits = 0;
    wildRun(seed, 300, (arena, course, began) => {
      movable = movableIds(edits++ === 0 ? movableIds(movable, began, began) : movable, began, course);
      expect(Object.keys(arena.blockPoses()).sort()).toEqual([...movable].sort());
      const fresh = new CourseWorld(course);
      for (let i = 0; i < 30; i++) {
        const spot = { x: 1200 * rng.unit(), y: 900 * rng.unit() };
        expect(arena.world.reflectanceAt(spot, 3)).toBeCloseTo(fresh.world.reflectanceAt(spot, 3), 9);
      }
    });
  });

  it('comes out the same again to the last bit, and nothing gets lost in nowhere', () => {
    const numbers = wildRun(4, 300);
    expect(hashOf(wildRun(4, 300))).toBe(hashOf(numbers));
    for (let i = 0; i < numbers.length; i += 3) {
      expect(numbers[i]).toBeGreaterThan(-100);
      expect(numbers[i]).toBeLessThan(1300);
      expect(numbers[i + 1]).toBeGreaterThan(-100);
      expect(numbers[i + 1]).toBeLessThan(1000);
    }
  });
});

describe('heights of things', () => {
  const TANGENTS = [26.25, 18.75, 11.25, 3.75, -3.75, -11.25, -18.75, -26.25].map((deg) => exactTan((deg * Math.PI) / 180)); // prettier-ignore
  /** A lens 104 mm above the floor that looks straight ahead, in one column of eight rows. */
  const LENS: DepthView = { heightMm: 104, columns: [0], rows: TANGENTS, rangeMm: 400, leastFloorSlope: 0.1 };
  const box = { id: 'it', at: [350, 450] as Point, size: [100, 100] as Point, angle: 0 };
  /** One of each kind, with its near side 300 mm from the left edge. */
  const things: readonly SceneObject[] = [
    { type: 'wall', id: 'it', from: [305, 200], to: [305, 700], thickness: 10 },
    { ...box, type: 'block' },
    { ...box, type: 'fixed-block' },
    { ...box, type: 'spikes' },
    { ...box, type: 'mover', to: box.at, speed: 100, spiked: false },
  ];
  const courseOf = (object: SceneObject): Scene => ({ ...defaultScene(), objects: [object] });
  const cone = { ...SR04_CONE, rangeMm: 400 };
  const heard = ({ world }: CourseWorld): number => world.distanceCone({ x: 100, y: 450 }, 0, cone).distanceMm;
  const seen = ({ world }: CourseWorld): readonly string[] =>
    world
      .depthGrid({ x: 100, y: 450 }, 0, LENS)
      .map(({ depthMm, isFloor }) => `${String(Math.round(depthMm))}${isFloor ? ' floor' : ''}`);

  it.each(things)('let an ultrasonic sensor miss a low $type, which a depth grid sees in its lower rows', (thing) => {
    expect(heard(new CourseWorld(courseOf(thing)))).toBeCloseTo(200, 9);
    const low = new CourseWorld(courseOf({ ...thing, height: 30 } as SceneObject));
    expect(heard(low)).toBe(Infinity);
    // The row at −18.75° comes down to 36 mm at the front, and to the top of what is 100 mm deep at 218 mm.
    const isDeep = thing.type !== 'wall';
    const rows = [...Array<string>(6).fill('Infinity'), isDeep ? '218' : '306 floor', '200'];
    expect(seen(low)).toEqual(rows);
    expect(heard(new CourseWorld(courseOf({ ...thing, height: 40 } as SceneObject)))).toBeCloseTo(200, 9);
  });

  it('change with a block while a run goes on, with all else at the next start', () => {
    for (const thing of things) {
      const arena = new CourseWorld(courseOf(thing));
      arena.take(courseOf({ ...thing, height: 30 } as SceneObject));
      expect(heard(arena)).toBe(thing.type === 'block' ? Infinity : heard(new CourseWorld(courseOf(thing))));
      arena.take(courseOf(thing));
      expect(heard(arena)).toBeCloseTo(200, 9);
    }
  });

  it('are no help to a robot: it runs into a wall of 5 mm as into any other', () => {
    const arena = new CourseWorld(courseOf({ ...things[0], height: 5 } as SceneObject));
    const robot = arena.world.addChassis(testChassis(), { xMm: 150, yMm: 450, headingRad: 0 });
    for (const wheel of [0, 1] as const) robot.setDuty(wheel, 0.8);
    for (let step = 0; step < 500; step++) arena.world.step();
    expect(robot.pose().xMm).toBeLessThan(300 - 59 + 1);
  });
});

describe('a tag that is stuck to a block', () => {
  const VIEW = { heightMm: 90, tiltRad: 0.26, acrossTan: 0.42, uprightTan: 0.32, columns: 8, rows: 6, rangeMm: 3000 };
  const block: SceneObject = { type: 'block', id: 'block', at: [700, 450], size: [60, 60], angle: 0 };
  const tag: SceneObject = { type: 'tag', id: 'tag', at: [670, 450], number: 9, side: 60, angle: 180 };
  const course = (...objects: readonly SceneObject[]): Scene => ({ ...defaultScene(), size: [2000, 900], objects });
  /** The tag in the picture of a camera at (400 | 450): the middle of it, in shares; `null`: it sees none. */
  const middle = (arena: CourseWorld): number | null => {
    const [one] = arena.world.camera({ x: 400, y: 450 }, 0, VIEW).tags();
    return one === undefined ? null : one.corners.reduce((sum, { x }) => sum + x / 4, 0);
  };

  it('goes along with it, and stays behind when the block is taken away', () => {
    const arena = new CourseWorld(course(tag, block));
    expect(middle(arena)).toBeCloseTo(0.5, 9);
    arena.block('block')?.place({ xMm: 760, yMm: 500, headingRad: 0 });
    expect(middle(arena)).toBeLessThan(0.4);
    arena.block('block')?.place({ xMm: 760, yMm: 450, headingRad: Math.PI });
    expect(middle(arena)).toBeNull();
    arena.take(course(tag));
    expect(middle(arena)).toBeCloseTo(0.5, 9);
  });

  it('stands where it is put in a run, alone again', () => {
    const arena = new CourseWorld(course(block, tag));
    arena.take(course(block, { ...tag, at: [600, 450] }));
    arena.block('block')?.place({ xMm: 760, yMm: 500, headingRad: 0 });
    expect(middle(arena)).toBeCloseTo(0.5, 9);
  });
});
