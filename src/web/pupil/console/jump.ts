import { shallowRef } from 'vue';

import type { ErrorPlace } from './log/console-log';
import type { WorkModel } from '../../session/work/model/work-model';

/** A file as it is and as it should be. */
export interface Mending {
  readonly file: string;
  readonly before: string;
  readonly after: string;
}

/** A line of a file of a device, by the device's place. */
export interface DevicePlace extends ErrorPlace {
  readonly device: number;
}

/** Requests to the editor: a line of a file to show, lines to mark as wrong or as changed, and a correction to write. */
export type Jump = ReturnType<typeof createJump>;

/** Makes the requests; `to` and `mend` show the file, too. */
export function createJump(work: WorkModel) {
  const target = shallowRef<ErrorPlace | null>(null);
  const wrong = shallowRef<DevicePlace | null>(null);
  const changed = shallowRef<readonly DevicePlace[]>([]);
  const mending = shallowRef<Mending | null>(null);
  return {
    target,
    wrong,
    /** Lines that were written otherwise when the program was opened. */
    changed,
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
