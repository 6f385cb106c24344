import { createAsked, type Asked } from './asked';
import { createGuide, type GuideModel } from './guide-model';
import { lateParts } from '../kit/part';
import { usePage } from '../kit/parts';
import { createTour, type TourModel } from './tour-model';

/** The help for beginners: guide, tour and greeting. */
export interface FirstStepsParts {
  readonly guide: GuideModel;
  readonly tour: TourModel;
  readonly greeting: Asked;
}

export const [firstStepsOf, useFirstSteps] = lateParts(usePage, (): FirstStepsParts => ({
  guide: createGuide(),
  tour: createTour(),
  greeting: createAsked(),
}));
