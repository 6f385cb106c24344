import { escaped } from '#check/report/escaped';
import { secondsText } from '#check/report/texts';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import { reasonText, sumText } from '../say';
import type { SweepResult, SweepRun } from '../sweep-texts';
import words from '../words';
import { curveOf, mapOf } from './curve';
import { reportOf, tableOf } from './page';

/**
 * The report of a sweep as one HTML file: the curve of one thing that varies or the map of two, and a table of all runs.
 *
 * @param name of the program
 */
export function sweepHtml(result: SweepResult, name: string, language: Language): string {
  const title = filledIn(words.title[language], { name });
  const say = (key: 'time' | 'way' | 'touches' | 'result' | 'end'): string => words[key][language];
  const columns = [
    ...result.varied.map((one) => ({ title: one, isNumber: true })),
    { title: say('result') },
    { title: say('time'), isNumber: true },
    { title: say('touches'), isNumber: true },
    { title: say('way'), isNumber: true },
    { title: say('end'), isNumber: true },
  ];
  return reportOf(
    title,
    language,
    `<h1>${escaped(title)}</h1>
<p class="sum">${escaped(sumText(result, language))}</p>
<div class="wide">${drawingOf(result, language)}</div>
${tableOf(
  columns,
  result.runs.map((run) => rowOf(run, language)),
)}`,
  );
}

function drawingOf(result: SweepResult, language: Language): string {
  if (result.varied.length === 2) return mapOf(result);
  if (result.varied.length !== 1) return '';
  const hasTask = result.runs.some(({ passed }) => passed !== null);
  return hasTask
    ? curveOf(result, { title: `${words.time[language]} (s)`, of: ({ atMs }) => (atMs === null ? null : atMs / 1000) })
    : curveOf(result, { title: `${words.way[language]} (mm)`, of: ({ pathMm }) => pathMm });
}

function rowOf(run: SweepRun, language: Language): readonly string[] {
  const { values, passed, reason, atMs, touches, pathMm, xMm, yMm } = run;
  const mark = passed === null ? '' : passed ? '<b class="yes">✓</b> ' : '<b class="no">✗</b> ';
  const word = passed === null ? '' : words[passed ? 'passed' : 'missed'][language];
  const said = [word, ...(reason === null ? [] : [reasonText(reason, language)])].filter((one) => one !== '');
  return [
    ...values.map((value) => escaped(String(value))),
    `${mark}${escaped(said.join(', '))}`,
    atMs === null ? '' : secondsText(atMs),
    String(touches),
    pathMm === null ? '' : `${Math.round(pathMm)} mm`,
    xMm === null || yMm === null ? '' : `${Math.round(xMm)}, ${Math.round(yMm)}`,
  ];
}
