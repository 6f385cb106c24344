import { readTasks } from '#intake/read-files';
import { looksLikeSeries, parseSeries, type ReadSeries } from '#check/series/read-series';
import type { Series, TaskSource } from '#check/series/series';
import { seriesForPupils } from '#check/series/write-series';

import type { PageParts } from '../page/parts';
import { say } from '../page/i18n/say';
import { keepSeries } from '../task/series/kept-series';
import { readyScene } from '../work/catalogue/ready-courses';
import { seriesReason } from './series-reason';
import { shareWords } from './share-words';

const words = shareWords.series;

/** Where a series that was opened is shown. */
export interface ShowsSeries {
  readonly gallery: { openSeries(id: string): void };
}

/** A series that can be shown, or in words why not; `isOld`: it could not be fetched now, and is as it was then. */
export type FoundSeries = { readonly series: Series; readonly isOld?: true } | { readonly problem: string };

/**
 * Opens the series among files that were opened by hand, with the tasks in the others.
 *
 * @param texts the files by their names
 * @returns whether there is one; a series that cannot be read gives a message
 */
export async function openSeriesAmong(
  app: Pick<PageParts, 'notices'> & ShowsSeries,
  texts: ReadonlyMap<string, string>,
): Promise<boolean> {
  const text = [...texts.values()].find(looksLikeSeries);
  if (text === undefined) return false;
  const found = await seriesOfFile(text, texts);
  if ('series' in found) app.gallery.openSeries(found.series.id);
  else app.notices.show({ kind: 'error', key: 'notice.text', values: { text: found.problem } });
  return true;
}

async function seriesOfFile(text: string, beside: ReadonlyMap<string, string>): Promise<FoundSeries> {
  const read = parseSeries(text, readyScene);
  if ('problem' in read) return { problem: seriesReason(read.problems) };
  const series = await readTasks(read.series, (file) => Promise.resolve(fileBeside(file, beside)));
  return shownAndKept({ series });
}

/** A file of a series among those that were opened with it. */
export function fileBeside(
  file: string,
  beside: ReadonlyMap<string, string>,
): { readonly text: string } | { readonly problem: string } {
  const text = beside.get(file.replace(/^.*\//, ''));
  return text === undefined ? { problem: say(words.fileBeside) } : { text };
}

/** A series as the page shows it, kept in this browser. @param address where it was fetched from */
export async function shownAndKept(read: ReadSeries, address?: string): Promise<FoundSeries> {
  if ('problem' in read) return { problem: seriesReason(read.problems) };
  const series = shownSeries(read.series);
  await keepSeries(series, address);
  return { series };
}

/** As pupils get it, whatever the file holds, but with the places of what cannot be read: it is told there. */
export function shownSeries(series: Series): Series {
  const given = new Map(seriesForPupils(series).tasks.map((task) => [task.id, task]));
  return { ...series, tasks: series.tasks.map((task) => given.get(task.id) ?? { ...task, from: bare(task.from) }) };
}

/** Without what the file says: it may hold what pupils must not see. */
const bare = (from: TaskSource): TaskSource => (from.kind === 'unread' ? { ...from, value: null } : from);
