import { watch, type WatchSource } from 'vue';
import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';

/** Time for which a place is pointed out, in ms. */
const FLASH_MS = 2600;

/** One pulse of the ring, which converges on the place; users who prefer less motion see a still ring. */
const PULSE: Keyframe[] = [
  { transform: 'translate(-50%, -50%) scale(2.4)', opacity: 0 },
  { transform: 'translate(-50%, -50%) scale(1)', opacity: 1, offset: 0.45 },
  { transform: 'translate(-50%, -50%) scale(1)', opacity: 1, offset: 0.8 },
  { transform: 'translate(-50%, -50%) scale(1)', opacity: 0 },
];

/**
 * Points out a place in the arena with a ring for some seconds.
 *
 * @param place its current position, in CSS px from the host's upper left corner
 * @param moved source to watch: `place` is called again when it changes
 * @returns removes it early
 */
export function flashAt(host: HTMLElement, place: () => Vec, moved: WatchSource): Stop {
  const ring = document.createElement('div');
  ring.setAttribute('aria-hidden', 'true');
  ring.dataset['testid'] = 'flash';
  ring.style.cssText =
    'position:absolute;width:64px;height:64px;border-radius:50%;border:4px solid var(--accent-line);' +
    'box-shadow:0 0 0 3px #fff,inset 0 0 0 3px #fff;pointer-events:none;transform:translate(-50%,-50%);z-index:3';
  const put = (): void => {
    // A place that cannot be brought into sight is pointed at from the edge.
    const { x, y } = place();
    ring.style.left = `${String(Math.min(host.clientWidth - 20, Math.max(20, x)))}px`;
    ring.style.top = `${String(Math.min(host.clientHeight - 20, Math.max(20, y)))}px`;
  };
  put();
  host.append(ring);
  if (!window.matchMedia('(prefers-reduced-motion: reduce)').matches)
    ring.animate(PULSE, { duration: FLASH_MS / 3, iterations: 3, easing: 'ease-out' });
  const unwatch = watch(moved, put, { flush: 'sync' });
  const stop = (): void => {
    unwatch();
    clearTimeout(timer);
    ring.remove();
  };
  const timer = setTimeout(stop, FLASH_MS);
  return stop;
}
