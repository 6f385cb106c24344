import type de from '../../words/guide/de.json';

/** The words of the help in one language; `{count}`, `{module}` and `{code}` are places for values. */
export type GuideContent = typeof de;

/** Entries whose name stands nowhere else in the app. */
export type OwnName = keyof GuideContent['names'];
