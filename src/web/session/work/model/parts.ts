import type { SettingsModel } from '../settings/settings-model';
import type { WorkModel } from './work-model';
import type { PageParts } from '../../../kit/parts';
import type { RunParts } from '../../run/parts';
import { part } from '../../../kit/part';

/** The pupil's work and settings. */
export interface WorkParts {
  readonly work: WorkModel;
  readonly settings: SettingsModel;
}

export const [provideWork, useWork] = part<WorkParts>('work');

/**
 * The models that changing the work needs: another robot ends a run, questions are asked, and the change is
 * announced.
 */
export type Workplace = PageParts & Pick<RunParts, 'run'> & WorkParts;
