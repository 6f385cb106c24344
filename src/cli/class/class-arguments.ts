import type { SpreadsheetForm } from '#core/csv';
import { dayNumber, type Day } from '#core/day';
import type { Language } from '#core/languages';
import { passPercents, systemIds, type SystemId } from '#school-class/grades';
import { command, type Around, type Options, type Problem } from '../commands/about';
import { notKnown } from '../commands/nearest';
import { decimalsOption, formOf, jobsOf, jobsOption, langOption, languageOf } from '../commands/shared-options';

/** The work with the file of a class. */
type Act = 'add' | 'set' | 'merge' | 'report';

/** The request to `parcours class`. */
export interface ClassOptions {
  readonly act: Act;
  /** The file of the class. */
  readonly file: string;
  /** Behind the file: the task and its hand-ins, or the other copies. */
  readonly others: readonly string[];
  readonly jobs: number;
  /** Today; for `due` and the week of a task. */
  readonly day: Day;
  /** New values for the class; `null`: stays as it is. */
  readonly name: string | null;
  /** File of the list of names. */
  readonly names: string | null;
  readonly scale: SystemId | null;
  /** Share for a pass in per cent, or `even`. */
  readonly pass: number | 'even' | null;
  /** Last days by the ids of tasks. */
  readonly due: readonly (readonly [task: string, day: Day])[];
  /** Files to write; `null`: not wanted. */
  readonly report: string | null;
  readonly csv: string | null;
  /** The signs of `csv`; left out: those of the language. */
  readonly form?: SpreadsheetForm;
  readonly json: boolean;
  readonly quiet: boolean;
  readonly lang: Language;
}

const everyAct = {
  json: { help: 'one line for other programs: the whole class' },
  quiet: { help: 'says nothing' },
  lang: langOption('the language of what is said and written; default: en'),
} as const satisfies Options;

const dateOption = { value: 'DAY', help: 'the day of the work, such as 2026-11-30; default: today' } as const;

const addOptions = { jobs: jobsOption, date: dateOption, ...everyAct } as const satisfies Options;

const setOptions = {
  name: { value: 'NAME', help: 'its name' },
  names: { value: 'FILE', path: 'reads', help: 'who is in it: a name a line, or a table' },
  scale: { value: 'NAME', choices: systemIds, help: 'its grades' },
  pass: { value: 'PERCENT|even', help: 'the share of the points for a pass; even: the grades rise evenly' },
  due: { value: 'TASK=DAY', isRepeated: true, help: 'the last day for a task, such as bend=2026-11-30' },
  ...everyAct,
} as const satisfies Options;

const reportOptions = {
  report: { value: 'F.html', path: 'writes', help: 'a page to print' },
  csv: { value: 'F.csv', path: 'writes', help: 'a table for a spreadsheet' },
  decimals: decimalsOption,
  date: dateOption,
  ...everyAct,
} as const satisfies Options;

const EXAMPLES: Readonly<Record<Act, string>> = {
  add: 'class add 8b.json closed-line class/',
  set: 'class set 8b.json --names list.csv --scale ch6',
  merge: 'class merge 8b.json other/8b.json',
  report: 'class report 8b.json --report 8b.html --csv 8b.csv',
};

const FILE = { name: 'CLASS.json', path: 'reads' } as const;
const exits = { 0: 'done', 2: 'something is wrong with the command or a file' } as const;

/** The parts of a request that an act does not have. */
const nothing = {
  ...{ others: [], jobs: 1, name: null, names: null, scale: null, pass: null, due: [], report: null, csv: null },
} as const;

export const classAddAbout = command({
  summary: 'checks hand-ins and adds the results to the file of a class',
  usage: ['CLASS.json TASK HAND-INS… [options]'],
  text: [
    'Runs the hand-ins as check does and keeps the results in CLASS.json, which the page opens, too; where there is none, it is made. TASK may be a whole series: then each hand-in goes to the task that it was made for.',
  ],
  words: [
    FILE,
    { name: 'TASK', choices: 'courses', path: 'reads' },
    { name: 'HAND-INS', path: 'reads', isRepeated: true },
  ],
  options: addOptions,
  exits,
  examples: [EXAMPLES.add],
  read([file, ...others], given, around) {
    const jobs = jobsOf(given.last('jobs'));
    if ('problem' in jobs) return jobs;
    const [task, handIns] = others;
    if (file !== undefined && task === undefined) return { problem: `Which task? ${exampleOf('add')}` };
    if (file !== undefined && handIns === undefined) return { problem: `Which hand-ins? ${exampleOf('add')}` };
    const day = dayOf(given.last('date'), around);
    return 'problem' in day ? day : requestOf('add', [file], given, { ...day, ...jobs, others });
  },
});

