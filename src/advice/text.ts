import type de from './words/de.json';

/** What can be said about errors of a program; all names have `error.` before them, as on the page. */
export type AdviceTexts = typeof de;

/** The name of one of these texts; `error.other`: there is nothing to say but the device's words. */
export type AdviceKey = `error.${keyof AdviceTexts}` | 'error.other';

/** What stands in a text's braces. */
export type AdviceValues = Readonly<Record<string, string | number>>;
