import { shownLanguage } from '.';

/** A name and its value: `Tempo: 2×`; in French with a narrow space before the colon. */
export const labelled = (name: string, value: string): string =>
  `${name}${shownLanguage() === 'fr' ? '\u202f' : ''}: ${value}`;
