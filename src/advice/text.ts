import type de from './words/de.json';

/** Explanations of a program's errors; each name begins with `error.`, as on the page. */
export type AdviceTexts = typeof de;

/** The name of one of these texts; `error.other`: there is nothing to say but the device's words. */
export type AdviceKey = `error.${keyof AdviceTexts}` | 'error.other';

/** Values for the placeholders of a text. */
export type AdviceValues = Readonly<Record<string, string | number>>;
