import { onScopeDispose, shallowRef, watchEffect } from 'vue';

import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import { momentOf } from './moment';
import { createTonePlayer } from './tone-player';
import { silence, tonesOf } from './tones';
import { watchStill } from './watch-still';

/** How often the tones follow the run, in ms. */
const EVERY_MS = 40;

/** Lets the run be heard by tones while it goes on, the page is in sight and its sound is on. */
export function useTones({
  run,
  sound,
  settings,
}: Pick<RunParts, 'run' | 'sound'> & Pick<WorkParts, 'settings'>): void {
  const player = createTonePlayer(() => sound.output());
  const isInSight = shallowRef(!document.hidden);
  const look = (): void => void (isInSight.value = !document.hidden);
  document.addEventListener('visibilitychange', look);
  let timer: ReturnType<typeof setInterval> | undefined;
  const isStill = watchStill();

  function follow(): void {
    const snapshot = run.shown.value;
    const nowMs = performance.now();
    const moment = snapshot === null ? null : momentOf(snapshot, nowMs);
    player.play(moment === null || isStill(moment) ? silence : tonesOf(moment), nowMs);
  }
  function stop(): void {
    clearInterval(timer);
    player.stop();
  }
  watchEffect(() => {
    const { tones, muted } = settings.current.value;
    stop();
    if (tones && !muted && isInSight.value && run.phase.value === 'running') timer = setInterval(follow, EVERY_MS);
  });
  onScopeDispose(() => {
    document.removeEventListener('visibilitychange', look);
    stop();
  });
}
