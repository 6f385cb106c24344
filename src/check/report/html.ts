import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { CheckResult, WorldResult } from '../result';
import { checkText } from '../task/check-text';
import { ledDrawing } from '../task/led-drawing';
import { worldName, type Check, type ClassTask } from '../task/task';
import { countedPoints, passedOf, type ClassResult, type Counted, type NamedResult } from './class-result';
import { Drawings } from './drawing';
import { escaped } from './escaped';
import { pageOf } from './page';
import { otherTaskTexts, remarkBeside } from './say';
import reportWords from './words';
import styles from './report.css?raw';
import { isUnread, reasonsAgainst, secondsText } from './texts';

/** Parts of a report besides the results. */
interface ReportExtras {
  /** The drawing of a code that leads to the feedback on a hand-in, below its note; empty: none. */
  readonly codeOf?: (one: NamedResult) => string;
  /** The grade for what a hand-in counts, by the scale of its class; empty: none. */
  readonly gradeOf?: (one: NamedResult) => string;
  /** The name of that class. */
  readonly className?: string;
  /** True for the table alone, without a sheet for each hand-in. */
  readonly isTable?: boolean;
}

/**
 * The report of a class as one HTML file that needs nothing else: a table of all, then a sheet for each hand-in. Printed,
 * each sheet is a page. Of one hand-in it is the sheet alone.
 *
 * @param extras what is shown besides the results
 */
export function htmlOf(
  found: ClassResult,
  task: ClassTask,
  language: Language,
  { codeOf = () => '', gradeOf = () => '', className = '', isTable = false }: ReportExtras = {},
): string {
  const { handIns } = found;
  const drawings = new Drawings(task);
  const title = escaped(found.task);
  const table =
    handIns.length === 1 && !isTable ? '' : tableOf(found, { drawings, language, gradeOf, isTable }, className);
  const sheets = (isTable ? [] : handIns)
    .map((one, place) => sheetOf(one, place, { drawings, title, task, language, code: codeOf(one), gradeOf }))
    .join('\n');
  const body = `<svg width="0" height="0" aria-hidden="true"><defs>${drawings.shared()}</defs></svg>
<main>${table}
${sheets}
</main>`;
  return pageOf(found.task, styles, language, body);
}

/** The table of a class, a row for each hand-in. */
function tableOf(found: ClassResult, { drawings, language, gradeOf, isTable }: Table, className: string): string {
  const { handIns, task } = found;
  const words = reportWords.report;
  const summary = filledIn(words.summary[language], { passed: passedOf(found), of: handIns.length });
  const hasStars = handIns.some(({ result }) => result.stars !== null);
  const hasGrades = handIns.some((one) => gradeOf(one) !== '');
  const scale = hasGrades && className !== '' ? [filledIn(words.gradesOf[language], { name: className })] : [];
  const columns = ['way', 'name', 'result', 'points', ...(hasGrades ? (['grade'] as const) : []), ...(hasStars ? (['stars'] as const) : []), 'time', 'touches', 'remarks'] as const; // prettier-ignore
  const head = columns
    .map((name) => `<th${numbers.includes(name) ? ' class="number"' : ''}>${words[name][language]}</th>`)
    .join('');
  const rows = handIns
    .map((one, place) => rowOf(one, place, { drawings, hasStars, hasGrades, language, gradeOf, isTable }))
    .join('\n');
  return `
<h1>${escaped(task)}</h1>
<p class="summary">${[handIns.length === 0 ? words.nobody[language] : summary, ...scale, ...otherTaskTexts(found, language)].map(escaped).join('<br>')}</p>
<table>
<thead><tr>${head}</tr></thead>
<tbody>
${rows}
</tbody>
</table>`;
}

/** The points that count; a pencil tells those that were set by hand. */
function pointsText(one: Counted, language: Language): string {
  const sign =
    one.marked === undefined ? '' : ` <span title="${escaped(reportWords.report.byHand[language])}">✎</span>`;
  return `${String(countedPoints(one))}${sign}`;
}

/** Columns of figures. */
const numbers: readonly string[] = ['points', 'grade', 'time', 'touches'];

interface Sheet {
  readonly drawings: Drawings;
  readonly language: Language;
  readonly gradeOf: (one: NamedResult) => string;
}

interface Table extends Sheet {
  /** True where no sheets follow. */
  readonly isTable: boolean;
}

const markOf = (passed: boolean): string =>
  passed ? '<b class="yes" aria-hidden="true">✓</b>' : '<b class="no" aria-hidden="true">✗</b>';

