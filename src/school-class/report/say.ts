import { weekOf, type Day } from '#core/day';
import { passedOf } from '#check/report/class-result';
import type { Language, Texts } from '#core/languages';
import { filledIn } from '#core/words';
import type { Scale, SystemId } from '../grades';
import { taskKey, type Added, type CheckedTask } from '../add-results';
import { missingIn, rowsOf, type Cell } from '../progress';
import type { SchoolClass, SetTask } from '../school-class';
import words from '../words';

/** A day as the language writes it: `30.11.2026`, `30/11/2026`, `2026-11-30`. */
export function dayText(day: Day, language: Language): string {
  if (language === 'en') return day;
  const sign = language === 'de' ? '.' : '/';
  return day.split('-').toReversed().join(sign);
}

/** A grade with as many decimals as its steps need, as the page writes numbers: `5.5`, in French `5,5`; `–` for none. */
export function gradeText(grade: number | null, { step }: Pick<Scale, 'step'>, language: Language): string {
  if (grade === null) return '–';
  const text = grade.toFixed(step === 1 ? 0 : step === 0.25 ? 2 : 1);
  return language === 'fr' ? text.replace('.', ',') : text;
}

/** The name of a system of grades. */
export const systemText = (system: SystemId, language: Language): string => words.systems[system][language];

/** The scale in a few words. */
export function scaleText({ system, passPercent }: Scale, language: Language): string {
  const text = passPercent === null ? words.even : words.from;
  return filledIn(text[language], { system: systemText(system, language), percent: passPercent ?? '' });
}

/** Tasks that were first checked in the same week, beside each other. */
export interface Week {
  readonly title: string;
  readonly tasks: readonly SetTask[];
}

/** The tasks of a class by weeks, in their order. */
export function weeksOf(tasks: readonly SetTask[], language: Language): readonly Week[] {
  const weeks: { title: string; key: string; tasks: SetTask[] }[] = [];
  for (const task of tasks) {
    const { year, week } = weekOf(task.since);
    const key = `${String(year)}-${String(week)}`;
    const last = weeks.at(-1);
    if (last?.key === key) last.tasks.push(task);
    else weeks.push({ title: filledIn(words.week[language], { week }), key, tasks: [task] });
  }
  return weeks;
}

/** A sign for each state, beside its word or figure: nothing is said by colour alone. */
export const SIGNS: Readonly<Record<Cell['state'], string>> = {
  passed: '✓',
  partly: '◐',
  failed: '✗',
  unread: '?',
  missing: '–',
  open: '…',
};

/** True if a cell has points; else its word says why not. */
export const hasPoints = ({ state }: Cell): boolean => state === 'passed' || state === 'partly' || state === 'failed';

/** True if the points of a cell were set by hand; a pencil tells so. */
export const isByHand = ({ result }: Cell): boolean => result?.marked !== undefined;
export const BY_HAND_SIGN = '✎';

/** The words for that. */
export const byHandText = (language: Language): string => words.byHand[language];

/** The word for the state of a cell. */
export const stateText = ({ state }: Pick<Cell, 'state'>, language: Language): string => words.states[state][language];

/** The size of a class in a sentence. */
export const summaryText = ({ name, pupils, tasks, results }: SchoolClass, language: Language): string =>
  filledIn(words.merged[language], { name, pupils: pupils.length, tasks: tasks.length, results: results.length });

/** Tells of names that stand in a list more than once. */
export const twiceText = (names: readonly string[], language: Language): string =>
  filledIn(words.twice[language], { names: names.join(', ') });

/** Tells of hand-ins that belong to no task of a series. */
export const strangeText = (names: readonly string[], language: Language): string =>
  filledIn(words.whole[language], { names: names.join(', ') });

/** Tells what was added to a class, who is missing, and who is not on its list. */
export function addedTexts(
  { schoolClass, count, strangers }: Added,
  { task, found, day }: CheckedTask,
  language: Language,
): readonly string[] {
  const place = schoolClass.tasks.findIndex(({ id }) => id === taskKey(task));
  const missing = missingIn(rowsOf(schoolClass, day), place).map(({ name }) => name);
  const figures = { count, passed: passedOf(found), of: found.handIns.length, missing: missing.length };
  const names = (text: Texts, of: readonly string[]): readonly string[] =>
    of.length === 0 ? [] : [filledIn(text[language], { names: of.join(', ') })];
  return [
    filledIn(words.added[language], { ...figures, name: schoolClass.name, task: found.task }),
    ...names(words.missingNames, missing),
    ...names(words.stranger, strangers),
  ];
}
