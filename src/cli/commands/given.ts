import { parseArgs } from 'node:util';
import type { Given, Options, Problem } from './about';
import { nearest } from './nearest';

/** Options that were given, by name. */
export interface Read {
  /** Words that are no options, in order. */
  readonly words: readonly string[];
  readonly given: Given<Options>;
}

/** The words that are no options, whatever the options: those of any command may stand before it. */
export function wordsOf(line: readonly string[], options: Options): readonly string[] {
  return tokensOf(line, options).flatMap((token) => (token.kind === 'positional' ? [token.value] : []));
}

/**
 * Reads a line with these options.
 *
 * @param strange the problem with an option that is none of them
 */
export function readLine(
  line: readonly string[],
  options: Options,
  strange: (name: string, typed: string) => string,
): Read | Problem {
  const values = new Map<string, string[]>();
  const words: string[] = [];
  for (const token of tokensOf(line, options)) {
    if (token.kind === 'positional') words.push(token.value);
    if (token.kind !== 'option') continue;
    const { name, rawName, value } = token;
    const typed = line[token.index] ?? rawName;
    const isShort = !typed.startsWith('--');
    const about = isShort && typed !== '-h' ? undefined : options[name];
    if (about === undefined || !Object.hasOwn(options, name))
      return { problem: isShort ? shortProblem(typed) : strange(name, typed) };
    const isText = about.value !== undefined;
    if (!isText && value !== undefined) return { problem: `--${name} takes no value.` };
    if (isText && (value === undefined || value === '' || (value.startsWith('--') && !token.inlineValue)))
      return { problem: `--${name} needs a value.` };
    values.set(name, [...(values.get(name) ?? []), value ?? '']);
  }
  return { words, given: givenOf(values) };
}

function tokensOf(line: readonly string[], options: Options) {
  const types = Object.entries(options).map(([name, { value }]) => {
    const type = value === undefined ? ('boolean' as const) : ('string' as const);
    return [name, name === 'help' ? { type, short: 'h' } : { type }] as const;
  });
  return parseArgs({
    args: [...line],
    options: Object.fromEntries(types),
    strict: false,
    allowPositionals: true,
    tokens: true,
  }).tokens;
}

const givenOf = (values: ReadonlyMap<string, readonly string[]>): Given<Options> => ({
  has: (name) => values.has(name),
  last: (name) => values.get(name)?.at(-1) ?? null,
  all: (name) => values.get(name) ?? [],
});

/** Files may be called like `-2+3.py`, and `*` gives their names to a command. */
const shortProblem = (typed: string): string =>
  `${typed} begins like an option. If it is the name of a file, put -- before the names: … -- ${typed}`;

/** The problem with an option that a command does not have: the nearest one that it has, else all of them. */
export function unknownProblem(typed: string, name: string, known: readonly string[]): string {
  if (/[./\\]/.test(name)) return shortProblem(typed);
  const meant = nearest(name, known);
  const all = known.map((one) => `--${one}`).join(', ');
  return `Unknown option --${name}. ${meant === null ? `Known: ${all}.` : `Did you mean --${meant}?`}`;
}
