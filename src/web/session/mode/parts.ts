import { part } from '../../kit/part';
import type { ModeModel } from './mode-model';

/** The mode of the arena. */
export interface ModeParts {
  readonly mode: ModeModel;
}

export const [provideMode, useMode] = part<ModeParts>('mode');
