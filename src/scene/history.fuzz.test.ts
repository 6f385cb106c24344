import { isDeepStrictEqual } from 'node:util';
import type { Rng } from '#core/rng';
import { describe, it } from 'vitest';
import { editProblem } from './check-edit';
import { applyEdit, type SceneEdit } from './edit';
import { editBetween } from './edit-between';
import { advanced, HISTORY_STEPS, historyOf, redone, undone } from './history';
import { parseScene } from './parse';
import { defaultScene, type Scene } from './scene';
import { serializeScene } from './serialize';
import { forManySeeds, fuzzRuns, inPercent, wholeFrom } from './testing/fuzz';
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

/** What an edit does not name stays the very same object, in the same order. */
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
      history = advanced(history, after);
      if (after !== scenes[present]) scenes = [...scenes.slice(0, ++present), after];
      if (present > HISTORY_STEPS) scenes.shift();
      present = Math.min(present, HISTORY_STEPS);
    }
    if (history.present !== scenes[present]) throw new Error(`after step ${step} it is another scene`);
  }
  if (!isDeepStrictEqual(parseScene(serializeScene(history.present)), { scene: history.present }))
    throw new Error('the last scene is another one after saving');
  for (let step = scenes.length; step > 0; step--) history = undone(history);
  if (history.present !== scenes[0]) throw new Error('undoing everything does not lead to the beginning');
  for (let step = scenes.length; step > 0; step--) history = redone(history);
  if (history.present !== scenes.at(-1)) throw new Error('redoing everything does not lead to the end');
}

describe('editing, undoing and redoing in any order', () => {
  it(`ends where it must, and changes only what each edit names: ${fuzzRuns} sequences`, () => {
    forManySeeds(fuzzRuns, (rng) => play(rng, inPercent(rng, 99) ? wholeFrom(rng, 1, 30) : 60));
  });

  it('also beyond the steps that are kept', () => {
    forManySeeds(3, (rng) => play(rng, 4 * HISTORY_STEPS));
  });

  it(`can be told a run as one edit that leads from one course to the other: ${fuzzRuns} pairs`, () => {
    forManySeeds(fuzzRuns, (rng) => {
      const before = randomScene(rng);
      let after = before;
      for (let count = wholeFrom(rng, 1, 4); count > 0; count--) after = applyEdit(after, randomEdit(rng, after));
      for (const [from, to] of [[before, after] as const, [after, before] as const]) {
        const edit = editBetween(from, to);
        const problem = edit && editProblem(from, edit);
        if (problem) throw new Error(problem.message);
        if (!isDeepStrictEqual(edit ? applyEdit(from, edit) : from, to)) throw new Error(JSON.stringify(edit));
      }
    });
  });
});
