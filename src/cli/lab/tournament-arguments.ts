import type { Language } from '#core/languages';
import { modes, type Mode } from '#lab/tournament/play';
import { readNumbers } from '#lab/values';
import { command, type Given, type Options, type Problem } from '../commands/about';
import { jobsOf, jobsOption, langOption, languageOf } from '../commands/shared-options';

/** The request to `parcours tournament`: a new one, or one of a file that is played again. */
export type TournamentOptions = PlayOptions | VerifyOptions;

/** The part of both that says how they are carried out. */
interface Common {
  readonly jobs: number;
  readonly json: boolean;
  readonly quiet: boolean;
  readonly lang: Language;
}

export interface VerifyOptions extends Common {
  /** The file of a tournament. */
  readonly verify: string;
}

export interface PlayOptions extends Common {
  /** A course's file, a project, a link, the id of a ready course. */
  readonly course: string;
  /** Files of programs. */
  readonly programs: readonly string[];
  readonly mode: Mode;
  readonly seeds: readonly number[];
  /** Files for people and for other programs; `null`: not wanted. */
  readonly report: string | null;
  readonly csv: string | null;
}

const options = {
  mode: {
    value: 'league|knockout',
    choices: modes,
    help: 'everyone against everyone (default), or a bracket in the order of the programs, in which the first ones have byes',
  },
  seeds: { value: 'N,N', help: 'plays each match once per seed (default 1)' },
  jobs: jobsOption,
  report: { value: 'REPORT.html', path: 'writes', help: 'a page with the table and all matches' },
  csv: { value: 'R.csv', path: 'writes', help: 'the table for programs' },
  verify: {
    value: 'FILE.json',
    path: 'reads',
    help: 'plays the tournament of a file again, and says match by match whether it comes out the same',
  },
  json: { help: 'one line at the end for other programs, the same for the same work' },
  quiet: { help: 'neither results nor progress' },
  lang: langOption('the language of results and report; default: en'),
} as const satisfies Options;

export const tournamentAbout = command({
  summary: 'lets programs meet on a course, and makes the table',
  usage: ['COURSE PROGRAMS… [options]', '--verify FILE.json [options]'],
  text: [
    'COURSE is a course for two robots, such as sumo or a race: a pair plays twice per seed, once on each side. In a course for one robot each program runs alone.',
    'Each program gets the robot of its start, whatever it imports. 3 points for a win, 1 for a draw.',
    'In a knockout equal wins are decided by the time of all wins together, then by the order of the programs.',
  ],
  words: [
    { name: 'COURSE', choices: 'courses', path: 'reads' },
    { name: 'PROGRAMS', path: 'reads', isRepeated: true },
  ],
  options,
  exits: {
    0: 'all matches are played, with --verify: as the file says',
    1: 'with --verify: a match or a table is not as the file says',
    2: 'something is wrong with the command or a file',
  },
  examples: [
    'tournament sumo anna.py ben.py cora.py --report table.html',
    'tournament sumo anna.py ben.py cora.py --mode knockout --seeds 1,2,3',
    'tournament --verify tournament.json',
  ],
  read: readTournament,
});

/** Reads the words after `parcours tournament`. */
function readTournament(words: readonly string[], given: Given<typeof options>): TournamentOptions | Problem {
  const jobs = jobsOf(given.last('jobs'));
  if ('problem' in jobs) return jobs;
  const language = languageOf(given.last('lang'));
  if ('problem' in language) return language;
  const common: Common = { ...jobs, json: given.has('json'), quiet: given.has('quiet'), ...language };
  const verify = given.last('verify');
  const work = verify === null ? workOf(words, given) : verifyOf(verify, words, given);
  return 'problem' in work ? work : { ...work, ...common };
}

/** A file that is played again holds everything: nothing else says what is played. */
function verifyOf(
  verify: string,
  [first]: readonly string[],
  given: Given<typeof options>,
): Pick<VerifyOptions, 'verify'> | Problem {
  if (first !== undefined) return { problem: `--verify plays what is in its file: what is "${first}"?` };
  const other = (['mode', 'seeds', 'report', 'csv'] as const).find((name) => given.has(name));
  return other === undefined ? { verify } : { problem: `--${other} and --verify: choose one of them.` };
}

function workOf(
  [course, ...programs]: readonly string[],
  given: Given<typeof options>,
): Omit<PlayOptions, keyof Common> | Problem {
  const example = 'For example: parcours tournament sumo anna.py ben.py';
  if (course === undefined) return { problem: `Which course? ${example}` };
  if (programs.length === 0) return { problem: `Which programs? ${example}` };
  const mode = modes.find((one) => one === (given.last('mode') ?? 'league'));
  if (mode === undefined) return { problem: `--mode: "${given.last('mode') ?? ''}" is neither league nor knockout.` };
  const seeds = seedsOf(given.last('seeds'));
  if ('problem' in seeds) return seeds;
  return { ...{ course, programs, mode }, ...seeds, report: given.last('report'), csv: given.last('csv') };
}

function seedsOf(text: string | null): { readonly seeds: readonly number[] } | Problem {
  const read = readNumbers(text ?? '1');
  const seeds = 'numbers' in read ? read.numbers : [NaN];
  const areSeeds = seeds.every((one) => Number.isInteger(one) && one >= 0 && one <= 0xffffffff);
  return areSeeds && new Set(seeds).size === seeds.length
    ? { seeds }
    : { problem: `--seeds: "${text ?? ''}" is not like 1,2,3: different whole numbers from 0 to 4294967295.` };
}
