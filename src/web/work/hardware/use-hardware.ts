import { computed, type ComputedRef } from 'vue';

import type { Hardware } from '#simulation/hardware';

import type { WorkParts } from '../model/parts';
import { hardwareOf } from './hardware';
import { tableOf, type OnTable } from './misplugged';

/** The robot, the board and its firmware that a run of the present work would have; `null` where the course names unknown ones. */
export const useHardware = (parts: WorkParts): ComputedRef<Hardware | null> => computed(() => hardwareNow(parts));

/** The same at this moment. */
export const hardwareNow = ({ work: { work }, settings }: WorkParts): Hardware | null =>
  hardwareOf(work.value.project, settings.current.value);

/** What the explanation of an error must know about the robot that is plugged in now. */
export const tableNow = ({ work: { work }, settings }: WorkParts): OnTable =>
  tableOf(work.value.project, settings.current.value);
