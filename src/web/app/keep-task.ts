import { watch } from 'vue';

import type { KeptPage } from '../course/locks/keeper';
import { isHandedOut } from '../session/work/model/keeper';

/** Keeps what a task locks. What does so comes with the first task. */
export function keepTask(app: KeptPage): void {
  const project = () => app.work.work.value.project;
  watch(
    () => project().task && isHandedOut(project()),
    (isGiven, _, onEnd) => {
      if (isGiven === undefined) return;
      const opened = project();
      let isWanted = true;
      let stop = (): void => void (isWanted = false);
      onEnd(() => stop());
      void import('../course/locks/keeper').then(
        ({ keep }) => {
          if (isWanted) stop = keep(app, opened);
        },
        () => undefined, // without a connection nothing is locked: it is a help, no security
      );
    },
    { immediate: true, flush: 'sync' },
  );
}
