import { computed, onScopeDispose, watch, watchEffect } from 'vue';

import type { PageParts } from '../kit/parts';
import type { RunParts } from '../session/run/parts';
import type { WorkParts } from '../session/work/model/parts';

/** Plays the run's sound in time at 1 × and slower, unless muted; reports if the browser does not allow it. */
export function useSound({
  run,
  settings,
  sound,
  notices,
}: Pick<PageParts, 'notices'> & Pick<RunParts, 'run' | 'sound'> & Pick<WorkParts, 'settings'>): void {
  const muted = computed(() => settings.current.value.muted);
  const speed = computed(() => (settings.current.value.speed === 'max' ? Infinity : settings.current.value.speed));
  const options = { flush: 'sync' } as const; // inside the tap that starts a run or unmutes

  watch(
    run.phase,
    (phase) => {
      if (phase !== 'starting') return;
      sound.start();
      sound.wake();
    },
    options,
  );
  watchEffect(() => sound.setSpeed(run.phase.value === 'running' ? speed.value : 0), options);
  watch(
    muted,
    (now) => {
      sound.setMuted(now);
      if (!now && run.isActive.value) sound.wake();
    },
    { ...options, immediate: true },
  );
  const wake = (): void => sound.wake();
  watch(sound.isBlocked, (blocked) => {
    if (blocked) notices.show({ kind: 'info', key: 'notice.soundBlocked' });
    const change = blocked ? addEventListener : removeEventListener;
    change('pointerdown', wake);
    change('keydown', wake);
  });
  onScopeDispose(() => {
    removeEventListener('pointerdown', wake);
    removeEventListener('keydown', wake);
    sound.dispose();
  });
}
