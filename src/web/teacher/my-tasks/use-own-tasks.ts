import { aboutOf, type ShelfWork } from '#check/shelf/shelf';
import { shelfToFolder, workToText } from '#check/shelf/write-shelf';
import { taskFileName } from '#check/series/write-series';
import { draftOf } from '#check/task/read-task';
import { noAbout } from '#check/task/about';
import { hiddenWorlds } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import type { Project } from '#project/project';

import type { AddedFile } from '../../kit/files/added-files';
import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import type { LayoutParts } from '../../session/layout/parts';
import type { Workplace } from '../../session/work/model/parts';
import { fileName, saveBlob, saveText } from '../../session/work/save-file';
import { hasNothingOwn } from '../../session/work/use-courses';
import { useOpenings } from '../../session/work/use-openings';
import { zipOf } from '../../session/work/zip';
import { collectFiles, type Collected } from '../series/collect';
import { seriesDraft } from '../series/series-draft';
import type { ShelfItem } from '../shelf/task-shelf';
import { shelfOf } from '../shelf/use-shelf';
import { sceneOfWork, workNameOf, workTextOf } from '../shelf/work-name-of';
import shelfWords from '../shelf/words';
import type { ShelfRow } from './shelf-rows';
import words from './words';

/** The models that the page of the own tasks works on. */
export type TasksApp = Workplace & Pick<PageParts, 'late'> & Pick<LayoutParts, 'router'>;

/** A row with the work behind it. */
export interface OwnRow extends ShelfRow {
  readonly item: ShelfItem;
}

/** A work of the shelf as a row. */
export const rowOf = (item: ShelfItem): OwnRow => ({
  ...{ id: item.key, item, name: workNameOf(item.work), text: workTextOf(item.work) },
  ...{ about: aboutOf(item.work) ?? noAbout, scene: sceneOfWork(item.work), size: sizeOf(item.work) },
});

function sizeOf(work: ShelfWork): string {
  if (work.kind === 'series') return t(words.tasks, { count: work.series.tasks.length });
  const read = work.project.task === undefined ? null : draftOf(work.project);
  const hidden = read !== null && 'task' in read ? hiddenWorlds(read.task).length : 0;
  return hidden === 0 ? '' : t(words.worlds, { count: hidden + 1 });
}

/** Opens a work where it is made: a task in the arena and with its page, a series on its own page. */
export function openWork(app: TasksApp, work: ShelfWork): void {
  const name = workNameOf(work);
  if (work.kind === 'task') {
    useOpenings(app).open(work.project, name, hasNothingOwn(app.work.work.value.project));
    app.router.open('task');
    return;
  }
  const draft = seriesDraft(app);
  const before = draft.series.value;
  draft.replace(work.series);
  app.router.open('make-series');
  if (before.tasks.length === 0) return;
  const text = t(words.seriesOpened, { name });
  const holds = (): boolean => draft.series.value === work.series;
  const action = { key: 'notice.undo', run: () => draft.replace(before) } as const;
  app.notices.show({ kind: 'ok', key: 'notice.text', values: { text }, action, holds });
}

/** Saves a work as its file. */
export const saveWork = ({ notices }: Pick<PageParts, 'notices'>, work: ShelfWork): void =>
  saveText(
    { notices },
    fileName(workNameOf(work), work.kind === 'task' ? 'parcours.json' : 'series.json'),
    workToText(work),
    'application/json',
  );

/** Saves works as a folder in a zip, with the list by which a page opens it from a web server. */
export function saveFolder(works: readonly ShelfWork[]): void {
  const named = works.map((work) => ({ work, name: workNameOf(work), text: workTextOf(work) }));
  const folder = taskFileName(t(shelfWords.title));
  const files = shelfToFolder('', named).map(({ name, text }) => ({ name: `${folder}/${name}`, text }));
  saveBlob(`${folder}.zip`, new Blob([zipOf(files)], { type: 'application/zip' }));
}

/** Puts the tasks and series in files onto the shelf, and says how many. @returns why others cannot be read, in words */
export async function addFiles(app: TasksApp, files: readonly AddedFile[]): Promise<readonly string[]> {
  const collected = await collectFiles(files);
  const undos: (() => Promise<void>)[] = [];
  // The newest is first on the shelf: the first file is to be.
  for (const work of worksIn(collected).toReversed()) {
    const kept = await shelfOf(app).keep(work);
    undos.push(kept.undo);
  }
  if (undos.length > 0) {
    const text = t(words.added, { count: undos.length });
    const undo = async (): Promise<void> => {
      for (const one of undos.toReversed()) await one();
    };
    const action = { key: 'notice.undo', run: () => void undo() } as const;
    app.notices.show({ kind: 'ok', key: 'notice.text', values: { text }, action });
  }
  return collected.refusals;
}

/** The works in what was collected. A task without a name has that of its file. */
export const worksIn = ({ tasks, series }: Pick<Collected, 'tasks' | 'series'>): readonly ShelfWork[] => [
  ...tasks.flatMap(({ title, from }): ShelfWork[] => {
    if (from.kind !== 'project') return [];
    const { scene } = from.project;
    const project = title === '' ? from.project : { ...from.project, scene: { ...scene, name: title } };
    return [{ kind: 'task', project: teachersOwn(project) }];
  }),
  ...series.map((one): ShelfWork => ({ kind: 'series', series: one })),
];

/** A task that somebody has handed out or in is the teacher's own on the shelf: it can be changed. */
function teachersOwn({ handIn: _, ...project }: Project): Project {
  const read = project.task?.['handedOut'] === true ? draftOf(project) : null;
  return read !== null && 'task' in read ? projectOfTask(read.task) : project;
}
