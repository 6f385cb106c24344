import { lateParts } from '../../kit/part';
import { usePage } from '../../kit/parts';
import type { WithLate } from '../../kit/state/late-models';
import { useWork, type WorkParts } from '../../session/work/model/parts';
import { createBroughtModel, type BroughtModel } from './brought-model';

/** Work from elsewhere. */
export interface ElsewhereParts {
  readonly brought: BroughtModel;
}

export const [elsewhereOf, useElsewhere] = lateParts(
  (): Pick<WorkParts, 'work'> & WithLate => ({ ...usePage(), ...useWork() }),
  ({ work }): ElsewhereParts => ({ brought: createBroughtModel(work) }),
);
