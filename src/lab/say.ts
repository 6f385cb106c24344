import { secondsText } from '#check/report/texts';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { MatchReason } from './tournament/match';
import { passedOf, type SweepResult, type SweepRun } from './sweep-texts';
import words from './words';

/** Why a run has not passed, in a few words. */
export const reasonText = (reason: MatchReason, language: Language): string => words.reasons[reason][language];

/** The result of a run in a line: the values, passed or not, the time, the reason. */
export function runText(run: SweepRun, varied: readonly string[], language: Language): string {
  const { values, passed, atMs, reason } = run;
  return [
    ...varied.map((name, place) => `${name}=${values[place] ?? ''}`),
    ...(passed === null ? [] : [words[passed ? 'passed' : 'missed'][language]]),
    ...(atMs === null ? [] : [secondsText(atMs)]),
    ...(reason === null ? [] : [reasonText(reason, language)]),
  ].join('  ');
}

/** The result of a sweep in a sentence. */
export function sumText(result: SweepResult, language: Language): string {
  const hasTask = result.runs.some(({ passed }) => passed !== null);
  const of = result.runs.length;
  const text = words[hasTask ? 'sum' : of === 1 ? 'ranOne' : 'ran'][language];
  return filledIn(text, { passed: passedOf(result), of });
}

/** How much is done. */
export const progressText = (done: number, of: number, language: Language): string =>
  filledIn(words.progress[language], { done, of });
