import { shallowRef } from 'vue';

import type { ErrorPlace } from './log/console-log';
import type { WorkModel } from '../../session/work/model/work-model';

/** A file as it is and as it should be. */
export interface Mending {
  readonly file: string;
  readonly before: string;
  readonly after: string;
}

/** Requests to the editor: a line of a file to show, one to mark as wrong, and a correction to write. */
export type Jump = ReturnType<typeof createJump>;

/** Makes the requests; `to` and `mend` show the file, too. */
export function createJump(work: WorkModel) {
  const target = shallowRef<ErrorPlace | null>(null);
  const wrong = shallowRef<(ErrorPlace & { readonly device: number }) | null>(null);
  const mending = shallowRef<Mending | null>(null);
  return {
    target,
    wrong,
    /** A correction for the editor to write, which then clears it. */
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
