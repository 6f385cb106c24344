import { onScopeDispose, watch } from 'vue';
import type { Vec } from '#core/geometry';
import type { ArenaView } from './use-arena-view';
import { toPx } from './view-transform';

/** After a rest the first step is as long as that of one frame, in ms. */
const FRAME_MS = 16;
/** Longest step, in ms: after a page was out of sight the picture must not jump. */
const LONGEST_MS = 100;

/** Zoom when following begins: with the whole arena in sight there is nothing to follow. Chosen by eye. */
const NEAR_PERCENT = 200;

/** The followed place. */
export interface Followed {
  /** True while the picture is to follow. */
  readonly isOn: () => boolean;
  /** World mm, or `null`: nothing there, or the hand has it. */
  readonly place: () => Vec | null;
}

/** Holds a place in the middle third of the arena's picture while following is on; zooms in when it begins. */
export function useFollow(
  picture: Pick<ArenaView, 'view' | 'percent' | 'zoomBy' | 'follow'>,
  { isOn, place }: Followed,
): void {
  let frame: number | null = null;
  let beforeMs: number | null = null;
  const step = (nowMs: number): void => {
    frame = null;
    const at = isOn() ? place() : null;
    const elapsedMs = beforeMs === null ? FRAME_MS : Math.min(LONGEST_MS, nowMs - beforeMs);
    if (at === null || !picture.follow(at, elapsedMs)) {
      beforeMs = null;
      return;
    }
    beforeMs = nowMs;
    frame = requestAnimationFrame(step);
  };
  watch(isOn, (on) => {
    const at = place();
    if (on && at !== null && picture.percent.value < NEAR_PERCENT - 50)
      picture.zoomBy(NEAR_PERCENT / picture.percent.value, toPx(picture.view.value, at));
  });
  // If nothing is followed, a driving robot requests no frame.
  watch(
    () => (isOn() ? place() : null),
    (at) => at !== null && (frame ??= requestAnimationFrame(step)),
    { immediate: true },
  );
  onScopeDispose(() => {
    if (frame !== null) cancelAnimationFrame(frame);
  });
}
