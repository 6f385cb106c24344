import { isSame } from '#core/same';
import type { CourseChanges } from '#scene/edit';
import {
  helps,
  sceneDefaults,
  type Help,
  type Scene,
  type Task,
  type TaskCard,
  type TaskRule,
  type TaskText,
} from '#scene/scene';

/** The task of a course as it is being written. */
type Course = Pick<Scene, 'name' | 'description' | 'task'>;

/** New texts in one language; those left out stay as they are. */
export type WordsPart = Partial<Omit<TaskText, 'language'>>;

/** The card of a task, empty if it has none yet. */
export const cardOf = ({ task }: Pick<Scene, 'task'>): TaskCard => task.card ?? sceneDefaults.card;

/** The language of title, description and hints; that of the page as long as none is set. */
export const firstLanguage = (course: Pick<Scene, 'task'>, page: string): string => cardOf(course).language || page;

/** The texts in a language, empty where there are none yet. @param text the description as shown */
export function wordsIn(course: Course, language: string, page: string, text: string): Omit<TaskText, 'language'> {
  const { title, hints, translations } = cardOf(course);
  if (language === firstLanguage(course, page)) return { title, text, hints };
  return translations.find((one) => one.language === language) ?? { title: '', text: '', hints: [] };
}

/** Writes texts in a language. In the first language the description is that of the course. */
export function withWords(course: Course, language: string, page: string, part: WordsPart): CourseChanges {
  const card = cardOf(course);
  const first = firstLanguage(course, page);
  if (language === first) {
    const { text, ...rest } = part;
    const task = withCard(course.task, { ...card, ...rest });
    return { ...(text === undefined ? {} : { description: text }), ...(isSame(task, course.task) ? {} : { task }) };
  }
  const { title, text, hints } = { ...wordsIn(course, language, page, ''), ...part };
  const isEmpty = title === '' && text === '' && hints.length === 0;
  const at = card.translations.findIndex((one) => one.language === language);
  const others = card.translations.filter((_one, index) => index !== at);
  const translations = isEmpty
    ? others
    : others.toSpliced(at < 0 ? others.length : at, 0, { language, title, text, hints });
  // With a second language it must be recorded which one is the first.
  return { task: withCard(course.task, { ...card, language: first, translations }) };
}

/** The task with this card, or without one if the card is empty. */
export function withCard({ card: _old, ...task }: Task, card: TaskCard): Task {
  const language = card.translations.length === 0 ? '' : card.language;
  const next = { ...card, language };
  return isSame(next, sceneDefaults.card) ? task : { ...task, card: next };
}

/** The task with this kind of help allowed or forbidden. */
export function withHelp({ allows = [], ...task }: Task, help: Help, isAllowed: boolean): Task {
  const wanted = helps.filter((one) => (one === help ? isAllowed : allows.includes(one)));
  return wanted.length === 0 ? task : { ...task, allows: wanted };
}

/** The task as several robots share it; `null`: only the first one counts. */
export function withSharing({ robots: _old, ...task }: Task, robots: TaskRule | null): Task {
  return robots === null ? task : { ...task, robots };
}

/** The task with stars for these times, or without. */
export function withStars({ stars: _old, ...task }: Task, stars: Task['stars'] | null): Task {
  return stars === null || stars === undefined ? task : { ...task, stars };
}
