/** Which modules share a file, and how the files are called. */

/** The late parts that everybody waits for. */
const FIRST_PARTS = /\/(CodeEditor|MicrobitView|next-step)-[^/]*\.js$/;

/**
 * Which of the files that a late part imports are asked for together with it, instead of after it. The lists of those
 * files lie in the first chunk, and would make it 3 kB heavier if every late part had one. Styles are always needed: a
 * part is shown once they are there.
 */
export const fetchedAhead = (part: string, files: string[]): string[] =>
  FIRST_PARTS.test(part) ? files : files.filter((file) => file.endsWith('.css'));

/**
 * Modules in one file, as they are needed at one time. All that the page needs at once: parted among the many late lists
 * and dialogs that share some of it, it would be 35 files more and 13 kB heavier. What every first visit fetches right
 * after it is one file, too, as it compresses better: the next step's bar with the words that the projector view tells, the
 * drawing of zones (which the first course has), the greeting with the menu entries that it shows, the lines of a program
 * that ran, and what lies ready for the keyboard. And the editor, the course editor's actions and palette, and the drawings
 * of the other kinds of objects.
 */
export const chunkGroups = [
  { name: 'page', tags: ['$initial' as const] },
  {
    name: 'next-step',
    test: /\/next-step\/(NextStepBar\.vue|use-verdict\.ts|verdict-view\.ts)|\/arena\/picture\/draw-zones\.ts|\/greeting\/WelcomeCard\.vue|\/debug\/(ran-program|file-key)\.ts|\/app\/SkipLinks\.vue|\/tour\/FirstSteps\.vue/,
  },
  { name: 'picture-kinds', test: /\/arena\/picture\/(scene-kinds|draw-(outline|background|waiting)\.ts)/ },
  { name: 'CodeEditor', test: /\/code\/CodeEditor\.vue/ },
  { name: 'editor-tools', test: /\/course\/editor\/(EditorActions\.vue|palette\/)/ },
];

/**
 * All that the worker needs at once is a file below its own. Late parts of it import from there: where one imported the
 * worker's own file, WebKit would run that file a second time, and each message would be answered twice.
 */
export const belowWorker = {
  name: 'worker-parts',
  tags: ['$initial' as const],
  test: (id: string) => !id.endsWith('/run/worker/worker.ts'),
};

/** The names of all late styles lie in the first chunk, and nobody asks for one by its name: they are short. */
export const shortForStyles = ({ names }: { readonly names: readonly string[] }): string =>
  names[0]?.endsWith('.css') === true ? 'assets/s-[hash:6][extname]' : 'assets/[name]-[hash][extname]';

/** Files of words are called after their group and language. Their names lie in the first chunk, too: no letter more than Rolldown needs. */
export const namesOfWords = ({ facadeModuleId }: { readonly facadeModuleId?: string | null | undefined }): string => {
  const [, group = '', language = ''] = /word-file:(\w+)\/(\w+)$/.exec(facadeModuleId ?? '') ?? [];
  return `assets/${group === '' ? '[name]' : `words-${group}-${language}`}-[hash:7].js`;
};

/** Parts of the editor that come late: cards and panels, and its own completions of Python. */
export const LATE_OF_LIBRARIES = {
  '@codemirror/lang-python': ['globalCompletion', 'localCompletionSource', 'python'],
  '@codemirror/view': [
    ...['showTooltip', 'getTooltip', 'repositionTooltips', 'hoverTooltip', 'activateHover', 'hasHoverTooltips'],
    ...['closeHoverTooltip', 'closeHoverTooltips', 'showPanel', 'getPanel', 'panels', 'showDialog', 'getDialog'],
  ],
} as const;
