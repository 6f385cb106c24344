import { watch } from 'vue';

import type { LockedPage } from './lock-task';
import { isHandedOut } from '../../session/work/model/task-locks';

/** Applies the locks of the open task. The code for it is loaded with the first task. */
export function applyLocks(app: LockedPage): void {
  const project = () => app.work.work.value.project;
  watch(
    () => project().task && isHandedOut(project()),
    (isGiven, _, onEnd) => {
      if (isGiven === undefined) return;
      const opened = project();
      let isWanted = true;
      let stop = (): void => void (isWanted = false);
      onEnd(() => stop());
      void import('./lock-task').then(
        ({ lockTask }) => {
          if (isWanted) stop = lockTask(app, opened);
        },
        () => undefined, // without a connection nothing is locked: it is a help, no security
      );
    },
    { immediate: true, flush: 'sync' },
  );
}
