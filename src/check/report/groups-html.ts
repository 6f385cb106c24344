import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import type { ClassTask } from '../task/task';
import { passedOf, type ClassResult } from './class-result';
import { Drawings, type WaysToDraw, type WayTone } from './drawing';
import { escaped } from './escaped';
import { pageOf } from './page';
import reportWords from './words';
import styles from './report.css?raw';

/** A group of hand-ins as a report shows it: without names. */
export interface ReportGroup {
  readonly title: string;
  /** When or why it happened; empty: nothing more is to say. */
  readonly fact: string;
  readonly ways: WaysToDraw;
  /** The hint that would help; left out: none is known. */
  readonly hint?: string;
}

const marks: Readonly<Record<WayTone, string>> = {
  passed: '<b class="yes" aria-hidden="true">✓</b>',
  wrong: '<b class="no" aria-hidden="true">✗</b>',
  missing: '<b aria-hidden="true">△</b>',
};

/** The report of a class by groups, without names, as one HTML file that needs nothing else. */
export function groupsHtmlOf(
  found: ClassResult,
  task: ClassTask,
  language: Language,
  groups: readonly ReportGroup[],
): string {
  const drawings = new Drawings(task);
  const summary = filledIn(reportWords.report.summary[language], { passed: passedOf(found), of: found.handIns.length });
  const rows = groups.map(({ title, fact, ways, hint = '' }) => {
    const said = [fact, hint].map((text) => (text === '' ? '' : `<p>${escaped(text)}</p>`)).join('');
    return `<li><div class="way">${drawings.ways(ways, '')}</div><div><b>${marks[ways.tone]} ${escaped(title)}</b>${said}</div></li>`;
  });
  const body = `<svg width="0" height="0" aria-hidden="true"><defs>${drawings.shared()}</defs></svg>
<main>
<h1>${escaped(found.task)}</h1>
<p class="summary">${escaped(summary)}</p>
<ul class="groups">
${rows.join('\n')}
</ul>
</main>`;
  return pageOf(found.task, styles, language, body);
}
