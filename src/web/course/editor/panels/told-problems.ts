import { mendAll, mendOf } from '#editor/mends/mends';
import type { SceneEdit } from '#scene/edit';
import type { Outline } from '#scene/outline';
import type { RuleProblem } from '#scene/rules';
import type { Scene } from '#scene/scene';

import { t } from '../../../kit/i18n';
import editingWords from '../words/editing';
import { problemWords } from '../words/problem-words';

export { problemsOf } from '../words/problem-words';

const words = editingWords.mends;

/** A problem of a course in words, and its quick fix; `null`: it has none. */
export interface ToldProblem {
  readonly text: string;
  readonly mend: { readonly text: string; readonly edit: SceneEdit } | null;
}

/** A problem in words, with its quick fix. */
export function told(problem: RuleProblem, scene: Scene, footprint: readonly Outline[]): ToldProblem {
  const mend = mendOf(scene, problem, footprint);
  return {
    text: problemWords(problem, scene),
    mend: mend && { text: t(words[mend.kind]), edit: mend.edit },
  };
}

/** A quick fix for several problems at once; `null` unless there are several that can be fixed. */
export function toldMendOfAll(
  problems: readonly RuleProblem[],
  scene: Scene,
  footprint: readonly Outline[],
): ToldProblem['mend'] {
  const edit = mendAll(scene, problems, footprint);
  return edit?.type === 'all' ? { text: t(words.all), edit } : null;
}
