import type { AddedFile } from '../page/files/added-files';
import { seriesAmong } from '../share/series-among';
import type { ClassModel } from './model/class-model';
import { sourcesOf } from './sources-of';
import { bringSeries } from './task-series';

/** Takes files that were dropped, chosen or pasted: a series brings tasks, all others are hand-ins. @returns how many those are */
export async function takeFiles(model: ClassModel, files: readonly AddedFile[]): Promise<number> {
  const among = await seriesAmong(files);
  if (among !== null) bringSeries(model, among.read);
  const sources = await sourcesOf(among?.rest ?? files);
  if (sources.length > 0) await model.add(sources);
  return sources.length;
}