function verdictOf(result: CheckResult, language: Language): string {
  const { passed, unread, missed } = reportWords.report;
  const word = isUnread(result) ? unread : result.passed ? passed : missed;
  return isUnread(result) ? word[language] : `${markOf(result.passed)} ${word[language]}`;
}

const secondsOf = ({ atMs }: WorldResult): string => (atMs === null ? '' : secondsText(atMs));

function rowOf(
  one: NamedResult,
  place: number,
  {
    drawings,
    hasStars,
    hasGrades,
    language,
    gradeOf,
    isTable,
  }: Table & { readonly hasStars: boolean; readonly hasGrades: boolean },
): string {
  const { name, shown = name, result, note = '', marked } = one;
  const [first] = result.worlds;
  const said = [
    ...(result.passed ? [] : reasonsAgainst(result, language)),
    ...result.remarks.map((remark) => remarkBeside(remark, language)),
    ...(note === '' ? [] : [note]),
  ];
  const touches = result.worlds.reduce((sum, world) => sum + world.touches, 0);
  /** On a narrow screen the row of headings is not there: each figure has its own. */
  const figure = (column: 'points' | 'grade' | 'time' | 'touches', text: string | number): string =>
    `<td class="number ${column}" data-of="${escaped(reportWords.report[column][language])}">${text}</td>`;
  return [
    `<tr><td class="thumb">${first === undefined ? '' : drawings.way(first, '')}</td>`,
    `<th scope="row">${isTable ? escaped(shown) : `<a href="#hand-in-${place}">${escaped(shown)}</a>`}</th>`,
    `<td class="verdict">${verdictOf(result, language)}</td>${figure('points', isUnread(result) ? '' : pointsText({ result, marked }, language))}`,
    hasGrades ? figure('grade', isUnread(result) ? '' : escaped(gradeOf(one))) : '',
    hasStars ? `<td class="stars">${'★'.repeat(result.stars ?? 0)}</td>` : '',
    figure('time', first === undefined ? '' : secondsOf(first)),
    figure('touches', isUnread(result) ? '' : touches),
    `<td class="said">${said.map(escaped).join('<br>')}</td></tr>`,
  ].join('');
}

/** The requirement of a check in words, with the picture that is to be shown. */
function askedOf({ checks }: ClassTask, id: string, language: Language): string {
  const check = checks.find((one): one is Check => one.id === id);
  if (check === undefined) return escaped(id);
  const words = escaped(checkText(check, language));
  return check.type === 'display' ? `${words} ${ledDrawing(check.image)}` : words;
}

function sheetOf(
  one: NamedResult,
  place: number,
  {
    drawings,
    title,
    task,
    language,
    code,
    gradeOf,
  }: Sheet & { readonly title: string; readonly task: ClassTask; readonly code: string },
): string {
  const { name, shown = name, result, note = '', marked } = one;
  const words = reportWords.report;
  const grade = isUnread(result) ? '' : gradeOf(one);
  const facts = (isUnread(result) ? [] : result.checks).map(
    ({ id, passed, reason }) =>
      `<li>${markOf(passed)} ${askedOf(task, id, language)}${reason === null ? '' : `: ${escaped(reasonsAgainst({ ...result, worlds: [], checks: [{ id, passed, reason }] }, language)[0] ?? '')}`}</li>`,
  );
  const remarks = result.remarks.map((remark) => `<li>${escaped(remarkBeside(remark, language))}</li>`);
  const figures = result.worlds.map((world) => {
    const label = filledIn(words.world[language], { id: worldName(world) });
    const seconds = secondsOf(world);
    return `<figure>${drawings.way(world, `${shown}, ${label}`)}<figcaption>${markOf(world.passed)} ${escaped(label)}${seconds === '' ? '' : ` · ${seconds}`}</figcaption></figure>`;
  });
  return `<section id="hand-in-${place}">
<h2>${escaped(shown)}</h2>
<p>${title} · ${verdictOf(result, language)}${isUnread(result) ? '' : ` · ${words.points[language]}: ${pointsText({ result, marked }, language)}${marked === undefined ? '' : ` (${escaped(words.byHand[language])})`}`}${grade === '' ? '' : ` · ${words.grade[language]}: ${escaped(grade)}`}</p>
<ul>${[...facts, ...remarks].join('')}</ul>${note === '' ? '' : `\n<p class="note">${escaped(note)}</p>`}${code === '' ? '' : `\n<p class="code">${code}<span>${escaped(words.again[language])}</span></p>`}
<div class="ways">${figures.join('')}</div>
</section>`;
}
