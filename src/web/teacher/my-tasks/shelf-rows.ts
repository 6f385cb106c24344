import { creditOf, type TaskAbout } from '#check/task/about';
import type { Scene } from '#scene/scene';

import { shownLanguage, t } from '../../kit/i18n';
import words from './words';

/** A task or a series as a row of a list. */
export interface ShelfRow {
  /** Tells it from the others of its list. */
  readonly id: string;
  readonly name: string;
  /** The first sentence that pupils read. */
  readonly text: string;
  readonly about: TaskAbout;
  /** The course in its picture; `null`: it has none. */
  readonly scene: Scene | null;
  /** The kind of work and its size in words; empty: not known. */
  readonly size: string;
}

/** A wish for the list: search, level, topic, duration; empty texts and `null` leave all. */
export interface ShelfWish {
  readonly search: string;
  readonly level: string;
  readonly topic: string;
  /** At most this many minutes. */
  readonly minutes: number | null;
}

export const noWish: ShelfWish = { search: '', level: '', topic: '', minutes: null };

/** The rows that fit: each word of the search is somewhere in name, text or details. */
export function fitting<Row extends ShelfRow>(rows: readonly Row[], wish: ShelfWish): readonly Row[] {
  const sought = wish.search.toLowerCase().split(/\s+/).filter(Boolean);
  return rows.filter(({ name, text, about }) => {
    const all = [name, text, about.level, about.topic, about.author].join(' ').toLowerCase();
    return (
      sought.every((word) => all.includes(word)) &&
      (wish.level === '' || about.level === wish.level) &&
      (wish.topic === '' || about.topic === wish.topic) &&
      (wish.minutes === null || (about.minutes !== null && about.minutes <= wish.minutes))
    );
  });
}

/** All that was said as a level or a topic, in the order of the language. */
export function saidIn(rows: readonly Pick<ShelfRow, 'about'>[], what: 'level' | 'topic'): readonly string[] {
  const all = new Set(rows.map(({ about }) => about[what]).filter((said) => said !== ''));
  return [...all].sort(new Intl.Collator(shownLanguage(), { numeric: true }).compare);
}

/** The durations that are offered, in minutes: a part of a lesson, one, two. */
export const DURATIONS = [20, 45, 90] as const;

/** Level, topic, duration, author and licence in one line. */
export function detailsOf({ size, about }: Pick<ShelfRow, 'size' | 'about'>): string {
  const { level, topic, minutes } = about;
  return [level, topic, minutes === null ? '' : t(words.minutes, { count: minutes }), size, creditOf(about)]
    .filter((said) => said !== '')
    .join(' · ');
}
