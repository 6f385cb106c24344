import { shallowRef } from 'vue';

import type { ErrorPlace } from './log/console-log';
import type { WorkModel } from '../work/model/work-model';

/** A wish to show a line of a file, and the line that is marked as wrong. */
export type Jump = ReturnType<typeof createJump>;

/** Makes the wish; asking for a line shows its file. */
export function createJump(work: WorkModel) {
  const target = shallowRef<ErrorPlace | null>(null);
  const wrong = shallowRef<ErrorPlace | null>(null);
  return {
    target,
    wrong,
    to: (place: ErrorPlace): void => {
      work.show(place.file);
      target.value = { ...place };
    },
  };
}
