import { looksLikeSeries } from '#check/series/read-series';
import { openJson } from '#project/open-json';
import { isTapeFile } from '#tape/tape';

import type { PageParts } from '../page/parts';
import type { Workplace } from '../work/model/parts';
import { KEPT_ANYWAY } from '../work/storage/history';
import { isOurs } from '../work/use-courses';
import { useOpenings } from '../work/use-openings';
import { isReadyArena } from '../work/catalogue/examples';
import { courseName } from '../work/catalogue/first-course';
import { workName } from '../work/work-name';
import { say } from '../page/i18n/say';
import type { ShowsSeries } from './open-series';
import { reasonOf } from './problem-words';
import { shareWords as words } from './share-words';

/** Where projects, courses and pictures are taken in. */
export type TakesDocuments = Workplace &
  ShowsSeries & {
    /** The course editor's windows, where a picture becomes the floor. */
    readonly panels: {
      /** Returns `false` where the page has no arena. */
      offer(picture: Blob): boolean;
    };
  };

/** Files that may become the floor. */
const PICTURE = /\.(png|jpe?g|svg)$/i;

/** Largest file of JSON that is read: a project with a picture as floor has a few MB. */
const MAX_BYTES = 16 * 1024 * 1024;

/**
 * Opens projects and courses from files, and puts the work so far aside; of several the last stays open, the others are
 * put aside like work of one's own. A file that cannot be opened gives a message.
 */
export async function openJsonFiles(app: TakesDocuments, files: readonly File[]): Promise<void> {
  if (await hasSeries(app, files)) return;
  if (files.length > KEPT_ANYWAY) {
    // More would push earlier ones, and the pupil's own work, out of what is kept.
    refuse(app, say(words.tooManyFiles, { count: files.length, max: KEPT_ANYWAY }));
    return;
  }
  const refusals: string[] = [];
  for (const file of files) {
    const refusal = await openJsonFile(app, file);
    if (refusal !== null) refusals.push(refusal);
  }
  if (refusals.length > 0) refuse(app, refusals.join(' '));
  else if (files.length > 1) {
    const text = say(words.openedSeveral, { name: workName(app), count: files.length - 1 });
    app.notices.show({ kind: 'ok', key: 'notice.text', values: { text } });
  }
}

/** Whether one of the files is a series: that is opened, with the tasks in the others. */
async function hasSeries(app: TakesDocuments, files: readonly File[]): Promise<boolean> {
  const texts = new Map<string, string>();
  for (const file of files)
    if (/\.json$/i.test(file.name) && file.size <= MAX_BYTES) texts.set(file.name, (await textOf(file)) ?? '');
  if (![...texts.values()].some(looksLikeSeries)) return false;
  const { openSeriesAmong } = await import('./open-series');
  return openSeriesAmong(app, texts);
}

/** @returns why the file was not opened; `null`: it was */
async function openJsonFile(app: TakesDocuments, loaded: File): Promise<string | null> {
  const file = loaded.name;
  if (PICTURE.test(file)) return app.panels.offer(loaded) ? null : say(words.problems.picture, { file });
  if (!file.toLowerCase().endsWith('.json')) return say(words.problems.otherKind, { file });
  if (loaded.size > MAX_BYTES) {
    const size = Math.ceil(loaded.size / 1024 / 1024);
    return say(words.problems.tooLargeFile, { file, size, max: MAX_BYTES / 1024 / 1024 });
  }
  const text = await textOf(loaded);
  if (text === null) return say(words.problems.unreadable, { file });
  if (isTapeFile(text)) {
    const { openRun } = await import('./open-run');
    return openRun(app, { text, file, stem: stemOf(file), atUs: 0 });
  }
  const opened = openJson(text);
  if (opened.kind === 'problem') return say(words.problems.file, { file, reason: reasonOf(opened.problems) });
  const { project, file: openFile } = app.work.work.value;
  const isFromFile = openFile !== undefined;
  if (opened.kind === 'project') {
    const name = courseName(opened.project.scene, opened.project.course);
    useOpenings(app).open(opened.project, name, !isFromFile && isOurs(project), stemOf(file));
  } else {
    const { scene } = opened;
    const name = scene.name === '' ? file : scene.name;
    useOpenings(app).openScene({ scene, course: null }, name, !isFromFile && isReadyArena(project.scene));
  }
  return null;
}

/** A file's name without its ending and without the number that browsers add to a second download. */
const stemOf = (file: string): string =>
  file.replace(/(\.parcours|\.run)?\.json$/i, '').replace(/ ?\(\d+\)$/, '') || file;

function refuse(app: Pick<PageParts, 'notices'>, text: string): void {
  app.notices.show({ kind: 'error', key: 'notice.text', values: { text } });
}

async function textOf(file: File): Promise<string | null> {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    return null;
  }
}
