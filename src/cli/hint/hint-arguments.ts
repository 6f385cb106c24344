import { budgetLimits, hintLevels, USUAL_BUDGET, type HintLevel } from '#hint/level';
import type { Language } from '#core/languages';
import { command, type Given, type Options, type Problem } from '../commands/about';
import { langOption, languageOf } from '../commands/shared-options';
import { numberOf } from '../number-of';

/** The request to `parcours hint`. */
export interface HintOptions {
  /** A task file, a project or a course, a link, the id of a ready course. */
  readonly task: string;
  /** A program, a project, a link. */
  readonly program: string;
  readonly level: HintLevel;
  /** The most programs that are tried. */
  readonly budget: number;
  readonly json: boolean;
  readonly lang: Language;
}

const EXAMPLE = 'For example: parcours hint closed-line main.py --level 2';

const options = {
  level: {
    value: '1|2|3|4',
    help: 'how much it tells: 1 what happened (default), 2 also the lines, 3 also the kind of change, 4 the change itself',
  },
  budget: { value: 'N', help: `tries at most so many programs (default: ${String(USUAL_BUDGET)})` },
  json: { help: 'one line for other programs, the same on every machine' },
  lang: langOption('the language of the sentences; default: en'),
} as const satisfies Options;

export const hintAbout = command({
  summary: 'says what went wrong, and where a small change helps',
  usage: ['TASK PROGRAM [options]'],
  text: [
    'TASK is what check takes: a task file, a project or a course, a link, the id of a ready course, or a task of a series. PROGRAM is one hand-in: a program, a project file, a link, a folder.',
    'Runs the program in the worlds that pupils see. If it does not pass, small changes are tried until one passes in all of them: other numbers, names, comparisons, a line more, less, moved or indented in another way. The model solution is never read.',
  ],
  words: [
    { name: 'TASK', choices: 'courses', path: 'reads' },
    { name: 'PROGRAM', path: 'reads' },
  ],
  options,
  exits: { 0: 'the program passes', 2: 'something is wrong with the command', 3: 'it does not pass' },
  examples: ['hint closed-line main.py', 'hint task.json anna.json --level 3 --lang de', 'hint square main.py --level 4 --json'],
  read: readHint,
}); // prettier-ignore

/** Reads the words after `parcours hint`. */
function readHint(words: readonly string[], given: Given<typeof options>): HintOptions | Problem {
  const [task, program, another] = words;
  if (task === undefined) return { problem: `Which task? ${EXAMPLE}` };
  if (program === undefined) return { problem: `Which program? ${EXAMPLE}` };
  if (another !== undefined) return { problem: `One program at a time: what is "${another}"?` };
  const language = languageOf(given.last('lang'));
  if ('problem' in language) return language;
  const level = hintLevels.find((one) => String(one) === (given.last('level') ?? '1'));
  if (level === undefined) return { problem: `--level: "${given.last('level') ?? ''}" is not one of 1, 2, 3, 4.` };
  const budget = numberOf(given.last('budget') ?? String(USUAL_BUDGET));
  const { min, max } = budgetLimits;
  if (!Number.isInteger(budget) || budget < min || budget > max)
    return { problem: `--budget: "${given.last('budget') ?? ''}" is not a whole number from ${min} to ${max}.` };
  return { task, program, level, budget, json: given.has('json'), ...language };
}
