import { hasFeedback } from '#check/feedback/has-feedback';
import { unreadText } from '#check/report/say';
import type { CourseDocument, Document, HexDocument, Unreadable } from '#intake/document';
import { inMB, mostBytes, stemOf } from '#intake/formats';
import { defaultProjectSettings, newWork } from '#project/project';
import { mapNoteText } from '#rescue-line/say';

import type { PageParts } from '../../kit/parts';
import type { Workplace } from '../../session/work/model/parts';
import { MOST_AT_ONCE } from '../../session/work/storage/history';
import { bringTo } from '../../session/layout/brought-file';
import { hasNothingOwn } from '../../session/work/use-courses';
import { useOpenings } from '../../session/work/use-openings';
import { isReadyArena } from '../../session/work/catalogue/examples';
import { courseName } from '../../session/work/catalogue/first-course';
import { workName } from '../../session/work/work-name';
import { shownLanguage, t } from '../../kit/i18n';
import { tellOfCourse } from '../elsewhere/tell-of-course';
import type { ShowsSeries } from './open-series';
import { reasonOf } from './problem-words';
import words from './words';

/** The models that take projects, courses and pictures. */
export type TakesDocuments = Workplace &
  ShowsSeries & {
    /** The course editor's windows, where a picture becomes the floor. */
    readonly panels: {
      /** Returns `false` where the page has no arena. */
      offer(picture: Blob): boolean;
    };
  };

/** A file that was read. */
export interface Taken {
  readonly file: File;
  readonly document: Document;
}

/**
 * Opens projects, courses, runs and pictures, and puts the work so far aside; of several the last stays open, the others are
 * put aside like work of one's own. What cannot be opened gives a message.
 */
export async function openDocuments(app: TakesDocuments, taken: readonly Taken[]): Promise<void> {
  if (taken.length > MOST_AT_ONCE) {
    // More would push earlier ones, and the pupil's own work, out of what is kept.
    refuse(app, t(words.tooManyFiles, { count: taken.length, max: MOST_AT_ONCE }));
    return;
  }
  const refusals: string[] = [];
  for (const one of taken) {
    const refusal = await openDocument(app, one);
    if (refusal !== null) refusals.push(refusal);
  }
  if (refusals.length > 0) refuse(app, refusals.join(' '));
  else if (taken.length > 1) {
    const text = t(words.openedSeveral, { name: workName(app), count: taken.length - 1 });
    app.notices.show({ kind: 'ok', key: 'notice.text', values: { text } });
  }
}

/** @returns why it was not opened; `null`: it was */
async function openDocument(app: TakesDocuments, { file: loaded, document }: Taken): Promise<string | null> {
  const file = loaded.name;
  const { project: before, file: openFile } = app.work.work.value;
  const isFromFile = openFile !== undefined;
  switch (document.kind) {
    case 'picture':
      return app.panels.offer(loaded) ? null : t(words.problems.picture, { file });
    case 'recording': {
      const { openRun } = await import('./open-run');
      return openRun(app, { ...document, file, stem: plainStem(file) });
    }
    case 'project': {
      const { project } = document;
      const name = courseName(project.scene, project.course);
      useOpenings(app).open(project, name, !isFromFile && hasNothingOwn(before), plainStem(file));
      if (!hasFeedback(project)) return null;
      const { lookAtFeedback } = await import('./open-run');
      void lookAtFeedback(app, file);
      return null;
    }
    case 'course': {
      const { scene } = document;
      const name = scene.name === '' ? file : scene.name;
      useOpenings(app).openScene({ scene, course: null }, name, !isFromFile && isReadyArena(before.scene));
      tellOfCourse(app, document, false);
      tellOfMap(app, document);
      return null;
    }
    case 'hex': {
      openHexDocument(app, document, file);
      return null;
    }
    case 'tournament':
      bringTo(app, 'tournament', document.text);
      return null;
    case 'unreadable':
      return refusalOf(loaded, document);
    default:
      return t(words.problems.otherKind, { file });
  }
}

/** Opens the program of a board's file in the course that is open, and tells of what is not taken from it. */
function openHexDocument(app: TakesDocuments, { files, boards, ours, unfit }: HexDocument, file: string): void {
  const { project: before, file: openFile } = app.work.work.value;
  const { scene, course } = before;
  const isCalliope = boards.some((board) => board.startsWith('calliope'));
  const settings = isCalliope && { settings: { ...defaultProjectSettings, ...newWork, device: CALLIOPE } };
  const isOurs = openFile === undefined && hasNothingOwn(before);
  useOpenings(app).open({ files, scene, course, ...settings }, courseName(scene, course), isOurs, plainStem(file));
  const told = [
    ...(ours.length === 0 ? [] : [t(words.hexOurs, { file, names: ours.join(', ') })]),
    ...(unfit.length === 0 ? [] : [t(words.hexUnfit, { file, names: unfit.join(', ') })]),
  ].join(' ');
  tell(app, told);
}

/** Tells what of a map of a rescue line is not in its course. */
const tellOfMap = (app: TakesDocuments, { mapNotes }: CourseDocument): void =>
  tell(app, mapNotes.map((note) => mapNoteText(note, shownLanguage())).join(' '));

/** Tells something after work was opened; the button that goes back stays. */
function tell(app: TakesDocuments, text: string): void {
  if (text === '') return;
  const { action } = app.notices.current.value ?? {};
  app.notices.show({ kind: 'info', key: 'notice.text', values: { text }, ...(action && { action }) });
}

/** Id of the microcomputer for programs of any Calliope mini. */
const CALLIOPE = 'calliope-mini-3';

function refusalOf({ name: file, size: bytes }: File, { problem, problems }: Unreadable): string {
  if (problems.length > 0) return t(words.problems.file, { file, reason: reasonOf(problems) });
  if (problem.code === 'large')
    return t(words.problems.tooLargeFile, { file, size: inMB(bytes), max: inMB(mostBytes(file)) });
  if (problem.code.startsWith('hex-'))
    return t(words.problems.file, { file, reason: unreadText(problem, shownLanguage()) });
  const isReadAsText = problem.code === 'not-text' || problem.code === 'gone';
  return t(words.problems[isReadAsText ? 'unreadable' : 'otherKind'], { file });
}

/** A file's name without its ending and without the number that browsers add to a second download. */
const plainStem = (file: string): string => stemOf(file).replace(/ ?\(\d+\)$/, '') || file;

function refuse(app: Pick<PageParts, 'notices'>, text: string): void {
  app.notices.show({ kind: 'error', key: 'notice.text', values: { text } });
}
