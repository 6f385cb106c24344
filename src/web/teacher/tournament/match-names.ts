import { reasonText } from '#lab/say';

import { shownLanguage, t } from '../../kit/i18n';
import type { ShownMatch } from './model/shown-matches';
import words from './words';

const LAST = ['final', 'semi', 'quarter'] as const;

/** The name of a round of brackets. @param number its own, from the first one */
export function roundName(beforeFinal: number, number: number): string {
  const name = LAST[beforeFinal];
  return name === undefined ? t(words.rounds.before, { number }) : t(words.rounds[name]);
}

/** The name of a match: its number in a league, its round and pair in brackets. */
export function matchName({ stage, number, tie }: ShownMatch): string {
  if (tie === null) return t(stage.isAlone ? words.run : words.match, { number });
  const round = roundName(tie.beforeFinal, Math.ceil(Math.log2(stage.names.length)) - tie.beforeFinal);
  // A round that has a number itself is not followed by another one.
  const pair = t(LAST[tie.beforeFinal] === undefined ? words.pairOf : words.ofRound, { round, number: tie.pair + 1 });
  const named = tie.of === 1 ? round : pair;
  return t(words.inRound, { round: named, number: tie.match + 1 });
}

/** The names of the programs of a match; the second is `null` where one drives alone. */
export const namesIn = ({ stage, match }: ShownMatch): readonly [string, string | null] => [
  stage.names[match.a] ?? '',
  match.b === null ? null : (stage.names[match.b] ?? ''),
];

/** The winner of a match, in words. */
export function winnerText(shown: ShownMatch): string {
  const { winner } = shown.match;
  const [a, b] = namesIn(shown);
  if (b === null) return t(winner === 'a' ? words.passes : words.misses, { name: a });
  return winner === 'draw' ? t(words.drawnMatch) : t(words.wins, { name: winner === 'a' ? a : b });
}

/** The same, and what has become of the other one, or why nobody has won. */
export function resultText(shown: ShownMatch): string {
  const { winner, reason } = shown.match;
  const [a, b] = namesIn(shown);
  if (reason === null) return winnerText(shown);
  const loser = b === null || winner === 'draw' ? '' : winner === 'a' ? b : a;
  const why = reasonText(reason, shownLanguage());
  return `${winnerText(shown)} · ${loser === '' ? why : t(words.why, { name: loser, reason: why })}`;
}
