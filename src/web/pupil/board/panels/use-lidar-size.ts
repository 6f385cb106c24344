import { computed, type ComputedRef } from 'vue';

import type { OptionValues } from '#core/option';
import type { LidarState } from '#robots/robot';
import type { RunParts } from '../../../session/run/parts';

/**
 * The number of rows of the lidar's picture: in a run of its robot, else at the start of the next one, by the option `lidar`;
 * `null`: it has none.
 */
export function useLidarSize(
  { shown }: Pick<RunParts['run'], 'shown'>,
  options: () => OptionValues,
): ComputedRef<LidarState['size'] | null> {
  return computed(() => {
    const robot = shown.value?.robot;
    if (robot) return robot.state.lidar?.size ?? null;
    const start = options()['lidar'];
    return start === '8x8' ? 8 : start === '4x4' ? 4 : null;
  });
}
