import type { HexBoard } from '#hex/firmware';

import { guideFor, type Guide, type Platform } from '../ways/ways';
import type words from './words';

/** A row on a drawn screen; the words of the apps themselves are English everywhere. */
export interface ScreenRow {
  readonly look: 'file' | 'plain' | 'chosen' | 'button' | 'ink' | 'app';
  /** Left out: the name of the file. */
  readonly text?: string;
}

/** The drawing of a step. */
export type StepPicture =
  { readonly kind: 'board' | 'cable' | 'drive' } | { readonly kind: 'screen'; readonly rows: readonly ScreenRow[] };

/** A step from a saved hex to the board, by the name of its words. */
export interface GuideStep {
  readonly id: keyof typeof words.steps;
  readonly picture: StepPicture;
}

const screen = (...rows: readonly ScreenRow[]): StepPicture => ({ kind: 'screen', rows });
const board: StepPicture = { kind: 'board' };
const list = (act: string): StepPicture =>
  screen({ look: 'plain', text: 'My programs' }, { look: 'chosen' }, { look: 'ink', text: act });

const save: GuideStep = { id: 'save', picture: screen({ look: 'file' }) };
const drag: GuideStep = { id: 'drag', picture: { kind: 'drive' } };
const ready: GuideStep = { id: 'ready', picture: board };

const steps: Readonly<Record<Guide, readonly GuideStep[]>> = {
  drive: [save, { id: 'plug', picture: { kind: 'cable' } }, drag],
  chromebook: [save, { id: 'plugChromebook', picture: { kind: 'cable' } }, drag],
  'microbit-ipad': [
    { id: 'saveOpen', picture: screen({ look: 'file' }, { look: 'button' }) },
    { id: 'app', picture: screen({ look: 'app', text: 'micro:bit' }) },
    ready,
    { id: 'send', picture: list('Send to micro:bit') },
  ],
  'microbit-android': [
    save,
    { id: 'import', picture: screen({ look: 'plain', text: 'My Programs' }, { look: 'ink', text: 'Import' }) },
    ready,
    { id: 'flash', picture: list('Flash') },
  ],
  'calliope-ipad': [
    save,
    { id: 'tap', picture: screen({ look: 'chosen' }, { look: 'app', text: 'Calliope mini' }) },
    { id: 'readyMini3', picture: board },
    { id: 'upload', picture: screen({ look: 'chosen' }, { look: 'ink', text: 'OK' }) },
  ],
  'calliope-android': [
    save,
    { id: 'openWith', picture: screen({ look: 'chosen' }, { look: 'app', text: 'Calliope mini' }) },
    { id: 'readyMini3', picture: board },
    { id: 'flashCalliope', picture: screen({ look: 'chosen' }, { look: 'ink', text: 'Flash' }) },
  ],
};

/** The steps for this device and board. An old Calliope mini is made ready in another way. */
export const guideSteps = (platform: Platform, of: HexBoard): readonly GuideStep[] =>
  steps[guideFor(platform, of)].map((step) =>
    step.id === 'readyMini3' && of === 'calliope-mini-1' ? { ...step, id: 'readyMini1' } : step,
  );
