import type { AddedFile } from '../../kit/files/added-files';
import { HandInReader } from '../../session/run/reading/hand-in-reader';
import { readyCourses } from '../../session/work/catalogue/ready-courses';
import type { ClassModel } from './model/class-model';
import { offerSeries } from './task-series';

/** Reads hand-ins beside the page, for whoever takes some. */
export const handInReader = new HandInReader(() =>
  Object.fromEntries(readyCourses.map(({ id, scene }) => [id, scene])),
);

/**
 * Takes files that were dropped, chosen or pasted: a series brings tasks, all others are hand-ins as the command line
 * takes them. All are read in a worker.
 *
 * @returns number of hand-ins among them
 */
export async function takeFiles(model: ClassModel, files: readonly AddedFile[]): Promise<number> {
  const { series, sources } = await handInReader.open(files);
  if (series !== null) offerSeries(model, series);
  if (sources.length > 0) await model.add(sources);
  return sources.length;
}
