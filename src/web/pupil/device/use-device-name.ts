import { computed, type ComputedRef } from 'vue';

import { t } from '../../kit/i18n';
import { useDevice, type DeviceModel } from '../../session/work/hardware/use-device';
import words from './words/several';

/** How the device that is shown is called, for a button that leads to its choice. */
export interface DeviceName {
  /** The shortest word for it: the robot, else the microcomputer; of several devices their number. */
  readonly name: ComputedRef<string>;
  /** Robot and microcomputer. */
  readonly full: ComputedRef<string>;
  readonly hasRobot: ComputedRef<boolean>;
}

export function useDeviceName(app: Parameters<typeof useDevice>[0]): DeviceName {
  const { name: board, hardware }: DeviceModel = useDevice(app);
  const robot = computed(() => hardware.value?.robot?.name);
  const { hasSeveral, devices } = app.work;
  const full = computed(() => [robot.value ?? [], board.value].flat().join(', '));
  const count = computed(() => t(words.count, { count: devices.value.length }));
  return {
    name: computed(() => (hasSeveral.value ? count.value : (robot.value ?? board.value))),
    full: computed(() => (hasSeveral.value ? `${count.value}, ${full.value}` : full.value)),
    hasRobot: computed(() => robot.value !== undefined),
  };
}
