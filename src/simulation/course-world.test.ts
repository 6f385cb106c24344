import { describe, expect, it } from 'vitest';
import { createRng, type Rng } from '#core/rng';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { editProblem } from '#scene/check-edit';
import { defaultScene, strokeColors, type Point, type Scene, type SceneObject } from '#scene/scene';
import { hashOf, testChassis } from '#world/testing/rig';
import { movableIds } from './at-once';
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
      const color = strokeColors[whole(0, strokeColors.length)] ?? 'black';
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
