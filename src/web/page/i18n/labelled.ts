import { shownLanguage } from '.';

/** A name and what it stands at: `Tempo: 2×`; in French with a narrow space before the colon. */
export const labelled = (name: string, value: string): string =>
  `${name}${shownLanguage() === 'fr' ? '\u202f' : ''}: ${value}`;
