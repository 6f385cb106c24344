import { documentOfAddress, documentOfSeriesLink } from '#intake/address';
import type { Unreadable } from '#intake/document';
import { openGiven } from '#intake/file';
import { taskLinksIn } from '#intake/links';
import { tasksAmong, type TasksAmong } from '#intake/series-among';

import { treeFile, type AddedFile } from '../../kit/files/added-files';
import { t } from '../../kit/i18n';
import { unreadableReason } from '../../exchange/share/unreadable-words';
import { readyCourse, readyScene } from '../../session/work/catalogue/ready-courses';
import seriesWords from './words';

const words = seriesWords.make;

/** Tasks and whole series to add, and messages on everything else. */
export interface Collected extends Pick<TasksAmong, 'tasks' | 'series'> {
  readonly refusals: readonly string[];
}

/** The tasks in files that were dropped or chosen, also in folders and zips. */
export async function collectFiles(added: readonly AddedFile[]): Promise<Collected> {
  const opened = await Promise.all(added.map((one) => openGiven(treeFile(one))));
  const { tasks, series, unreadable } = await tasksAmong(opened, readyScene);
  const reasonOf = (document: Unreadable): string =>
    document.problem.code === 'kind' ? t(words.kinds) : unreadableReason(document);
  const refusals = unreadable.map(({ file, document }) => t(words.refused, { file, reason: reasonOf(document) }));
  return { tasks, series, refusals };
}

/** The tasks behind the links in a text. */
export function collectLinks(text: string): Collected {
  const found = taskLinksIn(text).map((given): Collected => {
    if ('link' in given) return linked(given.link);
    const { course } = given;
    if (readyCourse(course) === null) return refused(t(seriesWords.noCourse, { course }));
    return { ...refused(), tasks: [{ title: '', from: { kind: 'course', course } }] };
  });
  const [tasks, series] = [found.flatMap((one) => one.tasks), found.flatMap((one) => one.series)];
  return { tasks, series, refusals: found.length === 0 ? [t(words.noLinks)] : found.flatMap((one) => one.refusals) };
}

function linked(link: string): Collected {
  const address = documentOfAddress(link, readyScene);
  const document = address.kind === 'series-link' ? documentOfSeriesLink(address.link, readyScene) : address;
  if (document.kind === 'series') return { ...refused(), series: [document.series] };
  if (document.kind === 'unreadable') return refused(unreadableReason(document));
  return document.kind === 'project'
    ? { ...refused(), tasks: [{ title: '', from: { kind: 'project', project: document.project } }] }
    : refused(t(words.noLinks));
}

const refused = (...refusals: readonly string[]): Collected => ({ tasks: [], series: [], refusals });
