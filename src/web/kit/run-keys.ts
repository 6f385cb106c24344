/** The keys that start a run, as they are named on the page; ⌘ does the same as Ctrl. */
export const RUN_KEYS = 'Ctrl+Enter';
/**
 * The keys that stop it. They are free in browsers, their editors and on all keyboards: Shift+Esc is Chrome’s own,
 * Ctrl+. writes emoji on Linux.
 */
export const STOP_KEYS = 'Ctrl+Shift+Enter';
