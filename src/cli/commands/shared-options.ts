import { availableParallelism } from 'node:os';
import { formWith, usualForm, type SpreadsheetForm } from '#core/csv';
import { LANGUAGES, type Language } from '#core/languages';
import type { OptionAbout, Problem } from './about';

/** The language of what a command says; the help of each command says of what. */
export const langOption = (help: string) =>
  ({ value: 'NAME', choices: LANGUAGES, help }) as const satisfies OptionAbout;

/** The language with this name; `null`: English. */
export function languageOf(text: string | null): { readonly lang: Language } | Problem {
  const lang = LANGUAGES.find((one) => one === (text ?? 'en'));
  return lang === undefined
    ? { problem: `--lang: "${text ?? ''}" is not available. Known: ${LANGUAGES.join(', ')}.` }
    : { lang };
}

const DECIMALS = { point: '.', comma: ',' } as const;

export const decimalsOption = {
  value: 'SIGN',
  choices: ['point', 'comma'],
  help: "the decimal sign of a spreadsheet's table; default: a comma in de, fr, it. In Switzerland: point",
} as const satisfies OptionAbout;

/** The signs of a spreadsheet's table by the word for its decimal sign; `null`: those of the language. */
export function formOf(text: string | null, lang: Language): { readonly form: SpreadsheetForm } | Problem {
  if (text === null) return { form: usualForm(lang) };
  return text === 'point' || text === 'comma'
    ? { form: formWith(lang, DECIMALS[text]) }
    : { problem: `--decimals: "${text}" is neither "point" nor "comma".` };
}

/** Chosen: more threads than that no machine of a school has. */
const MOST_JOBS = 256;

export const jobsOption = {
  value: 'N',
  help: 'so many threads (default: as many as this computer has)',
} as const satisfies OptionAbout;

/** The number of threads that a text says; `null`: as many as the computer has. */
export function jobsOf(text: string | null): { readonly jobs: number } | Problem {
  const jobs = text === null ? availableParallelism() : Number(text);
  return Number.isInteger(jobs) && jobs >= 1 && jobs <= MOST_JOBS
    ? { jobs }
    : { problem: `--jobs: "${text ?? ''}" is not a whole number from 1 to ${MOST_JOBS}.` };
}

export const shardOption = {
  value: 'I/N',
  help: '2/7: the second of seven parts; auto: the part of this job of Slurm, Kubernetes (auto/7), GitLab, CircleCI or Buildkite',
} as const satisfies OptionAbout;

export const resumeOption = {
  value: 'DIR',
  path: 'folder',
  help: 'keeps each result in DIR, and runs only what is missing there',
} as const satisfies OptionAbout;

export const mergeOption = {
  value: 'DIR',
  path: 'folder',
  help: 'runs nothing: joins what is in DIR',
} as const satisfies OptionAbout;
