import { unread, type Unread } from '#check/hand-in/unread';
import { readZip } from '#intake/zip';
import { unreadText } from '#check/report/say';
import { readTasks, taskOfText } from '#intake/read-files';
import { looksLikeSeries, parseSeries } from '#check/series/read-series';
import type { Series, SeriesTask } from '#check/series/series';
import { seriesOfLink } from '#check/series/series-link';
import { projectOfLink } from '#project/link/link';

import type { AddedFile } from '../page/files/added-files';
import { shownLanguage } from '../page/i18n';
import { say } from '../page/i18n/say';
import { fileBeside } from '../share/open-series';
import { MOST_SERIES_BYTES } from '../share/series-among';
import { linkReason, reasonOf } from '../share/problem-words';
import { seriesLinkReason, seriesReason } from '../share/series-reason';
import { readyCourse, readyScene } from '../work/catalogue/ready-courses';
import { seriesWords } from './series-words';

const words = seriesWords.make;

/** What was found to add: tasks, whole series, and in words what is neither. */
export interface Collected {
  readonly tasks: readonly Omit<SeriesTask, 'id'>[];
  /** Those in files of series, in which each file beside is read. */
  readonly series: readonly Series[];
  readonly refusals: readonly string[];
}

/** Largest file that is read, in bytes. Chosen: a project with a picture as floor has a few MB. */
const MOST_BYTES = 16 * 1024 * 1024;

/** The tasks in files that were dropped or chosen, also in folders and zips. */
export async function collectFiles(added: readonly AddedFile[]): Promise<Collected> {
  const texts = new Map<string, string>();
  const refusals: string[] = [];
  for (const { path, file } of added) {
    const bytes = file.size > MOST_BYTES ? null : new Uint8Array(await file.arrayBuffer());
    if (/\.json$/i.test(path) && bytes !== null) texts.set(path, new TextDecoder().decode(bytes));
    else if (/\.zip$/i.test(path) && bytes !== null) textsInZip(path, bytes, texts, refusals);
    else refusals.push(say(words.refused, { file: path, reason: say(words.kinds) }));
  }
  return tasksIn(texts, refusals);
}

/** Puts the texts of a zip to the others; more than a teacher has is told, and never unpacked. */
function textsInZip(path: string, bytes: Uint8Array, texts: Map<string, string>, refusals: string[]): void {
  const refuse = (file: string, problem: Unread): void => {
    refusals.push(say(words.refused, { file, reason: unreadText(problem, shownLanguage()) }));
  };
  const zip = readZip(bytes);
  if ('problem' in zip) return refuse(path, zip.problem);
  const wanted = zip.entries.filter((entry) => /\.json$/i.test(entry.path));
  if (wanted.reduce((sum, { size }) => sum + size, 0) > MOST_SERIES_BYTES)
    return refuse(path, unread('zip-much', { most: MOST_SERIES_BYTES }).problem);
  for (const entry of wanted) {
    // A directory may tell less than there is.
    const content = entry.read(Math.min(entry.size, MOST_BYTES));
    if ('problem' in content) refuse(`${path}/${entry.path}`, content.problem);
    else texts.set(entry.path, new TextDecoder().decode(content.bytes));
  }
}

async function tasksIn(texts: ReadonlyMap<string, string>, refusals: string[]): Promise<Collected> {
  const [tasks, series]: [Omit<SeriesTask, 'id'>[], Series[]] = [[], []];
  const beside = new Map([...texts].map(([path, text]) => [nameOf(path), text]));
  const isUsed = new Set<string>();
  for (const [path, text] of texts) {
    if (!looksLikeSeries(text)) continue;
    const read = parseSeries(text, readyScene);
    if ('problem' in read) refusals.push(say(words.refused, { file: path, reason: seriesReason(read.problems) }));
    else
      series.push(
        await readTasks(read.series, (file) => {
          isUsed.add(nameOf(file));
          return Promise.resolve(fileBeside(file, beside));
        }),
      );
  }
  for (const [path, text] of texts) {
    if (looksLikeSeries(text) || isUsed.has(nameOf(path))) continue;
    const from = taskOfText(text);
    if ('problems' in from) refusals.push(say(words.refused, { file: path, reason: reasonOf(from.problems) }));
    else tasks.push({ title: from.project.scene.name === '' ? stemOf(path) : '', from });
  }
  return { tasks, series, refusals };
}

const nameOf = (path: string): string => path.replace(/^.*\//, '');
const stemOf = (path: string): string =>
  nameOf(path)
    .replace(/(\.parcours)?\.json$/i, '')
    .slice(0, 120);

/** Links to projects and series, and to ready courses, whatever stands around them. */
const LINK = /[#\s>"']([ps]=\d{1,9}\.[\w-]+)|(?:#courses?[/=]|[?&]task=)([\w-]+)/g;

/** The tasks behind the links in a text. */
export function collectLinks(text: string): Collected {
  const [tasks, series, refusals]: [Omit<SeriesTask, 'id'>[], Series[], string[]] = [[], [], []];
  for (const [, fragment, course] of ` ${text}`.matchAll(LINK)) {
    if (fragment === undefined) {
      if (course === undefined || readyCourse(course) === null)
        refusals.push(say(seriesWords.noCourse, { course: course ?? '' }));
      else tasks.push({ title: '', from: { kind: 'course', course } });
    } else if (fragment.startsWith('s')) {
      const read = seriesOfLink(fragment, readyScene);
      if ('series' in read) series.push(read.series);
      else refusals.push(seriesLinkReason(read));
    } else {
      const read = projectOfLink(fragment, readyScene);
      if ('problem' in read) refusals.push(linkReason(read.problem));
      else tasks.push({ title: '', from: { kind: 'project', project: read.project } });
    }
  }
  const isNothing = tasks.length + series.length + refusals.length === 0;
  return { tasks, series, refusals: isNothing ? [say(words.noLinks)] : refusals };
}
