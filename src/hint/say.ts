import type { Reason } from '#check/result';
import { reasonText } from '#check/report/say';
import { worldName } from '#check/task/task';
import type { Language, Texts } from '#core/languages';
import { filledIn } from '#core/words';
import { linesOf, linesToSee, type Change } from './changes/change';
import type { Happened } from './happened/happened';
import type { Hint } from './hint';
import type { HintLevel } from './level';
import words from './words';

/** The sentences of a hint in one text. */
export const hintText = (hint: Hint, level: HintLevel, language: Language): string =>
  hintTexts(hint, level, language).join(' ');

/** The sentences of a hint: what happened, and as much of the change as the level allows. */
export function hintTexts(hint: Hint, level: HintLevel, language: Language): readonly string[] {
  const { change, happened } = hint;
  const said = [whereText(hint, language) + happenedText(happened, level, language)];
  if (level > 1) said.push(...(change === null ? [nothingText(hint, language)] : changeTexts(hint.program, change, level, language))); // prettier-ignore
  return said;
}

/** Says in which world it happened, where it is not the course as it is. */
const whereText = ({ world }: Hint, language: Language): string =>
  world === null ? '' : `${filledIn(words.inWorld[language], { id: worldName({ id: world }) })} `;

/** The sentence to a program that passes. */
export const passedText = (language: Language): string => words.passed[language];

function nothingText({ tried, happened }: Hint, language: Language): string {
  const said = filledIn((tried === 0 ? words.untried : words.nothing)[language], { tried });
  const line = happened.fact === 'error' ? happened.line : 0;
  return line === 0 ? said : `${filledIn(words.look.one[language], { line })} ${said}`;
}

/** Says what happened, in one sentence. The first level names no line. */
function happenedText(happened: Happened, level: HintLevel, language: Language): string {
  const { happened: texts } = words;
  const say = (text: Texts, values: Readonly<Record<string, string | number>> = {}): string =>
    filledIn(text[language], values);
  switch (happened.fact) {
    case 'error':
      return happened.atS === null || happened.atS === 0
        ? say(texts.errorAtOnce, { type: happened.type })
        : say(texts.error, { at: happened.atS, type: happened.type });
    case 'bright':
      return say(happened.answers ? texts.brightAnswers : texts.bright, { at: happened.atS });
    case 'past': {
      const { atS: at, turns, checkpoint, side } = happened;
      const place = checkpoint === null ? say(words.place.target) : say(words.place.checkpoint, { number: checkpoint });
      return say(turns > 0 ? texts.pastAfterTurn : texts.past, { at, turns, place, side: say(words.side[side]) });
    }
    case 'ended':
      return happened.nearCm === null
        ? say(texts.ended, { at: happened.atS })
        : say(texts.endedNear, { at: happened.atS, near: happened.nearCm });
    case 'waits':
      return say(texts.waits, { name: happened.name });
    case 'slow':
    case 'early':
      return say(texts[happened.fact], { seconds: happened.seconds });
    case 'reached':
      return say(texts.reached, { done: happened.done, of: happened.of });
    case 'reason':
      return reasonSaid(happened.reason, level, language);
    default:
      return say(texts[happened.fact], 'atS' in happened ? { at: happened.atS } : {});
  }
}

const reasonSaid = (reason: Reason, level: HintLevel, language: Language): string =>
  reason.code === 'delay' && level === 1
    ? filledIn(words.happened.delay[language], reason.params)
    : reasonText(reason, language);

/** The sentences about a change of a program in one text: the lines, or the kind, or also the change itself. */
export const changeText = (program: string, change: Change, level: HintLevel, language: Language): string =>
  changeTexts(program, change, level, language).join(' ');

function changeTexts(program: string, change: Change, level: HintLevel, language: Language): readonly string[] {
  const lines = linesToSee(change, program);
  const [first, last] = [lines[0] ?? 1, lines.at(-1) ?? 1];
  const values = { line: change.line, first, last };
  const say = (text: Texts, besides = {}): string => filledIn(text[language], { ...values, ...besides });
  if (level === 2) return [first === last ? say(words.look.one, { line: first }) : say(words.look.several)];
  const isAtEnd = change.line > linesOf(program.trimEnd()).length;
  const { kinds, change: texts } = words;
  const kind =
    change.kind === 'number'
      ? kinds[change.direction ?? 'more']
      : kinds[change.kind === 'missing' && isAtEnd ? 'missingAtEnd' : change.kind];
  if (level === 3) return [say(kind)];
  const [before, after] = [change.before, change.after].map((rows) => rows.map((row) => `\n${row}`).join(''));
  if (change.before.length === 0) return [say(kind), say(isAtEnd ? texts.insertAtEnd : texts.insert, { after })]; // prettier-ignore
  return [say(kind), say(change.after.length === 0 ? texts.remove : texts.replace, { before, after })];
}
