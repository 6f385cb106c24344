import type { Outline } from '#scene/outline';
import { findProblems, type RuleProblem } from '#scene/rules';
import type { Scene, SceneObject } from '#scene/scene';

import { shownLanguage, t } from '../../../kit/i18n';
import { namesOf } from './object-words';
import editingWords from './editing';
import kindNames from './kinds';

const texts = editingWords.problems;

/** True if a problem is worth a hint. A line drawn twice is not: it looks the same, and sensors read the same. */
const isWorthTelling = ({ code, params }: RuleProblem): boolean => !(code === 'covered' && params['kind'] === 'stroke');

/** The likely mistakes in a course that are worth a hint. */
export const problemsOf = (scene: Scene, footprint: readonly Outline[]): readonly RuleProblem[] =>
  findProblems(scene, footprint).filter(isWorthTelling);

/** A problem of a course as a sentence. */
export function problemWords({ code, params, ids }: RuleProblem, scene: Scene): string {
  const names = namesOf(scene);
  const nameOf = (id: unknown): string => (typeof id === 'string' ? (names.get(id) ?? '') : '');
  const kind = kindOf(params['kind']);
  return t(texts[code], {
    ...params,
    ...(params['count'] === 2 && code === 'covered' ? { count: t(editingWords.two) } : {}),
    what: nameOf(params['id'] ?? ids[0]),
    other: nameOf(params['other']),
    kinds: kind === null ? '' : inSentence(t(kindNames[kind].many)),
  });
}

/** A name within a sentence: in German, nouns keep their capital, and only a leading adjective loses it. */
function inSentence(name: string): string {
  const isSmall = shownLanguage() !== 'de' || name.includes(' ');
  return isSmall ? name.charAt(0).toLowerCase() + name.slice(1) : name;
}

function kindOf(value: unknown): SceneObject['type'] | null {
  return typeof value === 'string' && value in kindNames ? (value as SceneObject['type']) : null;
}
