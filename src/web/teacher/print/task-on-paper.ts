import type { Scene } from '#scene/scene';

import { t } from '../../kit/i18n';
import type { CheckInWords } from '../../session/task/checks-in-words';
import { goalsInWords, rulesInWords } from '../../session/task/goals';
import type { ShownText } from '../../session/work/catalogue/task-text';
import words from '../../session/task/words';
import { sizedForPdf } from './picture-parts';
import type { PaperTask } from './task/task-blocks';

/**
 * The task of a course as it is printed, in the language of the page.
 *
 * @param checks what is checked besides the goals of the course
 * @param withHints otherwise they stay on the screen, where pupils ask for them one by one
 */
export async function taskOnPaper(
  scene: Scene,
  text: ShownText,
  checks: readonly CheckInWords[],
  withHints: boolean,
): Promise<PaperTask> {
  const { stars } = scene.task;
  const times = [...(stars ?? [])].sort((one, other) => other - one);
  return {
    title: text.title,
    text: text.text,
    picture: text.picture === '' ? null : await sizedForPdf(text.picture),
    goalsTitle: t(words.goalsTitle),
    goals: goalsInWords(scene, null).map((goal) => t(words.goals[goal.words], goal.values)),
    rules: rulesInWords(scene, null).map((rule) => t(words.rules[rule.words], rule.values)),
    checksTitle: t(words.checks.title),
    checks: checks.map((check) => `${check.text} (${check.gives})`),
    stars: stars === undefined ? [] : [t(words.stars.one), ...times.map((seconds) => t(words.stars.two, { seconds }))],
    hints: withHints
      ? text.hints.map((hint, index) => ({ title: t(words.hint, { number: index + 1 }), text: hint }))
      : [],
  };
}
