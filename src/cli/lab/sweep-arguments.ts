import type { Language } from '#core/languages';
import { command, type Around, type Given, type Options, type Problem } from '../commands/about';
import {
  jobsOf,
  jobsOption,
  langOption,
  languageOf,
  mergeOption,
  resumeOption,
  shardOption,
} from '../commands/shared-options';
import { chanceOptions, readSetup, setupOptions, timeOption, type SetupAsked } from '../run-arguments';
import { shardOf, type Shard } from '../shard';

/** The request to `parcours sweep`. */
export interface SweepOptions {
  /** The runs; `null`: the results in `folder` are joined, and nothing is run. */
  readonly work: {
    /** The run that varies. */
    readonly run: SetupAsked;
    /** `WHAT=VALUES`, at least one. */
    readonly vary: readonly string[];
    readonly jobs: number;
    readonly shard: Shard;
  } | null;
  /** Folder in which each result is stored, and looked up before anything is run; `null`: none. */
  readonly folder: string | null;
  /** Files for people and for other programs; `null`: not wanted. */
  readonly csv: string | null;
  readonly report: string | null;
  readonly json: boolean;
  readonly quiet: boolean;
  readonly lang: Language;
}

/** The options that say which runs are made. */
const runOptions = {
  vary: {
    value: 'WHAT=VALUES',
    isRepeated: true,
    help: 'varies a number from run to run. WHAT: main.py:5 (the only number of the line), main.py:5.2 (its second one), seed, reality, start.x, start.y, start.heading, option.ID. VALUES: 500..900/50, 500..900#9, 500,650,800',
  },
  ...setupOptions,
  ...timeOption,
  ...chanceOptions,
  jobs: { heading: 'How many at a time', ...jobsOption },
  shard: shardOption,
  resume: resumeOption,
} as const satisfies Options;

const ofRuns = Object.keys(runOptions) as (keyof typeof runOptions)[];

const options = {
  ...runOptions,
  merge: mergeOption,
  csv: { heading: 'What you get', value: 'R.csv', path: 'writes', help: 'a table for programs' },
  report: { value: 'REPORT.html', path: 'writes', help: 'a page with curve or map and a table' },
  json: { help: 'one line at the end for other programs, the same for the same work' },
  quiet: { help: 'neither results nor progress' },
  lang: langOption('the language of results and report; default: en'),
} as const satisfies Options;

export const sweepAbout = command({
  summary: 'runs a program with many values of a number, and compares what comes out',
  usage: [
    'MAIN.py --vary WHAT=VALUES [options]',
    'PROJECT.json|HEX.hex|LINK --vary WHAT=VALUES [options]',
    '--merge DIR [options]',
  ],
  text: [
    'Each run is what parcours run makes of the program with the number written into it. Without --for it lasts as with --until-verdict in a course with a task, else until the program ends.',
    'Several --vary: each value of one with each of the others, the first changes slowest; up to 100,000 runs.',
  ],
  words: [{ name: 'MAIN.py', path: 'reads' }],
  options,
  exits: { 0: 'all runs are made, passed or not', 2: 'something is wrong with the command or a file' },
  examples: [
    'sweep main.py --scene slalom --vary main.py:5=500..900/50',
    'sweep main.py --scene slalom --vary main.py:7.2=20..80#13 --report sweep.html',
    'sweep main.py --scene slalom --vary seed=1..50/1 --reality 1 --resume r --shard 2/7',
    'sweep --merge r --csv sweep.csv',
  ],
  read: readSweep,
});

type SweepGiven = Given<typeof options>;

/** Reads the words after `parcours sweep`. */
function readSweep(words: readonly string[], given: SweepGiven, { variables }: Around): SweepOptions | Problem {
  const language = languageOf(given.last('lang'));
  if ('problem' in language) return language;
  const work = given.has('merge') ? nothingToRun(words, given) : workOf(words, given, variables);
  if (work !== null && 'problem' in work) return work;
  return {
    work,
    folder: given.last('merge') ?? given.last('resume'),
    csv: given.last('csv'),
    report: given.last('report'),
    json: given.has('json'),
    quiet: given.has('quiet'),
    ...language,
  };
}

function workOf(
  words: readonly string[],
  given: SweepGiven,
  variables: Around['variables'],
): NonNullable<SweepOptions['work']> | Problem {
  const run = readSetup(words, given, 'sweep main.py --scene slalom --vary main.py:5=500..900/50');
  if ('problem' in run) return run;
  const vary = given.all('vary');
  if (vary.length === 0) return { problem: 'What varies? For example: --vary main.py:5=500..900/50' };
  const jobs = jobsOf(given.last('jobs'));
  if ('problem' in jobs) return jobs;
  const shard = shardOf(given.last('shard'), variables);
  return 'problem' in shard ? shard : { run, vary, ...jobs, shard };
}

function nothingToRun([first]: readonly string[], given: SweepGiven): null | Problem {
  if (first !== undefined)
    return { problem: `--merge runs nothing: what is "${first}"? Its folder has what varies, too.` };
  const other = ofRuns.find((name) => given.has(name));
  return other === undefined ? null : { problem: `--${other} and --merge: choose one of them.` };
}
