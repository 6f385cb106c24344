import type { Texts } from '#core/languages';
import type { LogProblem, Remark } from '#device-log/device-log';

import { t } from '../../kit/i18n';
import words from './words';

const problemTexts: Readonly<Record<LogProblem['code'], Texts>> = {
  empty: words.problems.empty,
  workbook: words.problems.workbook,
  'not-text': words.problems.notText,
  'other-page': words.problems.otherPage,
  'cut-short': words.problems.cutShort,
  'empty-log': words.problems.emptyLog,
  'too-many-columns': words.problems.tooManyColumns,
  'no-numbers': words.problems.noNumbers,
};

const remarkTexts: Readonly<Record<Remark['code'], Texts>> = {
  'cut-off': words.remarks.cutOff,
  'not-a-number': words.remarks.notANumber,
  'extra-cells': words.remarks.extraCells,
  'new-columns': words.remarks.newColumns,
  'text-columns': words.remarks.textColumns,
};

/** The message on a file that cannot be shown. */
export const problemText = (file: string, problem: LogProblem): string =>
  t(problemTexts[problem.code], { file, ...shortened(problem) });

/** A remark on a shown file, in words. */
export const remarkText = (remark: Remark): string => t(remarkTexts[remark.code], shortened(remark));

/** Cells and lists of names may be as long as the file. */
const LONGEST = 60;

function shortened(values: Readonly<Record<string, string | number>>): Readonly<Record<string, string | number>> {
  const short = (value: string | number): string | number =>
    typeof value === 'string' && value.length > LONGEST ? `${value.slice(0, LONGEST)} …` : value;
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, short(value)]));
}
