import type { ClassResult } from '#check/report/class-result';
import { tableOf } from '#check/report/table';
import type { ClassTask } from '#check/task/task';

import { shownLanguage } from '../../kit/i18n';
import { spreadsheetForm } from '../../kit/i18n/spreadsheet-form';
import type { PageParts } from '../../kit/parts';
import { fileName, saveText } from '../../session/work/save-file';

type Told = Pick<PageParts, 'notices'>;

/** Saves the results as a table for a spreadsheet. */
export function saveTable(app: Told, found: ClassResult, task: ClassTask): void {
  const language = shownLanguage();
  saveText(app, fileName(found.task, 'csv'), tableOf(found, task, language, spreadsheetForm(language)), 'text/csv');
}

/** Saves a report as a file that needs nothing else. */
export function saveReport(app: Told, name: string, html: string): void {
  saveText(app, fileName(name, 'html'), html, 'text/html');
}
