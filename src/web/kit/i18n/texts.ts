import type { AdviceTexts } from '#advice/text';

import type words from '../words';

type Leaves<T> = {
  [K in keyof T & string]: T[K] extends { readonly de: string } ? K : `${K}.${Leaves<T[K]>}`;
}[keyof T & string];

/** The whole name of one of the page's texts, such as `bar.run`. */
export type TextKey = Leaves<typeof words> | `error.${keyof AdviceTexts}`;

/** The values for a text's braces; numbers are written in the form of the language. */
export type TextValues = Readonly<Record<string, string | number>>;

export { LANGUAGES, type Language } from '#core/languages';
