import { parseSeries } from '#check/series/read-series';
import type { Series } from '#check/series/series';
import { seriesToText } from '#check/series/write-series';
import { isRecord } from '#core/record';

import { lateModel, type WithLate } from '../../../kit/state/late-models';
import { readyScene } from '../../work/catalogue/ready-courses';
import { entriesIn, inStore, type Entry } from '../../work/storage/database';

/** Names in the browser's database: a series by its id, and the one that is being made. */
const SERIES = 'series.of.';
const DRAFT = 'series.draft';

/** The series opened since the page was loaded: a browser without a database has them, too. */
const openedSeries = lateModel(() => new Map<string, Series>());

/**
 * Stores a series that was opened, so that the way back to it works after a reload and without a network. It is removed
 * when nobody has opened it for sixty days, as other pieces of work are.
 *
 * @param address its address, if it was fetched; left out: it was in a link or a file
 */
export async function keepSeries(app: WithLate, series: Series, address?: string): Promise<void> {
  openedSeries(app).set(series.id, series);
  await put(SERIES + series.id, { text: seriesToText(series), ...(address !== undefined && { address }) }, Date.now());
}

/** A series that was stored; `null`: this browser has none of that id. */
export async function reopenSeries(app: WithLate, id: string): Promise<Series | null> {
  const known = openedSeries(app).get(id);
  if (known !== undefined) return known;
  const entry = await entryOf(SERIES + id);
  const series = seriesIn(entry);
  const address = valueIn(entry)?.['address'];
  if (series !== null) await keepSeries(app, series, typeof address === 'string' ? address : undefined);
  return series;
}

/** A stored series that was fetched from this address; `null`: there is none. */
export async function storedSeriesAt(address: string): Promise<Series | null> {
  const entries = await entriesAt(() => IDBKeyRange.bound(SERIES, `${SERIES}~`));
  return seriesIn(entries.find((entry) => valueIn(entry)?.['address'] === address));
}

/** Stores the series that a teacher is making, solutions included, until another replaces it. */
export const keepDraft = (series: Series): Promise<void> => put(DRAFT, { text: seriesToText(series) }, Infinity);

/** The series that was being made when the page was left. */
export const keptDraft = async (): Promise<Series | null> => seriesIn(await entryOf(DRAFT));

const entryOf = async (name: string): Promise<Entry | undefined> => (await entriesAt(() => name))[0];

/** Stored entries; none in a browser without a database. */
async function entriesAt(names: () => string | IDBKeyRange): Promise<readonly Entry[]> {
  try {
    return await entriesIn(names());
  } catch {
    return [];
  }
}

async function put(name: string, value: object, usedMs: number): Promise<void> {
  try {
    await inStore(
      'readwrite',
      (store) => void store.put({ name, text: JSON.stringify(value), usedMs } satisfies Entry),
    );
  } catch {
    // nothing is kept
  }
}

function valueIn(entry: Entry | undefined): Readonly<Record<string, unknown>> | null {
  try {
    const value: unknown = JSON.parse(entry?.text ?? 'null');
    return isRecord(value) ? value : null;
  } catch {
    return null;
  }
}

function seriesIn(entry: Entry | undefined): Series | null {
  const text = valueIn(entry)?.['text'];
  const read = typeof text === 'string' ? parseSeries(text, readyScene) : null;
  return read !== null && 'series' in read ? read.series : null;
}
