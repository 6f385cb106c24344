import type { Language } from '#core/languages';
import { unseenShown } from '#core/unseen';
import { filledIn } from '#core/words';
import type { EqualWorlds } from '../equal-worlds';
import { unreadCodes, type Unread } from '../hand-in/unread';
import type { Reason, Remark } from '../result';
import { otherTasks, type ClassResult } from './class-result';
import words from './words';

/** Why a check does not hold, as text: one sentence, then details of the run and advice, if there are any. */
export function reasonText({ code, params: given, advice }: Reason, language: Language): string {
  const params = shownIn(given);
  const { reasons, more } = words;
  const isSaid = (name: string): boolean => params[name] !== undefined && params[name] !== '';
  const besides = (['allowed', 'left', 'near', 'limit', 'column'] as const).filter(isSaid);
  const said = [reasons[code], ...besides.map((name) => more[name])].map((text) => filledIn(text[language], params));
  // What the board says of an error ends with no full stop.
  return advice === undefined ? said.join(' ') : `${said.join(' ')} – ${unseenShown(advice[language])}`;
}

/** Why something cannot be read. */
export const unreadText = ({ code, params }: Unread, language: Language): string =>
  filledIn(words.unread[code][language], shownIn(params));

/** A sentence of a remark to the teacher. */
export function remarkText(remark: Remark, language: Language): string {
  const { code, params } = remark;
  const why = whyUnread(remark);
  return filledIn(
    words.remarks[code][language],
    why === undefined ? shownIn(params) : { problem: unreadText({ code: why, params }, language) },
  );
}

/** The same beside a result in words, which says itself that a hand-in cannot be read: here is only why. */
export function remarkBeside(remark: Remark, language: Language): string {
  const why = whyUnread(remark);
  if (why === undefined) return remarkText(remark, language);
  const text = words.unread[why][language]; // in some languages it goes on after a colon
  return filledIn(text.charAt(0).toUpperCase() + text.slice(1), shownIn(remark.params));
}

/** Why a hand-in cannot be read, if a remark says so. */
const whyUnread = ({ params }: Remark): Unread['code'] | undefined => unreadCodes.find((one) => one === params['why']);

/** A sentence for each other task that hand-ins belong to: perhaps the wrong one is open. */
export const otherTaskTexts = (found: ClassResult, language: Language): readonly string[] =>
  otherTasks(found).map(({ task, count }) =>
    filledIn(words.report.others[language], shownIn({ task, count, of: found.handIns.length })),
  );

/** A sentence for each hidden world that tests nothing new. */
export const equalTexts = (worlds: readonly EqualWorlds[], language: Language): readonly string[] =>
  worlds.map(({ id, other }) => filledIn(words.report.equal[language], shownIn({ id, other })));

/** Makes invisible and reversing characters of pupils' texts visible, so that they cannot reverse a sentence. */
const shownIn = (params: Reason['params']): Reason['params'] =>
  Object.fromEntries(
    Object.entries(params).map(([name, value]) => [name, typeof value === 'string' ? unseenShown(value) : value]),
  );
