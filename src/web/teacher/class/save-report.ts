import type { ClassResult, NamedResult } from '#check/report/class-result';
import { tableOf } from '#check/report/table';
import type { ClassTask } from '#check/task/task';

import { shownLanguage } from '../../kit/i18n';
import { spreadsheetForm } from '../../kit/i18n/spreadsheet-form';
import type { PageParts } from '../../kit/parts';
import type { WithLate } from '../../kit/state/late-models';
import { fileName, saveText } from '../../session/work/save-file';
import { classBookOf } from '../class-book/use-class-book';
import { gradesOf } from './feedback/class-grades';
import { noteLink } from './feedback/feedback-link';
import type { Row } from './model/class-model';

type Told = Pick<PageParts, 'notices'>;

/** Saves the results as a table for a spreadsheet, with the links to the notes: a mail merge sends each to its pupil. */
export async function saveTable(
  app: Told & WithLate,
  found: ClassResult,
  task: ClassTask,
  rows: readonly Row[],
): Promise<void> {
  await classBookOf(app).ready; // its grades
  const language = shownLanguage();
  const grades = gradesOf(app, () => task).value;
  const extras = {
    form: spreadsheetForm(language),
    linkOf: ({ name }: NamedResult) => noteLink(rows, task, name),
    ...(grades !== null && { gradeOf: grades.of, className: grades.name }),
  };
  saveText(app, fileName(found.task, 'csv'), tableOf(found, task, language, extras), 'text/csv');
}

/** Saves a report as a file that needs nothing else. */
export function saveReport(app: Told, name: string, html: string): void {
  saveText(app, fileName(name, 'html'), html, 'text/html');
}
