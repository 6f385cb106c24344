import type { Language } from '#core/languages';
import { escaped } from '#check/report/escaped';
import { pageOf } from '#check/report/page';
import styles from './report.css?raw';

/** A report as one HTML file that needs nothing else. */
export const reportOf = (title: string, language: Language, content: string): string =>
  pageOf(title, styles, language, `<main>\n${content}\n</main>`);

/** A cell of a table, as HTML; `isNumber` sets it to the right. */
export interface Column {
  readonly title: string;
  readonly isNumber?: boolean;
}

/** A table of ready pieces of HTML. */
export function tableOf(columns: readonly Column[], rows: readonly (readonly string[])[]): string {
  const side = (place: number): string => (columns[place]?.isNumber === true ? ' class="number"' : '');
  const head = columns.map(({ title }, place) => `<th${side(place)}>${escaped(title)}</th>`).join('');
  const body = rows
    .map((cells) => `<tr>${cells.map((cell, place) => `<td${side(place)}>${cell}</td>`).join('')}</tr>`)
    .join('\n');
  return `<div class="wide"><table>\n<thead><tr>${head}</tr></thead>\n<tbody>\n${body}\n</tbody>\n</table></div>`;
}
