import { documentIn, openFile, openGiven } from '#intake/file';
import { formatOf, limits, mayBeLog } from '#intake/formats';
import { seriesAmong } from '#intake/series-among';
import type { TreeFile } from '#intake/tree';
import { withFiles } from '#project/devices';
import { freeName, nameProblem, type SourceFile } from '#project/project';

import { stampSettings } from '../../session/work/stamp-settings';
import type { PageParts } from '../../kit/parts';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts, Workplace } from '../../session/work/model/parts';
import { useOpenings } from '../../session/work/use-openings';
import { workName } from '../../session/work/work-name';
import { openDocuments, type Taken, type TakesDocuments } from './open-documents';
import { treeFile } from '../../kit/files/added-files';
import { latePart } from '../../kit/late-part';
import { readyScene } from '../../session/work/catalogue/ready-courses';

/** The models that take files of all kinds. */
export type TakesFiles = TakesDocuments & Pick<RunParts, 'dataLog'>;

/** A loaded file whose name is taken: the pupil decides what happens to it. */
export interface Conflict {
  readonly file: SourceFile;
  /** The free name it could have. */
  readonly as: string;
}

/** Takes files in, and asks about each whose name is taken. */
export const takeFiles = (app: TakesFiles, files: Iterable<File>): Promise<void> =>
  loadFiles(app, files, ({ file, as }) =>
    app.dialogs.ask({
      kind: 'choose',
      title: 'files.askTitle',
      text: 'files.askText',
      values: { file: file.name },
      choices: [
        { key: 'code.cancel', run: () => undefined },
        { key: 'files.askReplace', look: 'outline', run: () => replaceFile(app, file) },
        { key: 'files.askRename', values: { as }, look: 'run', run: () => loadBeside(app, file) },
      ],
    }),
  );

/** Takes files in. One with a new name is shown at once; for a taken name `ask` decides, unless that file is blank. */
export async function loadFiles(
  app: TakesFiles,
  files: Iterable<File>,
  ask: (conflict: Conflict) => void,
): Promise<void> {
  const all = [...files];
  // Programs come last: they belong into the project that comes with them.
  const programs = all.filter(({ name }) => formatOf(name) === 'program');
  await takeOthers(app, all.filter((file) => !programs.includes(file))); // prettier-ignore
  for (const loaded of programs) {
    const file = await readProgram(app, loaded);
    if (file === null) continue;
    const own = app.work.find(file.name);
    if (own?.text === file.text) app.work.show(file.name);
    else if (own === undefined) app.work.create(file.name, file.text);
    else if (own.text.trim() === '') app.work.setText(file.name, file.text);
    else {
      ask({ file, as: freeName(file.name, app.work.files.value) });
      continue;
    }
    app.notices.show({ kind: 'ok', key: 'files.loaded', values: { file: file.name } });
  }
}

/** Opens files that are no programs. A series is opened with the tasks in the others, and no work besides. */
async function takeOthers(app: TakesFiles, files: readonly File[]): Promise<void> {
  const opened = await Promise.all(files.map((file) => openGiven(asTree(file))));
  const among = await seriesAmong(opened, readyScene);
  const taken: Taken[] = [];
  for (const [place, one] of opened.entries()) {
    const [file, isRest] = [files[place], among?.rest.includes(one) ?? true];
    const most = mayBeLog(one.file.path) ? limits.log : undefined;
    if (file !== undefined && isRest) taken.push({ file, document: await documentIn(one, readyScene, most) });
  }
  const isLog = ({ file, document }: Taken): boolean => mayBeLog(file.name) && document.kind !== 'links';
  const [logs, works] = [taken.filter(isLog), taken.filter((one) => !isLog(one))];
  if (among !== null) await late(app, import('./open-series'), ({ openSeries }) => openSeries(app, among.document));
  else if (works.length > 0) await openDocuments(app, works);
  if (logs.length > 0)
    await late(app, import('../../pupil/device-log/open-device-log'), ({ openDeviceLogs }) =>
      openDeviceLogs(app, logs),
    );
}

const asTree = (file: File): TreeFile => treeFile({ path: file.name, file });

/** Uses a part of the page that only some files need, once it is loaded; a message says if it cannot be. */
async function late<T>(
  { notices }: TakesFiles,
  part: Promise<T>,
  act: (part: T) => void | Promise<void>,
): Promise<void> {
  const come = await part.catch(() => null);
  if (come === null) notices.show(latePart);
  else await act(come);
}

async function readProgram({ notices }: Pick<PageParts, 'notices'>, loaded: File): Promise<SourceFile | null> {
  const file = loaded.name;
  if (nameProblem(file, []) !== null) {
    notices.show({ kind: 'error', key: 'files.notPython', values: { file } });
    return null;
  }
  const document = await openFile(asTree(loaded), readyScene);
  const [program] = document.kind === 'program' ? document.files : [];
  if (program !== undefined) return { name: file, text: program.text.replaceAll('\r\n', '\n') };
  const isLarge = document.kind === 'unreadable' && document.problem.code === 'large';
  const values = { file, size: Math.ceil(loaded.size / 1024), max: limits.program / 1024 };
  notices.show({ kind: 'error', key: isLarge ? 'files.tooLarge' : 'files.notText', values });
  return null;
}

/** Replaces the file of the same name by a loaded one. All of the work is put aside first and can be brought back. */
export function replaceFile(app: Workplace, file: SourceFile): void {
  const { work, locks, files, place } = app.work;
  const wished = files.value.map((own) => (own.name === file.name ? file : own));
  const { project } = work.value;
  // The open task may keep lines of it, and says so.
  if (locks.changed(project, withFiles(project, place.value, wished), false) === null) return;
  stampSettings(app);
  app.work.replace(file, workName(app));
  const kept = app.work.work.value.previous[0];
  const action = kept && ({ key: 'course.restore', run: () => useOpenings(app).restore(kept) } as const);
  app.notices.show({ kind: 'ok', key: 'files.replaced', values: { file: file.name }, ...(action && { action }) });
}

/** Takes a loaded file in under a name that is free. */
export function loadBeside(app: Pick<PageParts, 'notices'> & Pick<WorkParts, 'work'>, file: SourceFile): void {
  const as = app.work.takeIn(file);
  app.notices.show({ kind: 'ok', key: 'files.loadedAs', values: { file: file.name, as } });
}
