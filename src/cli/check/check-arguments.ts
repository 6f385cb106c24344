import type { SpreadsheetForm } from '#core/csv';
import type { Language } from '#core/languages';
import { command, type Around, type Given, type Options, type Problem } from '../commands/about';
import {
  decimalsOption,
  formOf,
  jobsOf,
  jobsOption,
  langOption,
  languageOf,
  mergeOption,
  resumeOption,
  shardOption,
} from '../commands/shared-options';
import { shardOf, type Shard } from '../shard';

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
  /** The signs of `table`. */
  readonly form: SpreadsheetForm;
  /** True: groups of hand-ins by what their runs did, instead of names. */
  readonly groups: boolean;
  readonly json: boolean;
  readonly quiet: boolean;
  /** The language of reports and reasons. */
  readonly lang: Language;
}

const EXAMPLE = 'For example: parcours check closed-line class/ --report report.html';

const options = {
  jobs: jobsOption,
  report: { value: 'REPORT.html', path: 'writes', help: 'a page with drawings to print' },
  csv: { value: 'R.csv', path: 'writes', help: 'a table for programs' },
  table: { value: 'FILE.csv', path: 'writes', help: 'a table for a spreadsheet in the language of --lang' },
  decimals: decimalsOption,
  junit: { value: 'R.xml', path: 'writes', help: 'test results, for services that show those' },
  groups: { help: 'shows groups of what the runs did instead of names, in the report, too' },
  json: { help: 'one line at the end for other programs, the same for the same work' },
  quiet: { help: 'neither results nor progress' },
  lang: langOption('the language of results, reports and reasons; default: en'),
  shard: shardOption,
  take: {
    value: 'NAME=FILE',
    isRepeated: true,
    help: 'which of several files is the program of a hand-in',
  },
  resume: resumeOption,
  merge: mergeOption,
} as const satisfies Options;

export const checkAbout = command({
  summary: 'runs hand-ins against a task, and says who has passed',
  usage: ['TASK HAND-INS… [options]', '--merge DIR [options]'],
  text: [
    'TASK is a task file, a project or a course, a link, the id of a ready course such as closed-line, or a task of a series by its number or id: series.json#3, "LINK#3".',
    'HAND-INS are programs, project files, links, texts with links in them (.txt, .eml), folders and zips: there each file is a hand-in with its name, each sub-folder one whose program is main.py. What cannot be read is told and the rest goes on.',
    "Course, robot and chance are the task's; only the programs are the pupils'. A run may take as long as the task or the course says, else 300 simulated seconds.",
  ],
  words: [
    { name: 'TASK', choices: 'courses', path: 'reads' },
    { name: 'HAND-INS', path: 'reads', isRepeated: true },
  ],
  options,
  exits: {
    0: 'all have passed',
    2: 'something is wrong with the command, or a report could not be written',
    3: 'some have not passed',
  },
  examples: [
    'check closed-line class.zip --report report.html --lang de',
    'check task.json class/ --resume results --shard 2/7',
    'check closed-line class/ --groups --report groups.html',
    'check --merge results --table results.csv --lang de',
  ],
  read: readCheck,
});

type CheckGiven = Given<typeof options>;

const NO_TABLE = '--decimals: there is no table for a spreadsheet. Add --table FILE.csv.';

/** Reads the words after `parcours check`. */
function readCheck(words: readonly string[], given: CheckGiven, { variables }: Around): CheckOptions | Problem {
  const language = languageOf(given.last('lang'));
  if ('problem' in language) return language;
  const form = formOf(given.last('decimals'), language.lang);
  if ('problem' in form) return form;
  if (given.has('decimals') && !given.has('table')) return { problem: NO_TABLE };
  const work = given.has('merge') ? nothingToRun(words, given) : workOf(words, given, variables);
  if (work !== null && 'problem' in work) return work;
  return {
    work,
    folder: given.last('merge') ?? given.last('resume'),
    report: given.last('report'),
    junit: given.last('junit'),
    csv: given.last('csv'),
    table: given.last('table'),
    ...form,
    groups: given.has('groups'),
    json: given.has('json'),
    quiet: given.has('quiet'),
    ...language,
  };
}

function workOf(
  [task, ...handIns]: readonly string[],
  given: CheckGiven,
  variables: Around['variables'],
): NonNullable<CheckOptions['work']> | Problem {
  if (task === undefined) return { problem: `Which task? ${EXAMPLE}` };
  if (handIns.length === 0) return { problem: `Which hand-ins? ${EXAMPLE}` };
  const jobs = jobsOf(given.last('jobs'));
  if ('problem' in jobs) return jobs;
  const shard = shardOf(given.last('shard'), variables);
  return 'problem' in shard ? shard : { task, handIns, take: given.all('take'), ...jobs, shard };
}

function nothingToRun([first]: readonly string[], given: CheckGiven): null | Problem {
  if (first !== undefined)
    return { problem: `--merge runs nothing: what is "${first}"? Its folder has the task, too.` };
  const other = (['jobs', 'shard', 'resume', 'take', 'groups'] as const).find((name) => given.has(name));
  return other === undefined ? null : { problem: `--${other} and --merge: choose one of them.` };
}
