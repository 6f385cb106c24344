import type { Texts } from '#core/languages';

import type { RunParts } from '../../session/run/parts';
import type { CourseEditorParts } from '../../course/editor/state/parts';
import type { Pane } from '../../session/layout/layout-model';
import type { FirstStepsParts } from '../parts';
import words from '../words';

/** Name of a step of the tour; the one at which it was left is stored by it. */
export type TourStepId = keyof typeof words.steps;

/** The models that the steps observe. */
export type TourSubject = Pick<RunParts, 'run'> & Pick<CourseEditorParts, 'editor'> & Pick<FirstStepsParts, 'guide'>;

/** One step: a real control that is pointed at, and words about it. */
export interface TourStep {
  readonly id: TourStepId;
  /** The pane it is in, which a phone brings to the front; `null`: in the bar. */
  readonly pane: Pane | null;
  /** Selectors of the control; the first one in sight counts. */
  readonly targets: readonly string[];
  /** True once the step was done, and the tour goes on by itself; `null`: there is only something to see. */
  readonly isDone: ((app: TourSubject) => boolean) | null;
}

/** The button behind which a narrow window keeps what has no room in the bar. */
export const MENU = '[data-testid="menu"]';

const seen = (id: TourStepId, pane: Pane | null, ...targets: readonly string[]): TourStep => ({
  id,
  pane,
  targets,
  isDone: null,
});

const code = seen('code', 'code', '[data-testid="editor"]');
const run: TourStep = { ...seen('run', null, '[data-testid="run"]'), isDone: (app) => app.run.isActive.value };
const arena = seen('arena', 'arena', '[data-testid="arena"]');
const board = seen('board', 'board', '[data-testid="board"]');
const output = seen('console', 'console', '.pane-console');
const stop: TourStep = {
  ...seen('stop', null, '[data-testid="stop"]', '[data-testid="run"]'),
  isDone: (app) => !app.run.isActive.value,
};
const tools: TourStep = {
  ...seen('tools', 'arena', '.modes', '[data-testid="palette"]'),
  isDone: (app) => app.editor.isOpen.value,
};
const course = seen('course', null, '[data-testid="course"]', MENU);
const help: TourStep = {
  ...seen('help', null, MENU),
  isDone: (app) => app.guide.at.value !== null,
};

/** The steps for what is on the page: at most eight. Without an arena the board has its place, and nobody builds. */
export const stepsFor = (hasArena: boolean, mayBuild = true): readonly TourStep[] =>
  [code, run, hasArena ? arena : board, output, stop, tools, course, help].filter(
    (step) => step !== tools || (hasArena && mayBuild),
  );

/** The place of a stored step; one that is not among them, or unknown, is the beginning. */
export const placeOf = (steps: readonly TourStep[], kept: string | null): number =>
  Math.max(
    0,
    steps.findIndex(({ id }) => id === kept),
  );

/** The title and the words of a step. */
export const wordsFor = (id: TourStepId): { readonly title: Texts; readonly text: Texts } => words.steps[id];
