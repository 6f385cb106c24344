import type { Drawn } from './drawn';

/**
 * The layers over the panes, from the back to the front: `task` below the messages; above them windows and cards, then
 * pages over the whole app, then the help; `words` are for screen readers.
 */
export const WINDOW_LAYERS = ['task', 'window', 'page', 'help', 'words'] as const;
export type WindowLayer = (typeof WINDOW_LAYERS)[number];

/**
 * Something that a feature draws over the page. A feature lists them in its `windows.ts`, which comes with the app, and
 * loads what is not in its first picture.
 */
export type FeatureWindow = Drawn & {
  readonly layer: WindowLayer;
  /** Called in the set-up of the app, so it may ask for models. @returns a function that is true while it is drawn */
  readonly shows: () => () => boolean;
};
