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
export const BAR_IDS = [
  'run',
  'stop',
  'pause',
  'step',
  'reset',
  'speed',
  'sound',
  'device',
  'course',
  'share',
  'save',
  'open',
  'language',
  'theme',
  'help',
  'menu',
] as const;

/** The other entries of the menu. */
export const MENU_IDS = [
  'stages',
  'tour',
  'real-device',
  'save-program',
  'save-scene',
  'open-link',
  'show-board',
  'show-arena',
  'gallery',
  'task-maker',
  'make-series',
  'series',
  'class',
  'projector',
  'device-check',
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
  'line-by-line',
  'variables',
] as const;

/** The board and what is unfolded below it. */
export const BOARD_IDS = ['buttons', 'sensors', 'radio', 'log'] as const;

/** Around the arena. */
export const ARENA_IDS = [
  'arena-hand',
  'tools',
  'look-back',
  'ask-why',
  'show',
  'ghosts',
  'tell',
  'readings',
  'zoom',
  'zoom-to',
  'fit',
  'near',
  'cinema',
  'fullscreen',
  'verdict',
] as const;

/** The tools, and what else there is about a course. */
export const TOOL_IDS = [
  'tool-hand',
  'tool-select',
  'tool-rotate',
  'tool-pen',
  'tool-eraser',
  'tool-block',
  'tool-wall',
  'tool-maze',
  'tool-zone',
  'tool-label',
  'tool-start',
  'tool-ruler',
  'undo',
  'redo',
  'course-more',
  'parts',
  'course-list',
  'course-settings',
  'background',
  'print',
  'clear-course',
] as const;

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
  'key-help',
  'key-explain',
  'key-leave',
  'key-comment',
  'key-board',
  'key-tools',
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

/** All parts of the help but the commands, which come from the reference. */
export const sectionIds = {
  steps: STEP_IDS,
  bar: BAR_IDS,
  menu: MENU_IDS,
  program: PROGRAM_IDS,
  board: BOARD_IDS,
  arena: ARENA_IDS,
  tools: TOOL_IDS,
  console: CONSOLE_IDS,
  keys: KEY_IDS,
} as const;

export type SectionId = keyof typeof sectionIds;
/** The name of one entry of the help, by which other places can open it. */
export type EntryId = (typeof sectionIds)[SectionId][number];
