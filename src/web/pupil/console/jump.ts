import { shallowRef } from 'vue';

import type { ErrorPlace } from './log/console-log';
import type { WorkModel } from '../../session/work/model/work-model';

/** A file as it is and as it should be. */
export interface Mending {
  readonly file: string;
  readonly before: string;
  readonly after: string;
}

/** A wish to show a line of a file, and the line that is marked as wrong. */
export type Jump = ReturnType<typeof createJump>;

/** Makes the wish; asking for a line shows its file. */
export function createJump(work: WorkModel) {
  const target = shallowRef<ErrorPlace | null>(null);
  const wrong = shallowRef<(ErrorPlace & { readonly device: number }) | null>(null);
  const mending = shallowRef<Mending | null>(null);
  return {
    target,
    wrong,
    /** A correction that the editor should write; it clears it when done. */
    mending,
    mend: (file: string, before: string, after: string): void => {
      work.show(file);
      mending.value = { file, before, after };
    },
    to: (place: ErrorPlace): void => {
      work.show(place.file);
      target.value = { ...place };
    },
  };
}
