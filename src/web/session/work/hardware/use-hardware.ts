import { computed, type ComputedRef } from 'vue';

import type { AtTable } from '#advice/at-table';
import type { Hardware } from '#simulation/hardware';

import type { WorkParts } from '../model/parts';
import { deviceAt } from './device-at';
import { hardwareOf } from './hardware';
import { robotInError, type Fitted } from './misplugged';

/**
 * The robot, the board and its firmware that the device that is shown would have in a run of the present work; `null`
 * where the course names unknown ones.
 */
export const useHardware = (parts: WorkParts): ComputedRef<Hardware | null> => computed(() => hardwareNow(parts));

/** The same at this moment, of the device at this place. */
export function hardwareNow(parts: WorkParts, place = parts.work.place.value): Hardware | null {
  const { project, settings } = deviceAt(parts, place);
  return hardwareOf(project, settings);
}

/** True if any of the devices drives. */
export const hasRobot = (parts: WorkParts): boolean =>
  parts.work.devices.value.some((_, place) => (hardwareNow(parts, place)?.robot ?? null) !== null);

/** The device at this place, and whether a task keeps its robot. */
export const fittedNow = (parts: WorkParts, place = parts.work.place.value): Fitted => ({
  ...deviceAt(parts, place),
  isKept: parts.work.locks.isLocked('robot'),
});

/** The present robot's part in the explanation of an error. */
export const robotInErrorNow = (parts: WorkParts, place = parts.work.place.value): AtTable =>
  robotInError(fittedNow(parts, place));
