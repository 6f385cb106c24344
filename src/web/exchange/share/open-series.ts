import type { Series, TaskSource } from '#check/series/series';
import { seriesForPupils } from '#check/series/write-series';
import type { SeriesDocument, Unreadable } from '#intake/document';

import type { WithLate } from '../../kit/state/late-models';
import type { PageParts } from '../../kit/parts';
import { keepSeries } from '../../session/task/series/kept-series';
import { unreadableReason } from './unreadable-words';

/** The models that show an opened series. */
export interface ShowsSeries {
  readonly router: { open(name: string, id: string): void };
}

/** A series that can be shown, or in words why not; `isOld`: it could not be fetched now, this is an earlier copy. */
export type FoundSeries = { readonly series: Series; readonly isOld?: true } | { readonly problem: string };

/** Shows a series that came in files; one that cannot be read gives a message. */
export async function openSeries(
  app: Pick<PageParts, 'notices' | 'late'> & ShowsSeries,
  document: SeriesDocument | Unreadable,
): Promise<void> {
  const found = await shownAndKept(app, document);
  if ('series' in found) app.router.open('series', found.series.id);
  else app.notices.show({ kind: 'error', key: 'notice.text', values: { text: found.problem } });
}

/** A series as the page shows it, kept in this browser. @param address where it was fetched from */
export async function shownAndKept(
  app: WithLate,
  document: SeriesDocument | Unreadable,
  address?: string,
): Promise<FoundSeries> {
  if (document.kind === 'unreadable') return { problem: unreadableReason(document) };
  const series = shownSeries(document.series);
  await keepSeries(app, series, address);
  return { series };
}

/** A series as pupils get it, whatever its file holds. Tasks that cannot be read keep their places. */
export function shownSeries(series: Series): Series {
  const given = new Map(seriesForPupils(series).tasks.map((task) => [task.id, task]));
  return { ...series, tasks: series.tasks.map((task) => given.get(task.id) ?? { ...task, from: bare(task.from) }) };
}

/** An unread task without its content in the file, which may hold what pupils must not see. */
const bare = (from: TaskSource): TaskSource => (from.kind === 'unread' ? { ...from, value: null } : from);
