import type { GuideModel } from './guide-model';
import { part } from '../kit/part';
import type { TourModel } from './tour-model';

/** The help for beginners: guide and tour. */
export interface FirstStepsParts {
  readonly guide: GuideModel;
  readonly tour: TourModel;
}

export const [provideFirstSteps, useFirstSteps] = part<FirstStepsParts>('first steps');
