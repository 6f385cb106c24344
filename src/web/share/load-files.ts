import { withFiles } from '#project/devices';
import { FILE_BYTES, freeName, nameProblem, type SourceFile } from '#project/project';

import { stampSettings } from '../work/stamp-settings';
import type { PageParts } from '../page/parts';
import type { RunParts } from '../run/parts';
import type { WorkParts, Workplace } from '../work/model/parts';
import { useOpenings } from '../work/use-openings';
import { workName } from '../work/work-name';
import type { TakesDocuments } from './open-json';
import { latePart } from '../page/late-part';

/** Where files of all kinds are taken in. */
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

/** Takes files in. A file with a new name is shown at once; for a taken name `ask` decides. Nothing is ever overwritten here. */
export async function loadFiles(
  app: TakesFiles,
  files: Iterable<File>,
  ask: (conflict: Conflict) => void,
): Promise<void> {
  const all = [...files];
  const isPython = ({ name }: File): boolean => name.toLowerCase().endsWith('.py');
  // Programs come last: they belong into the project that comes with them.
  const others = all.filter((file) => !isPython(file));
  const logs = others.filter(isLog);
  const rest = others.filter((file) => !isLog(file));
  if (rest.length > 0) await late(app, import('./open-json'), ({ openJsonFiles }) => openJsonFiles(app, rest));
  if (logs.length > 0)
    await late(app, import('../device-log/open-device-log'), ({ openDeviceLogs }) => openDeviceLogs(app, logs));
  for (const loaded of all.filter(isPython)) {
    const file = await readFile(app, loaded);
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

/** What a real board has logged, also on the way through a spreadsheet. */
const isLog = ({ name }: File): boolean => /\.(?:html?|csv|tsv|txt|xlsx?|ods)$/i.test(name);

/** Opens what is no program: what does that comes late. */
async function late<T>({ notices }: TakesFiles, part: Promise<T>, act: (part: T) => Promise<void>): Promise<void> {
  const come = await part.catch(() => null);
  if (come === null) notices.show(latePart);
  else await act(come);
}

async function readFile({ notices }: Pick<PageParts, 'notices'>, loaded: File): Promise<SourceFile | null> {
  const file = loaded.name;
  if (nameProblem(file, []) !== null) {
    notices.show({ kind: 'error', key: 'files.notPython', values: { file } });
    return null;
  }
  if (loaded.size > FILE_BYTES) {
    const values = { file, size: Math.ceil(loaded.size / 1024), max: FILE_BYTES / 1024 };
    notices.show({ kind: 'error', key: 'files.tooLarge', values });
    return null;
  }
  try {
    const text = new TextDecoder('utf-8', { fatal: true }).decode(await loaded.arrayBuffer());
    return { name: file, text: text.replaceAll('\r\n', '\n') };
  } catch {
    notices.show({ kind: 'error', key: 'files.notText', values: { file } });
    return null;
  }
}

/** Replaces the file of the same name by a loaded one. All of the work is put aside first and can be brought back. */
export function replaceFile(app: Workplace, file: SourceFile): void {
  const { work, keeper, files, place } = app.work;
  const wished = files.value.map((own) => (own.name === file.name ? file : own));
  const { project } = work.value;
  // The open task may keep lines of it, and says so.
  if (keeper.value?.changed(project, withFiles(project, place.value, wished), false) === null) return;
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
