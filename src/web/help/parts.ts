import { createGuide, type GuideModel } from './guide-model';
import { lateParts } from '../kit/part';
import { usePage } from '../kit/parts';
import { createTour, type TourModel } from './tour-model';

/** The help for beginners: guide and tour. */
export interface FirstStepsParts {
  readonly guide: GuideModel;
  readonly tour: TourModel;
}

export const [firstStepsOf, useFirstSteps] = lateParts(usePage, (): FirstStepsParts => ({
  guide: createGuide(),
  tour: createTour(),
}));
