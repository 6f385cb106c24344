import { computed, effectScope, nextTick, shallowRef } from 'vue';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Vec } from '#core/geometry';
import { useFollow } from './use-follow';

/** A robot that drives, and the frames requested during its drive. */
function driving(follows: boolean) {
  const isOn = shallowRef(follows);
  const at = shallowRef<Vec | null>({ x: 0, y: 0 });
  const seen: Vec[] = [];
  const scope = effectScope();
  scope.run(() =>
    useFollow(
      {
        view: shallowRef({ pxPerMm: 1, leftPx: 0, bottomPx: 0 }),
        percent: computed(() => 200),
        zoomBy: () => undefined,
        follow: (place) => {
          seen.push(place);
          return false; // it is in the middle already
        },
      },
      { isOn: () => isOn.value, place: () => at.value },
    ),
  );
  return {
    isOn,
    seen,
    scope,
    drive: async (frames: number) => {
      for (let i = 1; i <= frames; i += 1) {
        at.value = { x: i, y: 0 };
        await nextTick();
        vi.advanceTimersByTime(17);
      }
    },
  };
}

describe('the picture that follows the robot', () => {
  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal('requestAnimationFrame', vi.fn((act: (ms: number) => void) => setTimeout(() => act(performance.now()), 16))); // prettier-ignore
    vi.stubGlobal('cancelAnimationFrame', (handle: number) => clearTimeout(handle));
  });
  afterEach(() => {
    vi.unstubAllGlobals();
    vi.useRealTimers();
  });

  it('asks for no frame while it does not follow, however far the robot drives', async () => {
    const { drive, seen, scope } = driving(false);
    await drive(10);
    expect(requestAnimationFrame).not.toHaveBeenCalled();
    expect(seen).toEqual([]);
    scope.stop();
  });

  it('looks after the robot in each frame in which it drives, and from the moment it is switched on', async () => {
    const { drive, seen, isOn, scope } = driving(false);
    await drive(3);
    isOn.value = true;
    await nextTick();
    vi.advanceTimersByTime(17);
    expect(seen).toEqual([{ x: 3, y: 0 }]);
    await drive(2);
    expect(seen.slice(1)).toEqual([
      { x: 1, y: 0 },
      { x: 2, y: 0 },
    ]);
    scope.stop();
  });
});
