import type { Outline } from '#scene/outline';
import { findProblems, type RuleProblem } from '#scene/rules';
import type { Scene, SceneObject } from '#scene/scene';

import { shownLanguage } from '../../page/i18n';
import { say } from '../../page/i18n/say';
import { namesOf } from './object-words';
import { editingWords } from './editing-words';
import { editorWords as words } from './editor-words';

const texts = editingWords.problems;

/** Whether a problem is worth a hint: a line that was drawn twice looks the same, and sensors read the same. */
const isWorthTelling = ({ code, params }: RuleProblem): boolean => !(code === 'covered' && params['kind'] === 'stroke');

/** What in a course is hardly intended and worth a hint. */
export const problemsOf = (scene: Scene, footprint: readonly Outline[]): readonly RuleProblem[] =>
  findProblems(scene, footprint).filter(isWorthTelling);

/** A problem of a course as a sentence. */
export function problemWords({ code, params, ids }: RuleProblem, scene: Scene): string {
  const names = namesOf(scene);
  const nameOf = (id: unknown): string => (typeof id === 'string' ? (names.get(id) ?? '') : '');
  const kind = kindOf(params['kind']);
  return say(texts[code], {
    ...params,
    ...(params['count'] === 2 && code === 'covered' ? { count: say(editingWords.two) } : {}),
    what: nameOf(params['id'] ?? ids[0]),
    other: nameOf(params['other']),
    kinds: kind === null ? '' : inSentence(say(words.kinds[kind].many)),
  });
}

/** A name inside a sentence: in German only an adjective before it begins with a small letter. */
function inSentence(name: string): string {
  const isSmall = shownLanguage() !== 'de' || name.includes(' ');
  return isSmall ? name.charAt(0).toLowerCase() + name.slice(1) : name;
}

function kindOf(value: unknown): SceneObject['type'] | null {
  return typeof value === 'string' && value in words.kinds ? (value as SceneObject['type']) : null;
}
