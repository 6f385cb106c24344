import type { Language } from '#core/languages';
import { escaped } from '#check/report/escaped';
import styles from './report.css?raw';

/** A report as one HTML file that needs nothing else. */
export const pageOf = (title: string, language: Language, content: string): string => `<!doctype html>
<html lang="${language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title)}</title>
<style>${styles}</style>
</head>
<body>
<main>
${content}
</main>
</body>
</html>
`;

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
