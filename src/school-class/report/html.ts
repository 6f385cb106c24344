import { escaped } from '#check/report/escaped';
import { pageOf } from '#check/report/page';
import type { Day } from '#core/day';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { Scale } from '../grades';
import { rowsOf, type Cell, type Row } from '../progress';
import type { SchoolClass, SetTask } from '../school-class';
import words from '../words';
import styles from './class-report.css?raw';
import {
  BY_HAND_SIGN,
  byHandText,
  dayText,
  gradeText,
  hasPoints,
  isByHand,
  scaleText,
  SIGNS,
  stateText,
  weeksOf,
} from './say';

/** The report of a class on a day as one HTML file that needs nothing else: pupils × tasks by weeks, on A4 across. */
export function classReport(schoolClass: SchoolClass, day: Day, language: Language): string {
  const { name, pupils, tasks, scale } = schoolClass;
  const rows = rowsOf(schoolClass, day);
  const count = filledIn(words.count[language], { pupils: pupils.length, tasks: tasks.length });
  const about = [count, ...(scale === null ? [] : [scaleText(scale, language)])];
  const title = escaped(name);
  const body = `<h1>${title}</h1>
<p>${[filledIn(words.day[language], { day: dayText(day, language) }), ...about].map(escaped).join(' · ')}</p>
${rows.length === 0 ? `<p>${escaped(words.nobody[language])}</p>` : tableOf(schoolClass, rows, language)}
<p class="legend">${(Object.keys(SIGNS) as Cell['state'][]).map((state) => `<span>${SIGNS[state]} ${escaped(stateText({ state }, language))}</span>`).join(' ')}${rows.some(({ cells }) => cells.some(isByHand)) ? ` <span>${BY_HAND_SIGN} ${escaped(byHandText(language))}</span>` : ''}</p>`;
  return pageOf(name, styles, language, body);
}

function tableOf({ tasks, scale }: SchoolClass, rows: readonly Row[], language: Language): string {
  const weeks = weeksOf(tasks, language).map((week) => `<th colspan="${String(week.tasks.length)}">${escaped(week.title)}</th>`); // prettier-ignore
  const grade = scale === null ? '' : `<th class="number">${escaped(words.grade[language])}</th>`;
  return `<table>
<thead>
<tr><td></td>${weeks.join('')}<td></td>${scale === null ? '' : '<td></td>'}</tr>
<tr><th>${escaped(words.name[language])}</th>${tasks.map((task) => taskHead(task, language)).join('')}<th class="number">${escaped(words.points[language])}</th>${grade}</tr>
</thead>
<tbody>
${rows.map((row) => rowOf(row, { tasks, scale, language })).join('\n')}
</tbody>
</table>`;
}

function taskHead({ title, due }: SetTask, language: Language): string {
  const until = due === null ? '' : `<small>${escaped(filledIn(words.until[language], { day: dayText(due, language) }))}</small>`; // prettier-ignore
  return `<th>${escaped(title)}${until}</th>`;
}

interface Form {
  readonly tasks: readonly SetTask[];
  readonly scale: Scale | null;
  readonly language: Language;
}

function rowOf({ pupil, cells, points, most, grade }: Row, { tasks, scale, language }: Form): string {
  const inside = cells.map((cell, place) => `<td class="${cell.state}">${cellText(cell, tasks[place], language)}</td>`);
  const last = scale === null ? '' : `<td class="number grade">${gradeText(grade, scale, language)}</td>`;
  return `<tr><th>${escaped(pupil.name)}</th>${inside.join('')}<td class="number">${String(points)} / ${String(most)}</td>${last}</tr>`;
}

function cellText(cell: Cell, task: SetTask | undefined, language: Language): string {
  const { state, points, stars } = cell;
  if (!hasPoints(cell)) return `${SIGNS[state]} ${escaped(stateText(cell, language))}`;
  const rest = stars === null || stars === 0 ? '' : ` ${'★'.repeat(stars)}`;
  const sign = isByHand(cell) ? ` ${BY_HAND_SIGN}` : '';
  return `${SIGNS[state]} ${String(points)} / ${String(task?.points ?? 0)}${sign}${rest}`;
}
