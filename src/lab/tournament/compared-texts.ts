import type { Language } from '#core/languages';
import { isRecord } from '#core/record';
import { filledIn } from '#core/words';
import { secondsText } from '#check/report/texts';
import words from '../words';
import { differences, type Compared, type Comparison } from './file';

const say = words.tournament;

/** A tournament that was played again as one line of JSON, without wall times. */
export const comparedJson = (compared: Comparison): string =>
  JSON.stringify({
    same: differences(compared) === 0,
    matches: compared.matches.map(({ stage, isSame, now, told }) => ({
      ...{ stage: stage + 1, same: isSame },
      ...{ now: now ?? null, told: told ?? null },
    })),
    tables: compared.areTablesSame,
  });

/** A match that was played again in a line: who met, what came out, and whether the file says the same. */
export function comparedText({ now, told, isSame }: Compared, language: Language): string {
  const [here, there] = [resultOf(now, language), resultOf(told, language)];
  const why = isSame
    ? say.same
    : now === undefined
      ? say.onlyTold
      : told === undefined
        ? say.notTold
        : here === there
          ? say.otherWay
          : say.unlike;
  // After another result other pairs may meet.
  const isOther = now !== undefined && told !== undefined && pairOf(now) !== pairOf(told);
  const saidThere = isOther ? `${pairOf(told)} ${there}` : there;
  return `${pairOf(now ?? told)}  ${now === undefined ? there : here}  ${filledIn(why[language], { told: saidThere })}`;
}

/** The comparison in a sentence. */
export function comparedSum(compared: Comparison, language: Language): string {
  const { matches, areTablesSame } = compared;
  const [of, count] = [matches.length, matches.filter(({ isSame }) => !isSame).length];
  if (count > 0) return filledIn(say[count === 1 ? 'someUnlikeOne' : 'someUnlike'][language], { count, of });
  return areTablesSame
    ? filledIn(say[of === 1 ? 'allSameOne' : 'allSame'][language], { of })
    : say.otherTable[language];
}

/** Text of a value of a file, which may be anything. */
const shown = (value: unknown): string => (typeof value === 'string' || typeof value === 'number' ? String(value) : '');

function pairOf(match: unknown): string {
  if (!isRecord(match)) return '?';
  const { a, b, seed } = match;
  const names = b === null ? shown(a) : `${shown(a)} – ${shown(b)}`;
  return `${names} (${shown(seed)})`;
}

function resultOf(match: unknown, language: Language): string {
  if (!isRecord(match)) return '?';
  const { a, b, winner, atMs, reason } = match;
  const won = winner === 'a' ? a : b;
  const who =
    b === null
      ? words[winner === 'a' ? 'passed' : 'missed'][language]
      : winner === 'a' || winner === 'b'
        ? filledIn(say.wins[language], { name: shown(won) })
        : say.draw[language];
  const reasons: Readonly<Record<string, Readonly<Record<Language, string>>>> = words.reasons;
  const why = typeof reason === 'string' && Object.hasOwn(reasons, reason) ? reasons[reason]?.[language] : undefined;
  return [who, ...(typeof atMs === 'number' ? [secondsText(atMs)] : []), ...(why === undefined ? [] : [why])].join(
    ', ',
  );
}
