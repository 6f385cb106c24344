import { isDeepStrictEqual } from 'node:util';
import type { Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { describe, it } from 'vitest';
import { editProblem } from './check-edit';
import { applyEdit, type SceneEdit } from './edit';
import { advanced, HISTORY_STEPS, historyOf, redone, undone } from './history';
import { inverse } from './inverse';
import { asKept } from './groups';
import { parseScene } from './parse';
import { defaultScene, type Scene } from './scene';
import { serializeScene } from './serialize';
import { forManySeeds, inPercent, wholeFrom } from './testing/fuzz';
import { randomEdit, randomObject } from './testing/random-scene';

/** The ids of the objects that an edit names. */
function touchedIds(edit: SceneEdit, scene: Scene): ReadonlySet<string> {
  switch (edit.type) {
    case 'remove':
      return new Set(edit.ids);
    case 'replace':
      return new Set(edit.changes.map(({ id }) => id));
    case 'clear':
      return new Set(scene.objects.map(({ id }) => id));
    case 'all':
      return new Set(edit.edits.flatMap((inner) => [...touchedIds(inner, scene)]));
    case 'add':
    case 'robot':
    case 'course':
      return new Set();
    default:
      return edit satisfies never;
  }
}

/** Expects that everything an edit does not name is the very same object, in the same order. */
function expectUntouchedSame(before: Scene, edit: SceneEdit, after: Scene): void {
  const touched = touchedIds(edit, before);
  const untouched = before.objects.filter(({ id }) => !touched.has(id));
  const there = new Set(before.objects);
  const left = after.objects.filter((object) => there.has(object) && !touched.has(object.id));
  if (left.length !== untouched.length || left.some((object, index) => object !== untouched[index]))
    throw new Error(`${edit.type} changed an object that it does not name`);
}

const randomScene = (rng: Rng): Scene => ({
  ...defaultScene(),
  objects: Array.from({ length: 8 }, (_, index) => randomObject(rng, `o${index}`)),
});

function play(rng: Rng, steps: number): void {
  const start = randomScene(rng);
  let history = historyOf(start);
  /** The model: all scenes in a row, and which is the present one. */
  let scenes: Scene[] = [start];
  let present = 0;
  for (let step = 0; step < steps; step++) {
    const what = rng.u32() % 10;
    if (what < 2) {
      history = undone(history);
      present = Math.max(0, present - 1);
    } else if (what < 4) {
      history = redone(history);
      present = Math.min(scenes.length - 1, present + 1);
    } else {
      const edit = randomEdit(rng, history.present);
      const problem = editProblem(history.present, edit);
      if (problem) throw new Error(problem.message);
      const after = applyEdit(history.present, edit);
      expectUntouchedSame(history.present, edit, after);
      const before = history;
      history = advanced(history, edit);
      if (history !== before) scenes = [...scenes.slice(0, ++present), after];
      if (present > HISTORY_STEPS) scenes.shift();
      present = Math.min(present, HISTORY_STEPS);
    }
    if (!isDeepStrictEqual(history.present, scenes[present])) throw new Error(`after step ${step} it is another scene`);
  }
  if (!isDeepStrictEqual(parseScene(serializeScene(history.present)), { scene: asKept(history.present) }))
    throw new Error('the last scene is another one after saving');
  for (let step = scenes.length; step > 0; step--) history = undone(history);
  if (!isDeepStrictEqual(history.present, scenes[0]))
    throw new Error('undoing everything does not lead to the beginning');
  for (let step = scenes.length; step > 0; step--) history = redone(history);
  if (!isDeepStrictEqual(history.present, scenes.at(-1)))
    throw new Error('redoing everything does not lead to the end');
}

describe('editing, undoing and redoing in any order', () => {
  it(`ends where it must, and changes only what each edit names: ${fuzzRuns} sequences`, () => {
    forManySeeds(fuzzRuns, (rng) => play(rng, inPercent(rng, 99) ? wholeFrom(rng, 1, 30) : 60));
  });

  it('also works beyond the steps that are kept', () => {
    forManySeeds(3, (rng) => play(rng, 4 * HISTORY_STEPS));
  });
});

describe('the inverse of an edit', () => {
  it(`suits the course after it and leads back to the same one: ${fuzzRuns} edits`, () => {
    forManySeeds(fuzzRuns, (rng) => {
      const before = randomScene(rng);
      const edit = editsInARow(rng, before);
      const back = inverse(before, edit);
      const after = applyEdit(before, edit);
      const problem = editProblem(after, back);
      if (problem) throw new Error(problem.message);
      if (!isDeepStrictEqual(applyEdit(after, back), before)) throw new Error(JSON.stringify(back));
      if (!isDeepStrictEqual(applyEdit(before, inverse(after, back)), after)) throw new Error('the inverse of it');
    });
  });
});

/** One edit, or several in one. */
function editsInARow(rng: Rng, scene: Scene): SceneEdit {
  const edits: SceneEdit[] = [];
  let now = scene;
  for (let count = wholeFrom(rng, 1, 4); count > 0; count--) {
    const edit = randomEdit(rng, now, 2);
    edits.push(edit);
    now = applyEdit(now, edit);
  }
  return edits.length === 1 ? randomEdit(rng, scene) : { type: 'all', edits };
}