export const classSetAbout = command({
  summary: 'changes names, grades and last days in the file of a class',
  usage: ['CLASS.json [options]'],
  text: ['Where there is no CLASS.json, it is made.'],
  words: [FILE],
  options: setOptions,
  exits,
  examples: [EXAMPLES.set],
  read(words, given, { today }) {
    const wanted = given.last('scale');
    const scale = systemIds.find((one) => one === wanted) ?? null;
    if (scale === null && wanted !== null) return { problem: notKnown('scale', wanted, systemIds) };
    const pass = passOf(given.last('pass'));
    if (typeof pass === 'object' && pass !== null) return pass;
    const due = duesOf(given.all('due'), today);
    if ('problem' in due) return due;
    const own = { day: today, name: given.last('name'), names: given.last('names'), scale, pass, ...due };
    return requestOf('set', words, given, own);
  },
});

export const classMergeAbout = command({
  summary: 'joins copies of the file of a class; nothing is lost',
  usage: ['CLASS.json COPY.json… [options]'],
  text: ['CLASS.json has afterwards what it had and what the copies have besides.'],
  words: [FILE, { name: 'COPY.json', path: 'reads', isRepeated: true }],
  options: everyAct,
  exits,
  examples: [EXAMPLES.merge],
  read([file, ...others], given, { today }) {
    if (file !== undefined && others.length === 0) return { problem: `Which other copy? ${exampleOf('merge')}` };
    return requestOf('merge', [file], given, { day: today, others });
  },
});

export const classReportAbout = command({
  summary: 'shows who has done what in a class, with points and grades',
  usage: ['CLASS.json [options]'],
  text: ['Changes nothing in CLASS.json.'],
  words: [FILE],
  options: reportOptions,
  exits,
  examples: [EXAMPLES.report],
  read(words, given, around) {
    const day = dayOf(given.last('date'), around);
    if ('problem' in day) return day;
    const language = languageOf(given.last('lang'));
    if ('problem' in language) return language;
    const form = formOf(given.last('decimals'), language.lang);
    if ('problem' in form) return form;
    if (given.has('decimals') && !given.has('csv'))
      return { problem: '--decimals: there is no table for a spreadsheet. Add --csv FILE.csv.' };
    const own = { ...day, ...form, report: given.last('report'), csv: given.last('csv') };
    return requestOf('report', words, given, own);
  },
});

const exampleOf = (act: Act): string => `For example: parcours ${EXAMPLES[act]}`;

/** The options that every act has. */
interface GivenToAll {
  has(name: 'json' | 'quiet'): boolean;
  last(name: 'lang'): string | null;
}

/** A request of what every act has and of its own. */
function requestOf(
  act: Act,
  [file, more]: readonly (string | undefined)[],
  given: GivenToAll,
  own: Partial<ClassOptions> & Pick<ClassOptions, 'day'>,
): ClassOptions | Problem {
  if (file === undefined) return { problem: `Which class? ${exampleOf(act)}` };
  if (more !== undefined) return { problem: `One class at a time: what is "${more}"?` };
  const language = languageOf(given.last('lang'));
  if ('problem' in language) return language;
  return { act, file, ...nothing, ...own, ...language, json: given.has('json'), quiet: given.has('quiet') };
}

function dayOf(text: string | null, { today }: Around): { readonly day: Day } | Problem {
  const day = text ?? today;
  return dayNumber(day) === null ? { problem: `--date: "${day}" is no day such as ${today}.` } : { day };
}

function duesOf(texts: readonly string[], today: Day): Pick<ClassOptions, 'due'> | Problem {
  const due: (readonly [string, Day])[] = [];
  for (const text of texts) {
    const [, task = '', until = ''] = /^(.+)=([^=]*)$/.exec(text) ?? [];
    if (task === '' || dayNumber(until) === null)
      return { problem: `--due: "${text}" is no TASK=DAY such as bend=${today}.` };
    due.push([task, until]);
  }
  return { due };
}

function passOf(text: string | null): number | 'even' | null | Problem {
  if (text === null || text === 'even') return text;
  const percent = Number(text.replace(/%$/, ''));
  const { min, max } = passPercents;
  return Number.isInteger(percent) && percent >= min && percent <= max
    ? percent
    : {
        problem: `--pass: "${text}" is neither "even" nor a whole number of per cent from ${String(min)} to ${String(max)}.`,
      };
}
