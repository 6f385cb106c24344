/** First steps: short articles, in the order of a first lesson. */
export const STEP_IDS = [
  'step-write',
  'step-run',
  'step-change',
  'step-error',
  'step-board',
  'step-course',
  'step-build',
  'step-share',
] as const;

/** Controls of the bar above. */
export const BAR_IDS = ['run', 'stop', 'pause', 'step', 'reset', 'speed', 'device', 'course', 'share', 'menu'] as const;

/** The other entries of the menu. */
export const MENU_IDS = [
  'open',
  'save',
  'save-program',
  'save-scene',
  'real-device',
  'language',
  'theme',
  'panes',
  'device-check',
  'help',
  'tour',
  'stages',
] as const;

/** Around the program. */
export const PROGRAM_IDS = [
  'files',
  'new-file',
  'file-menu',
  'commands',
  'suggestions',
  'explain',
  'break-points',
] as const;

/** The board and what is unfolded below it. */
export const BOARD_IDS = ['buttons', 'sensors', 'radio', 'log'] as const;

/** Around the arena. */
export const ARENA_IDS = ['arena-hand', 'look-back', 'ask-why', 'readings', 'verdict'] as const;

/** The console. */
export const CONSOLE_IDS = [
  'output',
  'chart',
  'together',
  'copy',
  'clear',
  'fold',
  'input',
  'interrupt',
  'restart',
] as const;

/** Keys of the keyboard. */
export const KEY_IDS = [
  'key-run',
  'key-stop',
  'key-save',
  'key-open',
  'key-help',
  'key-explain',
  'key-leave',
  'key-comment',
  'key-board',
  'key-arrows',
  'key-draw',
  'key-turn',
  'key-delete',
  'key-copy',
  'key-group',
  'key-menu',
  'key-all',
  'key-explore',
  'key-around',
  'key-undo',
  'key-interrupt',
  'key-restart',
  'key-history',
  'key-escape',
] as const;

/** The help's own entries by section; features add theirs, and the commands come from the reference. */
export const sectionIds = {
  steps: STEP_IDS,
  bar: BAR_IDS,
  menu: MENU_IDS,
  program: PROGRAM_IDS,
  board: BOARD_IDS,
  arena: ARENA_IDS,
  tools: [],
  console: CONSOLE_IDS,
  keys: KEY_IDS,
} as const;

export type SectionId = keyof typeof sectionIds;
/** The name of one entry of the help, by which other places can open it. */
export type EntryId = (typeof sectionIds)[SectionId][number];
