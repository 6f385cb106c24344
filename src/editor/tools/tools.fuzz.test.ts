import { isDeepStrictEqual } from 'node:util';
import { describe, it } from 'vitest';
import type { Rng } from '#core/rng';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { parseScene } from '#scene/parse';
import type { Scene } from '#scene/scene';
import { asKept } from '#scene/groups';
import { serializeScene } from '#scene/serialize';
import { forManySeeds, fuzzRuns, inPercent, oneOf, wholeFrom } from '#scene/testing/fuzz';
import { nudged, turned } from '../arrange';
import { duplicated } from '../clipboard';
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
  switch (wholeFrom(rng, 0, 5)) {
    case 0:
      return nudged(scene, selection, wholeFrom(rng, -500, 500), wholeFrom(rng, -500, 500), footprint);
    case 1:
      return turned(scene, selection, wholeFrom(rng, -9, 9), footprint);
    case 2:
      return duplicated(scene, selection)?.edit ?? null;
    case 3:
      return removed(scene, selection);
    case 4:
      return resized(scene, oneOf(rng, [1, -1] as const), footprint);
    default:
      return withSize(scene, [wholeFrom(rng, 100, 3000), wholeFrom(rng, 100, 3000)], footprint);
  }
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
    scene = applyEdit(scene, edit);
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
