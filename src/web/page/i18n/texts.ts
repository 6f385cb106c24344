import type { de } from './de';
import type { errorDe } from './error-de';

type Shape<T> = { readonly [K in keyof T]: T[K] extends string ? string : Shape<T[K]> };
type Leaves<T> = { [K in keyof T & string]: T[K] extends string ? K : `${K}.${Leaves<T[K]>}` }[keyof T & string];

/** The shape every catalogue has. A language that misses a text does not compile. */
export type Texts = Shape<typeof de>;

/** What goes wrong in a program: a catalogue of its own that comes late. */
export type ErrorTexts = Shape<typeof errorDe>;

/** The name of one text, such as `bar.run`. */
export type TextKey = Leaves<typeof de> | `error.${keyof ErrorTexts}`;

/** What stands in a text's braces; numbers are written as the language writes them. */
export type TextValues = Readonly<Record<string, string | number>>;

/** Looks a text up in the chosen language. */
export type Translate = (key: TextKey, values?: TextValues) => string;

export { LANGUAGES, type Language } from '#core/texts';
