import { availableParallelism } from 'node:os';
import { dayNumber, type Day } from '#core/day';
import { LANGUAGES, type Language } from '#core/languages';
import { passPercents, systemIds, type SystemId } from '#school-class/grades';

/** The acts of `parcours class` on the file of a class. */
export const classActs = ['add', 'set', 'merge', 'report'] as const;
type Act = (typeof classActs)[number];

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
  readonly json: boolean;
  readonly quiet: boolean;
  readonly lang: Language;
}

/** The options of each act that take a value, without `--`. */
export const classTexts = {
  add: ['jobs', 'date', 'lang'],
  set: ['name', 'names', 'scale', 'pass', 'due', 'lang'],
  merge: ['lang'],
  report: ['report', 'csv', 'date', 'lang'],
} as const satisfies Readonly<Record<Act, readonly string[]>>;
const flags: readonly string[] = ['json', 'quiet'];

const EXAMPLES: Readonly<Record<Act, string>> = {
  add: 'parcours class add 8b.json closed-line class/',
  set: 'parcours class set 8b.json --names list.csv --scale ch6',
  merge: 'parcours class merge 8b.json other/8b.json',
  report: 'parcours class report 8b.json --report 8b.html --csv 8b.csv',
};

type Problem = { readonly problem: string };

/** Reads the words after `parcours class`, or says what is wrong with them. @param today the day if no `--date` is given */
export function parseClassCommand(
  [word, file, ...others]: readonly string[],
  given: ReadonlyMap<string, readonly string[]>,
  set: ReadonlySet<string>,
  today: Day,
): ClassOptions | Problem {
  const act = classActs.find((one) => one === word);
  if (act === undefined)
    return { problem: `What shall be done with the class? ${classActs.join(', ')}. For example: ${EXAMPLES.add}` };
  const problem = wordsProblem(act, file, others, [...given.keys(), ...set]);
  if (problem !== null) return { problem };
  const last = (name: string): string | null => given.get(name)?.at(-1) ?? null;
  const figures = figuresIn(last, given.get('due') ?? [], today);
  if ('problem' in figures) return figures;
  return {
    ...{ act, file: file ?? '', others, ...figures },
    ...{ name: last('name'), names: last('names'), report: last('report'), csv: last('csv') },
    ...{ json: set.has('json'), quiet: set.has('quiet') },
  };
}

function wordsProblem(
  act: Act,
  file: string | undefined,
  others: readonly string[],
  named: readonly string[],
): string | null {
  const example = `For example: ${EXAMPLES[act]}`;
  if (file === undefined) return `Which class? ${example}`;
  const known: readonly string[] = [...classTexts[act], ...flags];
  const strange = named.find((name) => !known.includes(name));
  if (strange !== undefined)
    return `--${strange} is not for class ${act}. Known: ${known.map((name) => `--${name}`).join(', ')}.`;
  if (act === 'add' && others.length === 0) return `Which task? ${example}`;
  if (act === 'add' && others.length === 1) return `Which hand-ins? ${example}`;
  if (act === 'merge' && others.length === 0) return `Which other copy? ${example}`;
  const takesMore = act === 'add' || act === 'merge';
  return takesMore || others.length === 0 ? null : `One class at a time: what is "${others[0] ?? ''}"?`;
}

/** Chosen: more threads than that no machine of a school has. */
const MOST_JOBS = 256;

function figuresIn(
  last: (name: string) => string | null,
  dues: readonly string[],
  today: Day,
): Pick<ClassOptions, 'jobs' | 'day' | 'scale' | 'pass' | 'due' | 'lang'> | Problem {
  const wanted = last('lang') ?? 'en';
  const lang = LANGUAGES.find((one) => one === wanted);
  if (lang === undefined) return { problem: `--lang: "${wanted}" is not available. Known: ${LANGUAGES.join(', ')}.` };
  const jobs = last('jobs') === null ? availableParallelism() : Number(last('jobs'));
  if (!(Number.isInteger(jobs) && jobs >= 1 && jobs <= MOST_JOBS))
    return { problem: `--jobs: "${last('jobs') ?? ''}" is not a whole number from 1 to ${String(MOST_JOBS)}.` };
  const day = last('date') ?? today;
  if (dayNumber(day) === null) return { problem: `--date: "${day}" is no day such as ${today}.` };
  const scale = systemIds.find((one) => one === last('scale')) ?? null;
  if (scale === null && last('scale') !== null)
    return { problem: `--scale: "${last('scale') ?? ''}" is not known. Known: ${systemIds.join(', ')}.` };
  const pass = passOf(last('pass'));
  if (typeof pass === 'object' && pass !== null) return pass;
  const due: (readonly [string, Day])[] = [];
  for (const text of dues) {
    const [, task = '', until = ''] = /^(.+)=([^=]*)$/.exec(text) ?? [];
    if (task === '' || dayNumber(until) === null)
      return { problem: `--due: "${text}" is no TASK=DAY such as bend=${today}.` };
    due.push([task, until]);
  }
  return { jobs, day, scale, pass, due, lang };
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
