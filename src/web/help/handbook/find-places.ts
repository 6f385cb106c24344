import { fitOf, wordsOf } from '../guide/search';
import type { Book } from './book';
import { placesIn, type Place } from './load-book';

/** The sections that a search finds, the best first. */
export function findPlaces(book: Book, query: string): readonly Place[] {
  const words = wordsOf(query);
  if (words.length === 0) return [];
  return placesIn(book)
    .map((place) => ({ place, fit: fitOf(words, place.section.title, textOf(place)) }))
    .filter(({ fit }) => fit > 0)
    .sort((one, other) => other.fit - one.fit)
    .map(({ place }) => place);
}

const textOf = ({ chapter, section }: Place): string => `${chapter.title} ${section.text} ${section.tip}`;

/** The beginning of a section's text, as one line: longer than there is room for. */
export const beginningOf = ({ section }: Place): string =>
  section.text.replaceAll('**', '').replaceAll('`', '').replace(/\s+/g, ' ').slice(0, 400);
