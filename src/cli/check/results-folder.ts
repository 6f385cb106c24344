import { existsSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import type { Content } from '#intake/contents';
import { projectOfHandIn, type HandIn } from '#check/hand-in/hand-in';
import type { CheckResult } from '#check/result';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import { isRecord } from '#core/record';
import { documentOfText } from '#intake/text';
import { projectToText } from '#project/file';
import { version } from '../../../package.json';
import { KeptFolder, keyOf } from '../kept-folder';
import { reasonOf } from '../reason-of';
import { replaceFile } from '../write-output';
import type { NamedTask } from './read-task';

/** The task of a folder of results, and the names of its hand-ins, in order. */
export interface FolderContents extends NamedTask {
  readonly names: readonly string[];
}

type Problem = { readonly problem: string };

/**
 * The task as a file that the page can open, the list of the hand-ins, and the folder of the results, one file each.
 */
const [TASK, LIST, RESULTS] = ['task.json', 'hand-ins.json', 'results'];

/** A folder with a file for each result. */
export class ResultsFolder {
  private readonly results: KeptFolder;

  private constructor(
    private readonly path: string,
    private readonly taskKey: string,
  ) {
    this.results = new KeptFolder(join(path, RESULTS));
  }

  /** Opens a folder for a task and its hand-ins; makes it if it does not exist. */
  static open(path: string, { name, title, task, names }: FolderContents): ResultsFolder | Problem {
    try {
      const text = taskText(task);
      const folder = new ResultsFolder(path, keyOf(version, text));
      folder.results.make();
      const here = join(path, TASK);
      if (existsSync(here) && readFileSync(here, 'utf8') !== text)
        return { problem: `${path}: holds the results of another task. Choose another folder.` };
      replaceFile(here, text);
      replaceFile(join(path, LIST), `${JSON.stringify({ task: name, title, names })}\n`);
      return folder;
    } catch (error) {
      return { problem: `${path}: ${reasonOf(error)}` };
    }
  }

  /** The results of a folder, those of all shards. */
  static read(path: string): { readonly folder: ResultsFolder; readonly contents: FolderContents } | Problem {
    try {
      if (!statSync(path).isDirectory()) return { problem: `${path}: is no folder.` };
      const text = readFileSync(join(path, TASK), 'utf8');
      const document = documentOfText(text, () => null);
      const read = document.kind === 'project' ? taskOf(document.project) : { problem: `${TASK} holds no task.` };
      if ('problem' in read) return { problem: `${path}: ${read.problem}` };
      const list: unknown = JSON.parse(readFileSync(join(path, LIST), 'utf8'));
      if (!isList(list)) return { problem: `${path}: ${LIST} is damaged.` };
      const { task: name, names, title } = list;
      const contents = { name, ...(title !== undefined && { title }), task: read.task, names };
      return { folder: new ResultsFolder(path, keyOf(version, text)), contents };
    } catch (error) {
      return { problem: `${path}: is no folder of results: ${error instanceof SyntaxError ? `${LIST} is damaged.` : reasonOf(error)}` }; // prettier-ignore
    }
  }

  /** The file with the list of the hand-ins, which is rewritten. */
  static readonly listIn = (path: string): string => join(path, LIST);

  /** All its files. */
  files(): readonly string[] {
    return [join(this.path, TASK), join(this.path, LIST), ...this.results.files()];
  }

  /** The result of a hand-in, if one of this version, for this task and this program, is stored; else `null`. */
  find(name: string, key: string): CheckResult | null {
    const kept = this.kept(name);
    return kept !== null && kept.key === key ? kept.result : null;
  }

  /** The result of one person's hand-in, passed or not; `null`: none, or of another version or task. */
  latest(name: string): CheckResult | null {
    const kept = this.kept(name);
    return kept !== null && kept.taskKey === this.taskKey ? kept.result : null;
  }

  keep(name: string, key: string, result: CheckResult): void {
    this.results.keep(fileOf(name), { name, key, taskKey: this.taskKey, result } satisfies Kept);
  }

  /** Hash of everything that the result of a hand-in depends on; of an unreadable one, of why it cannot be read. */
  keyFor(content: Content): string {
    return 'problem' in content
      ? keyOf(this.taskKey, JSON.stringify(content.problem))
      : keyOf(this.taskKey, projectToText(projectOfHandIn(content.handIn)), otherOf(content.handIn));
  }

  /** Reads a stored result; a damaged one counts as missing. */
  private kept(name: string): Kept | null {
    const kept = this.results.find(fileOf(name));
    return isKept(kept) && kept.name === name ? kept : null;
  }
}

const fileOf = (name: string): string => keyOf(name).slice(0, 32);

/** The fields of a hand-in that its project's file lacks. */
const otherOf = ({ hasCourse, locks, mark, isEdited, coding }: HandIn): string =>
  JSON.stringify([hasCourse, locks, mark, isEdited, coding]);

/** The file of a result. */
interface Kept {
  readonly name: string;
  readonly key: string;
  readonly taskKey: string;
  readonly result: CheckResult;
}

const isKept = (value: unknown): value is Kept =>
  isRecord(value) &&
  typeof value['name'] === 'string' &&
  typeof value['key'] === 'string' &&
  typeof value['taskKey'] === 'string' &&
  isRecord(value['result']);

interface List extends Pick<NamedTask, 'title'> {
  readonly task: string;
  readonly names: readonly string[];
}

const isList = (value: unknown): value is List =>
  isRecord(value) &&
  typeof value['task'] === 'string' &&
  ['string', 'undefined'].includes(typeof value['title']) &&
  Array.isArray(value['names']) &&
  value['names'].every((name) => typeof name === 'string');

const taskText = (task: ClassTask): string => projectToText(projectOfTask(task));
