import { describe, expect, it } from 'vitest';
import { createRng, type Rng } from '#core/rng';
import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import { parseScene } from '#scene/parse';
import { sceneLimits, type Scene } from '#scene/scene';
import { asKept } from '#scene/groups';
import { serializeScene } from '#scene/serialize';
import { footprint } from '../testing/desk';
import { randomObject } from '#scene/testing/random-scene';
import { randomCourse, randomDrag, randomOptions, randomSelection, walk } from '../testing/random-course';
import type { Drag, Tool, ToolContext } from './tool';
import { tools } from './tools';

const all = Object.values(tools);

/** The ruler changes nothing, and hardly any selection is just a line: see `points-tool.test.ts`. */
const SELDOM: readonly string[] = ['ruler', 'points'];

function frozen<T>(value: T): T {
  if (typeof value === 'object' && value !== null && !Object.isFrozen(value)) {
    Object.freeze(value);
    Object.values(value).forEach(frozen);
  }
  return value;
}

const contextOf = (rng: Rng, scene: Scene): ToolContext =>
  frozen({ scene, selection: randomSelection(rng, scene), options: randomOptions(rng), footprint });

/** Checks all that must hold of what a tool does; returns the course after it. */
function checked(tool: Tool, drag: Drag, context: ToolContext, name: string): Scene {
  const { scene } = context;
  const edit = tool.edit(drag, context);
  if (edit === null) return scene;
  expect(editProblem(scene, edit), name).toBeNull();
  const after = applyEdit(scene, edit);
  const parsed = parseScene(serializeScene(after));
  expect('problem' in parsed ? parsed.problem : '', name).toBe('');
  expect('scene' in parsed && parsed.scene, name).toEqual(asKept(after));
  return after;
}

describe('tools', () => {
  it.each(all.map((tool) => [tool.id, tool] as const))(
    '%s: after any drag the course is one that can be saved and loaded',
    (id, tool) => {
      const rng = createRng(7).fork(id);
      let done = 0;
      for (let run = 0; run < 400; run += 1) {
        const scene = frozen(randomCourse(rng, run % 20));
        const context = contextOf(rng, scene);
        const drag = frozen(randomDrag(rng));
        const after = checked(tool, drag, context, `${id}, run ${run}`);
        if (after !== scene) done += 1;
        const selection = tool.select?.(drag, context, after);
        for (const one of selection?.ids ?? []) expect(after.objects.some((object) => object.id === one)).toBe(true);
        const marks = [...(tool.marks?.(drag, context, true) ?? []), ...(tool.marks?.(drag, context, false) ?? [])];
        expect(JSON.stringify(marks)).not.toMatch(/"[xy]":null/);
      }
      expect(done).toBeGreaterThan(SELDOM.includes(id) ? -1 : 40);
    },
  );

  it.each(all.map((tool) => [tool.id, tool] as const))(
    '%s: says the same of a drag whether or not it was asked on the way',
    (id, tool) => {
      const rng = createRng(11).fork(id);
      for (let run = 0; run < 12; run += 1) {
        const scene = randomCourse(rng, 15);
        const context = contextOf(rng, scene);
        const path = walk(rng, { x: 300, y: 300 }, 300, 12);
        const drag = { path, free: false, adds: false, reachMm: 8 };
        for (let length = 1; length < path.length; length += 7)
          tool.edit({ ...drag, path: path.slice(0, length) }, context);
        const asked = tool.edit(drag, context);
        const fresh = { ...drag, path: path.map(({ x, y }) => ({ x, y })) };
        expect(asked).toEqual(tool.edit(fresh, { ...context, scene: { ...scene } }));
      }
    },
  );

  it.each(all.map((tool) => [tool.id, tool] as const))('%s: manages a drag with 20,000 places', (id, tool) => {
    const rng = createRng(3).fork(id);
    const scene = frozen(randomCourse(rng, 30));
    const context = contextOf(rng, scene);
    const path = walk(rng, { x: 600, y: 450 }, 20_000, 8);
    checked(tool, { path, free: false, adds: false, reachMm: 8 }, context, id);
  });

  it.each(all.map((tool) => [tool.id, tool] as const))('%s: adds nothing to a course that is full', (id, tool) => {
    const rng = createRng(5).fork(id);
    const objects = Array.from({ length: sceneLimits.objects }, (_, index) => randomObject(rng, `o-${index}`));
    const scene = frozen({ ...randomCourse(rng, 0), objects });
    for (let run = 0; run < 12; run += 1) {
      const after = checked(tool, randomDrag(rng), contextOf(rng, scene), `${id}, run ${run}`);
      expect(after.objects.length).toBeLessThanOrEqual(sceneLimits.objects);
    }
  });
});
