import type { Language } from '../i18n/texts';

/** A sample program for the microcomputer alone: no course, no robot. Its comments and words are in the pupil's language. */
export interface BoardProgram {
  /** Name of its folder. */
  readonly id: string;
  readonly title: Readonly<Record<Language, string>>;
  readonly source: Readonly<Record<Language, string>>;
  /** Id of the only board it runs on, or `null`. */
  readonly board: string | null;
}

const sources = import.meta.glob<string>('../../../courses/board/*/main.*.py', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** In the order of the lessons: what is seen, what is pressed, what is felt, what is sent and kept. */
const TITLES: Readonly<Record<string, Readonly<Record<Language, string>>>> = {
  heart: { de: 'Herz und Laufschrift', en: 'Heart and scrolling text' },
  counter: { de: 'Zähler mit Tasten', en: 'Counter with buttons' },
  dice: { de: 'Würfel zum Schütteln', en: 'Dice to shake' },
  light: { de: 'Lichtmesser', en: 'Light meter' },
  thermometer: { de: 'Thermometer', en: 'Thermometer' },
  compass: { de: 'Kompassnadel', en: 'Compass needle' },
  melody: { de: 'Melodie', en: 'Melody' },
  radio: { de: 'Nachrichten funken', en: 'Messages by radio' },
  'data-log': { de: 'Daten aufzeichnen', en: 'Logging data' },
  calliope: { de: 'Calliope: Farblichter und Motoren', en: 'Calliope: colour lights and motors' },
};

const sourceOf = (id: string, language: Language): string =>
  sources[`../../../courses/board/${id}/main.${language}.py`] ?? '';

/** Every sample program for the microcomputer alone. Imported only where they are offered: they are of no use before. */
export const boardPrograms: readonly BoardProgram[] = Object.entries(TITLES).map(([id, title]) => ({
  id,
  title,
  source: { de: sourceOf(id, 'de'), en: sourceOf(id, 'en') },
  board: id === 'calliope' ? 'calliope-mini-3' : null,
}));

/** A text is one of ours, untouched by a pupil. */
export const isBoardProgram = (text: string): boolean =>
  boardPrograms.some(({ source }) => Object.values(source).includes(text));
