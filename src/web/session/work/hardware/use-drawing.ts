import { computed, shallowRef, watch, type ComputedRef } from 'vue';

import type { OptionValues } from '#core/option';
import { fetchDrawing, fetchedDrawing } from '#robots/drawings';
import type { RobotType } from '#robots/robot';

/**
 * The drawing of a robot, which is fetched when the robot is first shown; `null` until it is there.
 *
 * @param options the parts that are plugged in; left out: what comes in the box
 */
export function useDrawing(
  robot: () => Pick<RobotType, 'id'> | null,
  options?: () => OptionValues,
): ComputedRef<string | null> {
  const id = computed(() => robot()?.id ?? null);
  /** The robot whose drawing has come. */
  const come = shallowRef<string | null>(null);
  watch(
    id,
    async (wanted) => {
      if (wanted !== null && fetchedDrawing(wanted) === null) await fetchDrawing(wanted).catch(() => null); // without a connection it is asked for at the next change
      if (id.value === wanted) come.value = wanted;
    },
    { immediate: true },
  );
  return computed(() => (id.value === null || come.value !== id.value ? null : fetchedDrawing(id.value, options?.())));
}
