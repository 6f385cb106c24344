import { findJsonError } from './json-position';
import type { SceneProblem } from './problem';

/**
 * The value of a JSON file, or why there is none.
 *
 * @param what name of the file in messages: `course`, `project`
 * @param maxCharacters longer files are not read
 */
export function readJsonFile(
  text: string,
  what: string,
  maxCharacters: number,
): { readonly value: unknown } | { readonly problem: SceneProblem & { readonly code: 'too-long' | 'not-json' } } {
  if (text.length > maxCharacters) {
    const params = { length: text.length, max: maxCharacters };
    const message = `The ${what} file has ${String(text.length)} characters; the limit is ${String(maxCharacters)}. Is it the right file?`;
    return { problem: { code: 'too-long', path: '', value: '', params, message } };
  }
  const json = text.startsWith('\ufeff') ? text.slice(1) : text;
  try {
    return { value: JSON.parse(json) as unknown };
  } catch {
    const { line, column } = findJsonError(json) ?? { line: 1, column: 1 };
    const near = json.split('\n', line)[line - 1]?.slice(column - 1, column + 19) ?? '';
    const place = near === '' ? ', where it ends' : `, at ${JSON.stringify(near)}`;
    const message = `The ${what} file is not JSON: line ${String(line)}, column ${String(column)}${place}.`;
    return { problem: { code: 'not-json', path: '', value: '', params: { line, column, near }, message } };
  }
}

/** The message about a file with several mistakes: the first one's, and the number of others. */
export function summaryOf(problems: readonly Pick<SceneProblem, 'message'>[]): string {
  const first = problems[0]?.message ?? '';
  return problems.length > 1 ? `${first} (and ${String(problems.length - 1)} more)` : first;
}
