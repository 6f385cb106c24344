import { otherTask } from '#check/hand-in/other-task';
import { classResult } from '#check/report/class-result';
import { contentOf, type Source } from '#intake/sources';
import { addResults } from '#school-class/add-results';
import { addedTexts, strangeText } from '#school-class/report/say';
import type { SchoolClass } from '#school-class/school-class';
import { checkAll, Progress } from '../check/check-command';
import { startThread } from '../check/pool';
import { readTasks, titleOf, type NamedTask } from '../check/read-task';
import { findHandIns } from '../check/sources';
import { readFirmware } from '../firmware';
import { outputProblem } from '../outputs';
import type { Terminal } from '../terminal';
import type { ClassOptions } from './class-arguments';
import type { Done } from './class-file';

/** Checks hand-ins of a task, or of the tasks of a series, and adds the results to a class. */
export async function addHandIns(given: SchoolClass, options: ClassOptions, terminal: Terminal): Promise<Done> {
  const { file, others, lang } = options;
  const [word = '', ...paths] = others;
  const tasks = await readTasks(word);
  if ('problem' in tasks) return tasks;
  const found = await findHandIns(paths);
  if ('problem' in found) return found;
  if (found.sources.length === 0) return { problem: `${paths.join(', ')}: there are no hand-ins.` };
  const reads = [...tasks.flatMap(({ files }) => files), ...found.files];
  const unwritable = outputProblem([{ option: 'class add', path: file }], reads, 'check');
  if (unwritable !== null) return { problem: unwritable };
  const { groups, strange } = await sorted(found.sources, tasks);
  const said = strange.length === 0 ? [] : [strangeText(strange, lang)];
  const firmware = await WebAssembly.compile(readFirmware());
  let schoolClass = given;
  for (const [named, sources] of groups) {
    const added = await addTask(schoolClass, { named, sources, firmware }, options, terminal);
    schoolClass = added.schoolClass;
    said.push(...added.said);
  }
  return { schoolClass, said };
}

/** Hand-ins by the tasks that they were made for; of a single task all are. */
async function sorted(
  sources: readonly Source[],
  tasks: readonly NamedTask[],
): Promise<{ readonly groups: ReadonlyMap<NamedTask, readonly Source[]>; readonly strange: readonly string[] }> {
  const [only, another] = tasks;
  if (only !== undefined && another === undefined) return { groups: new Map([[only, sources]]), strange: [] };
  const groups = new Map<NamedTask, Source[]>();
  const strange: string[] = [];
  for (const source of sources) {
    const named = await taskFor(source, tasks);
    if (named === undefined) strange.push(source.name);
    else groups.set(named, [...(groups.get(named) ?? []), source]);
  }
  return { groups, strange };
}

/** The task that a hand-in says it was made for. A program alone says none. */
async function taskFor(source: Source, tasks: readonly NamedTask[]): Promise<NamedTask | undefined> {
  const content = await contentOf(source);
  if ('problem' in content || !content.handIn.hasCourse) return undefined;
  return tasks.find(({ task }) => otherTask(task, content.handIn) === null);
}

interface Group {
  readonly named: NamedTask;
  readonly sources: readonly Source[];
  /** The VM, which all tasks share. */
  readonly firmware: WebAssembly.Module;
}

async function addTask(
  given: SchoolClass,
  { named, sources, firmware }: Group,
  { jobs, quiet, json, day, lang }: ClassOptions,
  terminal: Terminal,
): Promise<{ readonly schoolClass: SchoolClass; readonly said: readonly string[] }> {
  const { task } = named;
  const progress = new Progress(terminal, sources.length, quiet || json, lang);
  const start = startThread(task, firmware);
  const results = await checkAll(task, sources, start, { jobs, folder: null, keepsWays: false, progress });
  terminal.clearProgress();
  const found = classResult(titleOf(named, lang), results, lang);
  const checked = { task, found, day };
  const added = addResults(given, checked);
  return { schoolClass: added.schoolClass, said: addedTexts(added, checked, lang) };
}
