import { readZip, type ZipEntry } from '#intake/zip';
import { readTasks } from '#intake/read-files';
import { looksLikeSeries, parseSeries } from '#check/series/read-series';
import type { Series } from '#check/series/series';
import { SERIES_FILE } from '#check/series/write-series';

import type { AddedFile } from '../page/files/added-files';
import { say } from '../page/i18n/say';
import { readyScene } from '../work/catalogue/ready-courses';
import { seriesReason } from './series-reason';
import { shareWords } from './share-words';

/** A series with everything that its files hold, or in words why it cannot be read. */
export type WholeSeries = { readonly series: Series } | { readonly problem: string };

/** Largest file that is read, in bytes. Chosen: a project with a picture as floor has a few MB. */
const MOST_BYTES = 16 * 1024 * 1024;

/** All that is unpacked of the zip of a series, by its directory. Chosen: a hundred tasks, some with a picture. */
export const MOST_SERIES_BYTES = 64 * 1024 * 1024;

/** Title and text stand before the tasks. */
const HEAD_BYTES = 16 * 1024;

/** The files of a folder by their names. */
type Folder = ReadonlyMap<string, () => Promise<string>>;

/**
 * The series among files that were dropped or chosen, also in the zip of its folder; `null`: there is none.
 *
 * @returns it, and the files that do not belong to it
 */
export async function seriesAmong(
  added: readonly AddedFile[],
): Promise<{ readonly read: WholeSeries; readonly rest: readonly AddedFile[] } | null> {
  for (const one of added) {
    const others = added.filter((other) => other !== one);
    const zipped = /\.zip$/i.test(one.path) ? await folderInZip(one.file) : null;
    if (zipped !== null) return { read: await seriesIn(SERIES_FILE, zipped), rest: others };
    if (!/\.json$/i.test(one.path) || !looksLikeSeries(await one.file.slice(0, HEAD_BYTES).text())) continue;
    if (one.file.size > MOST_BYTES)
      return { read: { problem: say(shareWords.series.faults['too-large']) }, rest: others };
    const used = new Set([one]);
    const beside = others.filter(({ path, file }) => /\.json$/i.test(path) && file.size <= MOST_BYTES);
    const folder = new Map([...beside, one].map((other) => [nameOf(other.path), () => textOf(other, used)]));
    return { read: await seriesIn(nameOf(one.path), folder), rest: added.filter((other) => !used.has(other)) };
  }
  return null;
}

async function textOf(one: AddedFile, used: Set<AddedFile>): Promise<string> {
  used.add(one);
  return one.file.text();
}

async function folderInZip(file: File): Promise<Folder | null> {
  const zip = file.size > MOST_BYTES ? null : readZip(new Uint8Array(await file.arrayBuffer()));
  if (zip === null || 'problem' in zip) return null;
  const files = zip.entries.filter(({ path }) => /\.json$/i.test(path));
  if (files.reduce((sum, { size }) => sum + size, 0) > MOST_SERIES_BYTES) return null;
  const folder = new Map(files.map((entry) => [nameOf(entry.path), () => Promise.resolve(textIn(entry))]));
  return looksLikeSeries((await folder.get(SERIES_FILE)?.()) ?? '') ? folder : null;
}

function textIn(entry: ZipEntry): string {
  // A directory may tell less than there is.
  const read = entry.read(Math.min(entry.size, MOST_BYTES));
  return 'bytes' in read ? new TextDecoder().decode(read.bytes) : '';
}

async function seriesIn(name: string, folder: Folder): Promise<WholeSeries> {
  const read = parseSeries((await folder.get(name)?.()) ?? '', readyScene);
  if ('problem' in read) return { problem: seriesReason(read.problems) };
  const series = await readTasks(read.series, async (file) => {
    const text = await folder.get(nameOf(file))?.();
    return text === undefined ? { problem: say(shareWords.series.fileBeside) } : { text };
  });
  return { series };
}

const nameOf = (path: string): string => path.replace(/^.*\//, '');
