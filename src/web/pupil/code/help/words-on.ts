import type { Item } from '#reference/item';
import { loadTextsWith, type ReferenceTexts } from '#reference/texts';
import type { RobotReference } from '#reference/types';
import type { Language } from '../../../kit/i18n';
import { loadTexts, t } from '../../../kit/i18n';
import helpWords from './words';

/** The short words on names of the API, in one language. */
export type Words = ReferenceTexts;

/** The words of the boards' modules and of these libraries. */
export async function loadWords(
  language: Language,
  libraries: readonly Pick<RobotReference, 'texts'>[],
): Promise<Words> {
  const [words] = await Promise.all([loadTextsWith(language, libraries), loadTexts(language)]);
  return words;
}

/** The text on an item; empty if nothing is known about it. */
export function wordsOn(item: Item, words: Words): string {
  return item.own ?? words[item.text ?? ''] ?? '';
}

/** An item's home and kind: “microbit.display · function”. */
export function captionOf(item: Item): string {
  const kind = t(helpWords[item.kind]);
  return item.home === null ? kind : `${item.home} · ${kind}`;
}

/** The note that the firmware lacks an item; empty if it has it. */
export function missingText(item: Item): string {
  if (item.missing === null) return '';
  return t(item.missing === 'absent' ? helpWords.absent : helpWords.newer);
}
