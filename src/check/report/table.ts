import { spreadsheetText, usualForm, type Cell, type SpreadsheetForm } from '#core/csv';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { CheckOutcome } from '../result';
import { checkText } from '../task/check-text';
import { mostPoints, worldName, type ClassTask } from '../task/task';
import { countedPoints, shownName, type ClassResult, type NamedResult } from './class-result';
import { reasonText, remarkBeside } from './say';
import { isUnread } from './texts';
import reportWords from './words';

/** The form of a table, and what it shows besides the results. */
interface TableExtras {
  readonly form?: SpreadsheetForm;
  /** The address that brings a pupil the note on a hand-in; `null`: there is none. Left out: there is no column for it. */
  readonly linkOf?: (handIn: NamedResult) => string | null;
  /** The grade for what a hand-in counts, by the scale of its class; left out: there is no column for it. */
  readonly gradeOf?: (handIn: NamedResult) => number | null;
  /** The name of that class. */
  readonly className?: string;
}

/**
 * The result of a class as a table for a spreadsheet in the reader's language: what is checked stands in words, each figure
 * alone in its cell. What could not be read has none. For programs there is `csvOf`.
 */
export function tableOf(
  { handIns }: ClassResult,
  task: ClassTask,
  language: Language,
  { form = usualForm(language), linkOf, gradeOf, className = '' }: TableExtras = {},
): string {
  const words = reportWords.report;
  const say = (name: keyof typeof words): string => words[name][language];
  const most = mostPoints(task);
  const hasNotes = handIns.some(({ note = '' }) => note !== '');
  const hasMarks = handIns.some(({ marked }) => marked !== undefined);
  const noteHeadings = hasNotes ? [say('note'), ...(linkOf === undefined ? [] : [say('feedback')])] : [];
  const noteOf = (one: NamedResult): readonly Cell[] =>
    [one.note ?? '', one.note ? (linkOf?.(one) ?? null) : null].slice(0, noteHeadings.length);
  const worlds = task.worlds.map((world) => filledIn(say('world'), { id: worldName(world) }));
  const headings = [
    ...[
      say('name'),
      say('result'),
      say('points'),
      say('most'),
      ...(hasMarks ? [say('byHand')] : []),
      ...(gradeOf === undefined ? [] : [className === '' ? say('grade') : `${say('grade')} (${className})`]),
    ],
    ...(task.stars === null ? [] : [say('stars')]),
    ...task.checks.map((check) => checkText(check, language)),
    ...worlds.flatMap((world) => [world, filledIn(say('secondsIn'), { world }), filledIn(say('touchesIn'), { world })]),
    ...[say('remarks'), ...noteHeadings],
  ];
  const outcome = ({ passed, reason }: Pick<CheckOutcome, 'passed' | 'reason'>): string =>
    passed ? say('passed') : reason === null ? say('missed') : reasonText(reason, language);
  const figures = (one: NamedResult): readonly Cell[] => {
    const { result, marked } = one;
    return [
      ...[outcome({ passed: result.passed, reason: null }), countedPoints({ result, marked }), most],
      ...(hasMarks ? [marked === undefined ? null : say('yes')] : []),
      ...(gradeOf === undefined ? [] : [gradeOf(one)]),
      ...(task.stars === null ? [] : [result.stars]),
      ...task.checks.map(({ id }) => {
        const check = result.checks.find((one) => one.id === id);
        return check === undefined ? null : outcome(check);
      }),
      ...task.worlds.flatMap(({ id }): readonly Cell[] => {
        const world = result.worlds.find((one) => one.id === id);
        if (world === undefined) return [null, null, null];
        return [outcome(world), world.atMs === null ? null : Math.round(world.atMs / 10) / 100, world.touches];
      }),
    ];
  };
  const nothing = (): readonly Cell[] => [say('unread'), ...headings.slice(3 + noteHeadings.length).map(() => null)];
  const rows = handIns.map((one) => [
    shownName(one),
    ...(isUnread(one.result) ? nothing() : figures(one)),
    one.result.remarks.map((remark) => remarkBeside(remark, language)).join(' · '),
    ...noteOf(one),
  ]);
  return spreadsheetText([headings, ...rows], form);
}
