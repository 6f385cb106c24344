import type de from '../words/de.json';
import type { AdviceTexts } from '#advice/text';

type Leaves<T> = { [K in keyof T & string]: T[K] extends string ? K : `${K}.${Leaves<T[K]>}` }[keyof T & string];

/** The texts of the first page. */
export type Texts = typeof de;

/** What goes wrong in a program: a catalogue of its own that comes late. */
export type ErrorTexts = AdviceTexts;

/** The name of one text, such as `bar.run`. */
export type TextKey = Leaves<typeof de> | `error.${keyof ErrorTexts}`;

/** The values for a text's braces; numbers are written in the form of the language. */
export type TextValues = Readonly<Record<string, string | number>>;

/** Looks a text up in the chosen language. */
export type Translate = (key: TextKey, values?: TextValues) => string;

export { LANGUAGES, type Language } from '#core/languages';
