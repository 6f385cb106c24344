import type { Language } from '#core/languages';
import { linesToSee, type Change } from './changes/change';
import type { Hint } from './hint';
import type { HintLevel } from './level';
import { hintText } from './say';

/** A hint in one line for other programs, without what its level may not tell; `null`: the program passes. */
export function hintJson(hint: Hint | null, level: HintLevel, language: Language): string {
  if (hint === null) return JSON.stringify({ passed: true });
  const { reason, atMs, change, tried } = hint;
  return JSON.stringify({
    ...{ passed: false, reason: reason.code, atMs, found: change !== null, tried },
    hint: { level, ...placeOf(hint, level), text: hintText(hint, level, language) },
    ...(level === 4 && change !== null && { change: changeOf(change) }),
  });
}

function placeOf(hint: Hint, level: HintLevel) {
  const { change, program } = hint;
  const { happened } = hint;
  if (change === null && level > 1 && happened.fact === 'error' && happened.line > 0)
    return { line: happened.line, lines: [happened.line], direction: null };
  if (change === null || level === 1) return { line: null, lines: [], direction: null };
  const place = { line: change.line, lines: linesToSee(change, program) };
  return level === 2 ? { ...place, direction: null } : { ...place, kind: change.kind, direction: change.direction };
}

/** Whole lines; of an insertion nothing stands before. */
const changeOf = ({ line, before, after }: Change) => ({ line, before: before.join('\n'), after: after.join('\n') });
