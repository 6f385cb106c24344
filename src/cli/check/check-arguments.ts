import { availableParallelism } from 'node:os';
import { LANGUAGES, type Language } from '#core/languages';
import { shardOf, type Shard } from './shard';

/** The request to `parcours check`. */
export interface CheckOptions {
  /** The task and its hand-ins; `null`: the results in `folder` are joined, and nothing is run. */
  readonly work: {
    /** A task file, a project or a course, a link, the id of a ready course. */
    readonly task: string;
    /** Files, folders, zips, lists of links, links. */
    readonly handIns: readonly string[];
    /** Which file is the program, as `NAME=FILE`. */
    readonly take: readonly string[];
    /** Number of threads. */
    readonly jobs: number;
    readonly shard: Shard;
  } | null;
  /** Folder in which each result is stored, and looked up before anything is run; `null`: none. */
  readonly folder: string | null;
  /** Files for people and for other programs; `null`: not wanted. */
  readonly report: string | null;
  readonly junit: string | null;
  readonly csv: string | null;
  readonly table: string | null;
  readonly json: boolean;
  readonly quiet: boolean;
  /** The language of reports and reasons. */
  readonly lang: Language;
}

/** The options of `check` that take a value, without `--`. */
export const checkTexts = [
  'jobs',
  'report',
  'junit',
  'csv',
  'table',
  'take',
  'shard',
  'resume',
  'merge',
  'lang',
] as const;
const checkFlags: readonly string[] = ['json', 'quiet'];

/** Chosen: more threads than that no machine of a school has. */
const MOST_JOBS = 256;

const EXAMPLE = 'For example: parcours check closed-line class/ --report report.html';

/** Reads the words after `parcours check`, or says what is wrong with them. */
export function parseCheck(
  positionals: readonly string[],
  given: ReadonlyMap<string, readonly string[]>,
  set: ReadonlySet<string>,
  environment: Readonly<Record<string, string | undefined>>,
): CheckOptions | { readonly problem: string } {
  const known: readonly string[] = [...checkTexts, ...checkFlags];
  const strange = [...given.keys(), ...set].find((name) => !known.includes(name));
  if (strange !== undefined)
    return { problem: `--${strange} is not for check. Known: ${known.map((name) => `--${name}`).join(', ')}.` };
  const last = (name: (typeof checkTexts)[number]): string | null => given.get(name)?.at(-1) ?? null;
  const lang = LANGUAGES.find((one) => one === (last('lang') ?? 'en'));
  if (lang === undefined)
    return { problem: `--lang: "${last('lang') ?? ''}" is not available. Known: ${LANGUAGES.join(', ')}.` };
  const work =
    last('merge') === null
      ? workOf(positionals, last, environment, given.get('take') ?? [])
      : nothingToRun(positionals, given);
  if (work !== null && 'problem' in work) return work;
  return {
    work,
    folder: last('merge') ?? last('resume'),
    report: last('report'),
    junit: last('junit'),
    csv: last('csv'),
    table: last('table'),
    json: set.has('json'),
    quiet: set.has('quiet'),
    lang,
  };
}

type Problem = { readonly problem: string };

function workOf(
  [task, ...handIns]: readonly string[],
  last: (name: 'jobs' | 'shard') => string | null,
  environment: Readonly<Record<string, string | undefined>>,
  take: readonly string[],
): NonNullable<CheckOptions['work']> | Problem {
  if (task === undefined) return { problem: `Which task? ${EXAMPLE}` };
  if (handIns.length === 0) return { problem: `Which hand-ins? ${EXAMPLE}` };
  const jobs = last('jobs') === null ? availableParallelism() : Number(last('jobs'));
  if (!(Number.isInteger(jobs) && jobs >= 1 && jobs <= MOST_JOBS))
    return { problem: `--jobs: "${last('jobs') ?? ''}" is not a whole number from 1 to ${MOST_JOBS}.` };
  const shard = shardOf(last('shard'), environment);
  return 'problem' in shard ? shard : { task, handIns, take, jobs, shard };
}

function nothingToRun(
  [first]: readonly string[],
  given: ReadonlyMap<string, readonly string[]>,
): null | { readonly problem: string } {
  if (first !== undefined)
    return { problem: `--merge runs nothing: what is "${first}"? Its folder has the task, too.` };
  const other = ['jobs', 'shard', 'resume', 'take'].find((name) => given.has(name));
  return other === undefined ? null : { problem: `--${other} and --merge: choose one of them.` };
}
