import { watch } from 'vue';

import type { KeptPage } from '../handed-out/keeper';
import { isHandedOut } from '../work/model/keeper';

/** Keeps what a task locks that was handed out. What does so comes with the first such task. */
export function keepTask(app: KeptPage): void {
  watch(
    () => isHandedOut(app.work.work.value.project),
    (isGiven, _, onEnd) => {
      if (!isGiven) return;
      let isWanted = true;
      let stop = (): void => void (isWanted = false);
      onEnd(() => stop());
      void import('../handed-out/keeper').then(
        ({ keep }) => {
          if (isWanted) stop = keep(app);
        },
        () => undefined, // without a connection nothing is locked: it is a help, no security
      );
    },
    { immediate: true, flush: 'sync' },
  );
}
