import type { ClassResult } from '#check/report/class-result';
import { htmlOf } from '#check/report/html';
import { csvOf } from '#check/report/texts';
import type { ClassTask } from '#check/task/task';

import { shownLanguage } from '../page/i18n';
import type { PageParts } from '../page/parts';
import { fileName, saveText } from '../work/save-file';

type Told = Pick<PageParts, 'notices'>;

/** Saves the results as a table for a spreadsheet. */
export function saveTable(app: Told, found: ClassResult): void {
  // Spreadsheets take a file for UTF-8 only if it begins with this sign.
  saveText(app, fileName(found.task, 'csv'), `\ufeff${csvOf(found, shownLanguage())}`, 'text/csv');
}

/** Opens the report in a tab of its own, where it can be printed; where the browser allows none, it is saved. */
export function openReport(app: Told, found: ClassResult, task: ClassTask): void {
  const html = htmlOf(found, task, shownLanguage());
  const url = URL.createObjectURL(new Blob([html], { type: 'text/html' }));
  if (window.open(url, '_blank') === null) saveText(app, fileName(found.task, 'html'), html, 'text/html');
}
