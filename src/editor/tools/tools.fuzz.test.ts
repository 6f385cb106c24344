import { isDeepStrictEqual } from 'node:util';
import { describe, it } from 'vitest';
import type { Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { parseScene } from '#scene/parse';
import { inverse } from '#scene/inverse';
import type { Scene } from '#scene/scene';
import { asKept } from '#scene/groups';
import { serializeScene } from '#scene/serialize';
import { forManySeeds, inPercent, oneOf, wholeFrom } from '#scene/testing/fuzz';
import { nudged, turnedByEighths } from '../arrange';
import { aligned, distributed } from '../arranging/align';
import { grouped, locked, ungrouped, unlocked, withoutLock } from '../arranging/hold';
import { mirrored } from '../arranging/mirror';
import { reordered } from '../arranging/order';
import { sizedAlike } from '../arranging/same-size';
import { copied, copiedBy, duplicated, pasted } from '../clipboard';
import { commonFields, withCommonField } from '../common-fields';
import { withSize } from '../course-edits';
import { describeEdit } from '../describe-edit';
import { resized } from '../robot-size';
import { removed } from '../selection';
import { footprint } from '../testing/desk';
import { randomCourse, randomDrag, randomOptions, randomSelection } from '../testing/random-course';
import type { Selection } from './tool';
import { tools } from './tools';

/** Gestures in a course until another one is begun. */
const GESTURES = 25;

function withTool(rng: Rng, scene: Scene, selection: Selection): SceneEdit | null {
  const tool = oneOf(rng, Object.values(tools));
  return tool.edit(randomDrag(rng), { scene, selection, options: randomOptions(rng), footprint });
}

function withKeys(rng: Rng, scene: Scene, selection: Selection): SceneEdit | null {
  switch (wholeFrom(rng, 0, 8)) {
    case 0:
      return nudged(scene, selection, wholeFrom(rng, -500, 500), wholeFrom(rng, -500, 500), footprint);
    case 1:
      return turnedByEighths(scene, selection, wholeFrom(rng, -9, 9), footprint);
    case 2:
      return copies(rng, scene, selection);
    case 3:
      return removed(scene, selection);
    case 4:
      return arranged(rng, scene, selection);
    case 5:
      return changedTogether(rng, scene, selection);
    case 6:
      return held(rng, scene, selection);
    case 7:
      return resized(scene, oneOf(rng, [1, -1] as const), footprint);
    default:
      return withSize(scene, [wholeFrom(rng, 100, 3000), wholeFrom(rng, 100, 3000)], footprint);
  }
}

const held = (rng: Rng, scene: Scene, selection: Selection): SceneEdit | null =>
  oneOf(rng, [locked, unlocked, grouped, ungrouped])(scene, selection);

function copies(rng: Rng, scene: Scene, selection: Selection): SceneEdit | null {
  const place = { x: wholeFrom(rng, -300, 1500), y: wholeFrom(rng, -300, 1200) };
  const clip = copied(scene, selection);
  const last = { ids: selection.ids, from: place };
  switch (wholeFrom(rng, 0, 2)) {
    case 0:
      return clip && (pasted(scene, clip, inPercent(rng, 50) ? place : null, footprint)?.edit ?? null);
    case 1:
      return duplicated(scene, selection, inPercent(rng, 50) ? last : null, footprint)?.edit ?? null;
    default:
      return copiedBy(scene, selection, place)?.edit ?? null;
  }
}

function arranged(rng: Rng, scene: Scene, selection: Selection): SceneEdit | null {
  const axis = oneOf(rng, ['x', 'y'] as const);
  switch (wholeFrom(rng, 0, 4)) {
    case 0:
      return reordered(scene, selection, oneOf(rng, ['front', 'forward', 'backward', 'back'] as const));
    case 1:
      return aligned(scene, selection, oneOf(rng, ['left', 'upright', 'right', 'top', 'level', 'bottom'] as const), footprint); // prettier-ignore
    case 2:
      return distributed(scene, selection, axis, footprint);
    case 3:
      return mirrored(scene, selection, axis, footprint);
    default:
      return sizedAlike(scene, selection);
  }
}

/** Any value that a field which all have in common may have, and some that it may not. */
function changedTogether(rng: Rng, scene: Scene, selection: Selection): SceneEdit | null {
  const fields = commonFields(scene, selection);
  if (fields.length === 0) return null;
  const { field } = oneOf(rng, fields);
  const value = field.kind === 'choice' ? oneOf<string>(rng, field.choices) : wholeFrom(rng, -100, 900);
  return withCommonField(scene, selection, field.name, field.kind === 'switch' ? inPercent(rng, 50) : value);
}

/** Checks that locked things are unchanged apart from their lock and their place in the order. */
function assertLocksHold(before: Scene, { objects }: Scene): void {
  const now = new Map(objects.map((object) => [object.id, object]));
  for (const object of before.objects) {
    if (!object.lock || isDeepStrictEqual(now.get(object.id), object)) continue;
    if (isDeepStrictEqual(now.get(object.id), withoutLock(object))) continue;
    throw new Error(`a locked object was changed: ${JSON.stringify(object)}`);
  }
}

function assertTakenBack(before: Scene, edit: SceneEdit, after: Scene): void {
  if (!isDeepStrictEqual(applyEdit(after, inverse(before, edit)), before))
    throw new Error(`not taken back: ${JSON.stringify(edit)}`);
}

/** One course after the other, each edited for a while in any way. */
function play(rng: Rng): void {
  let scene = randomCourse(rng, wholeFrom(rng, 0, 12));
  for (let gesture = 0; gesture < GESTURES; gesture += 1) {
    const selection = randomSelection(rng, scene);
    const edit = inPercent(rng, 70) ? withTool(rng, scene, selection) : withKeys(rng, scene, selection);
    if (edit === null) continue;
    const problem = editProblem(scene, edit);
    if (problem) throw new Error(`${problem.message} ${JSON.stringify(edit)}`);
    describeEdit(scene, edit);
    const after = applyEdit(scene, edit);
    assertLocksHold(scene, after);
    assertTakenBack(scene, edit, after);
    scene = after;
  }
  const parsed = parseScene(serializeScene(scene));
  if ('problem' in parsed) throw new Error(parsed.problem);
  if (!isDeepStrictEqual(parsed.scene, asKept(scene))) throw new Error('another course was loaded than was saved');
}

describe('editing at random', () => {
  it(`leaves a course that can be saved and loaded: ${fuzzRuns} gestures`, () => {
    forManySeeds(Math.ceil(fuzzRuns / GESTURES), play);
  });
});
