import { commandsMeantBy } from '#advice/other-names';
import { missingName, placesOf } from '#advice/missing-name';
import type { Source } from '#advice/syntax-advice';
import { complete, type Offer } from '#reference/complete';

import { contextOf, type Written } from '../../../session/work/hardware/written-for';
import type { Failure } from './error-advice';
import { nearName } from './near-name';

/**
 * The name that a program most likely meant by an unknown one: a name that could stand at that place, and is near, or
 * is called so in another language. `null` if there is none, or the exception is about something else.
 *
 * @param written the file that the exception names
 */
export function meantName(failure: Failure, source: Source, written: Written): string | null {
  const unknown = missingName(failure);
  if (unknown === null) return null;
  const context = contextOf(written);
  for (const offset of endsOf(unknown, source)) {
    const offers = complete(source.text, offset, context)?.items ?? [];
    const words = offers.map(({ item }) => item.label).filter((label) => /^\w+$/.test(label));
    const meant = commandMeant(unknown, offers, source.text.charAt(offset)) ?? nearName(unknown, words);
    if (meant !== null) return meant;
  }
  return null;
}

/** The offered command that a word of another language means: a function where a bracket follows, else a value. */
function commandMeant(word: string, offers: readonly Offer[], next: string): string | null {
  const fitting = offers.filter(({ item }) => (item.kind === 'function') === (next === '('));
  const names = new Set(fitting.map(({ item }) => item.label));
  return commandsMeantBy(word).find((name) => names.has(name)) ?? null;
}

/** The ends of the word in the line that the exception names. */
function endsOf(word: string, { text, line }: Source): number[] {
  const lines = text.split('\n');
  const start = lines.slice(0, line - 1).reduce((sum, { length }) => sum + length + 1, 0);
  return placesOf(word, lines[line - 1] ?? '').map((column) => start + column + word.length);
}
