/** The keys that start and stop a run, as they are named on the page; ⌘ does the same as Ctrl. */
export const RUN_KEYS = 'Ctrl+Enter';
/** Free in browsers, their editors and on all keyboards: Shift+Esc is Chrome’s own, Ctrl+. writes emoji on Linux. */
export const STOP_KEYS = 'Ctrl+Shift+Enter';
