import { spreadsheetText, usualForm, type Cell as TableCell } from '#core/csv';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { Cell, Row } from '../progress';
import type { SchoolClass } from '../school-class';
import words from '../words';
import { hasPoints, stateText } from './say';

/**
 * A class as CSV for a spreadsheet in this language: a row for each pupil, and of each task the points, stars if it gives some,
 * and the number of hand-ins. Where there are no points, a word says why.
 */
export function classTable(
  { tasks, scale }: SchoolClass,
  rows: readonly Row[],
  language: Language,
  form = usualForm(language),
): string {
  const say = (text: 'name' | 'points' | 'grade'): string => words[text][language];
  const headings = [
    say('name'),
    ...tasks.flatMap(({ title, points, hasStars }) => [
      filledIn(words.outOf[language], { title, points }),
      ...(hasStars ? [filledIn(words.starsOf[language], { title })] : []),
      filledIn(words.triesOf[language], { title }),
    ]),
    say('points'),
    words.most[language],
    ...(scale === null ? [] : [say('grade')]),
  ];
  const body = rows.map(({ pupil, cells, points, most, grade }): TableCell[] => [
    pupil.name,
    ...tasks.flatMap(({ hasStars }, place) => cellsOf(cells[place], hasStars, language)),
    ...[points, most],
    ...(scale === null ? [] : [grade]),
  ]);
  return spreadsheetText([headings, ...body], form);
}

function cellsOf(cell: Cell | undefined, hasStars: boolean, language: Language): readonly TableCell[] {
  if (cell === undefined) return [];
  const { points, stars, tries } = cell;
  return [hasPoints(cell) ? points : stateText(cell, language), ...(hasStars ? [stars] : []), tries];
}
