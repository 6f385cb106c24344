import { mdiPause, mdiPlay, mdiSkipNext } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { hasLittleRoom } from '../../session/layout/layout-model';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';

/** The buttons of the run that a small bar has no room for, and the help on ghosts. */
export const contribution: Contribution = {
  menu() {
    const { run } = useRun();
    const { layout } = useLayout();
    return [
      {
        group: 'run',
        order: 0,
        entries() {
          if (!hasLittleRoom(layout.kind.value)) return [];
          const phase = run.phase.value;
          const isPaused = phase === 'paused';
          const pause = {
            id: 'pause',
            testId: 'pause',
            icon: isPaused ? mdiPlay : mdiPause,
            title: t(isPaused ? 'bar.resume' : 'bar.pause'),
            isDisabled: !isPaused && phase !== 'running',
            act: () => (isPaused ? run.resume() : run.pause()),
          };
          const step = {
            id: 'step',
            testId: 'step',
            icon: mdiSkipNext,
            title: t('bar.step'),
            isDisabled: phase === 'running' || phase === 'starting',
            act: () => run.step(),
          };
          return layout.kind.value === 'phone' ? [pause, step] : [step];
        },
      },
    ];
  },
};
