import type { de } from './de';

/** The name of one text on the API, such as `microbit.display.show`. A language that misses one does not compile. */
export type ReferenceText = keyof typeof de;
