import type { Language } from '#core/languages';
import type { Scene } from '#scene/scene';

import type { Course } from '#catalogue/course';

/** The text on the card of a task, in one language. */
export interface ShownText {
  readonly title: string;
  readonly text: string;
  readonly hints: readonly string[];
  /** A `data:image/…` address, or empty. */
  readonly picture: string;
}

/**
 * The task in the reader's language. A missing translation is replaced by the text as the task was written; a ready
 * course has its words in all languages.
 *
 * @param ready the ready course that is open, as far as its words are known
 */
export function taskText(
  { name, description, task }: Pick<Scene, 'name' | 'description' | 'task'>,
  ready: Pick<Course, 'texts'> | null,
  language: Language,
): ShownText {
  const { card } = task;
  const title = ready?.texts[language].name ?? name;
  const text = ready?.texts[language].task ?? description;
  if (card === undefined) return { title, text, hints: ready?.texts[language].hints ?? [], picture: '' };
  const { picture } = card;
  const other = card.language === language ? undefined : card.translations.find((one) => one.language === language);
  if (other === undefined) return { title: card.title || title, text, hints: card.hints, picture };
  return {
    title: other.title || card.title || title,
    text: other.text || text,
    hints: other.hints.length > 0 ? other.hints : card.hints,
    picture,
  };
}

/** True if there is anything to read. */
export const hasWords = ({ text, hints, picture }: ShownText): boolean =>
  text.trim() !== '' || hints.length > 0 || picture !== '';
