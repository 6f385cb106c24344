import { complete } from '#reference/complete';

import { contextOf, type Written } from '../../../session/work/hardware/written-for';
import type { Failure } from './error-advice';
import { nearName } from './near-name';
import type { Source } from '#advice/syntax-advice';

/** Exceptions about a name, which their message has in quotation marks as the last one. */
const ABOUT_NAMES = ['NameError', 'AttributeError', 'ImportError', 'ModuleNotFoundError'];

/**
 * The name that a program most likely meant by an unknown one: a name that could stand at that place. `null` if there
 * is none, or the exception is about something else.
 *
 * @param written the file that the exception names
 */
export function meantName({ type, message }: Failure, source: Source, written: Written): string | null {
  if (!ABOUT_NAMES.includes(type)) return null;
  const unknown = Array.from(message.matchAll(/'(\w+)'/g), ([, name]) => name).at(-1) ?? wordAfter(message);
  if (unknown === undefined) return null;
  const context = contextOf(written);
  for (const offset of endsOf(unknown, source)) {
    const offers = complete(source.text, offset, context)?.items ?? [];
    const words = offers.map(({ item }) => item.label).filter((label) => /^\w+$/.test(label));
    const meant = nearName(unknown, words);
    if (meant !== null) return meant;
  }
  return null;
}

/** `can't import name x` has its name without marks. */
const wordAfter = (message: string): string | undefined => /\bname (\w+)$/.exec(message)?.[1];

/** The ends of the word in the line that the exception names. */
function endsOf(word: string, { text, line }: Source): number[] {
  const lines = text.split('\n');
  const start = lines.slice(0, line - 1).reduce((sum, { length }) => sum + length + 1, 0);
  const found = (lines[line - 1] ?? '').matchAll(new RegExp(`\\b${word}\\b`, 'g'));
  return Array.from(found, ({ index }) => start + index + word.length);
}
