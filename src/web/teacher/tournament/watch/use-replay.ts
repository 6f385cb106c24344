import { computed, onScopeDispose, shallowRef, watch } from 'vue';

/** Longest frame of wall time, in ms. A tab that was out of sight goes on where it was. */
const LONGEST_FRAME_MS = 100;

/** The speeds at which a match is shown. */
export const speeds = [1, 4, 16] as const;

/**
 * The time of a match that is shown: it plays at a speed, or is moved by hand.
 *
 * @param endMs the end of the match; 0: there is none
 */
export function useReplay(endMs: () => number) {
  const wishedMs = shallowRef(0);
  const nowMs = computed(() => Math.min(wishedMs.value, endMs()));
  const isOver = computed(() => endMs() > 0 && nowMs.value >= endMs());
  const speed = shallowRef<(typeof speeds)[number]>(4);
  const isPlaying = shallowRef(false);
  let frame = 0;
  let lastMs: number | null = null;
  function step(frameMs: number): void {
    const passedMs = lastMs === null ? 0 : Math.min(LONGEST_FRAME_MS, frameMs - lastMs);
    lastMs = frameMs;
    wishedMs.value = nowMs.value + passedMs * speed.value;
    if (isOver.value) isPlaying.value = false;
    else frame = requestAnimationFrame(step);
  }
  watch(isPlaying, (plays) => {
    cancelAnimationFrame(frame);
    lastMs = null;
    if (plays) frame = requestAnimationFrame(step);
  });
  onScopeDispose(() => cancelAnimationFrame(frame));
  return {
    ...{ nowMs, isOver, speed, isPlaying },
    /** Shows a moment. */
    seek: (ms: number) => (wishedMs.value = ms),
    /** Shows it from its beginning. @param plays it begins to play */
    begin(plays: boolean): void {
      wishedMs.value = 0;
      isPlaying.value = plays;
    },
    toggle(): void {
      if (!isPlaying.value && isOver.value) wishedMs.value = 0;
      isPlaying.value = endMs() > 0 && !isPlaying.value;
    },
  };
}

/** The time of a match that is shown. */
export type Replay = ReturnType<typeof useReplay>;
