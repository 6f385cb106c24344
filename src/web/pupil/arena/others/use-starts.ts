import { shallowRef, watch, type ShallowRef } from 'vue';

import type { RobotStart } from '#scene/scene';
import { runSetup } from '../../../session/work/run-setup';
import type { WorkParts } from '../../../session/work/model/parts';

/**
 * Start of the robot of each device, by its place; `null` without a robot; empty for a single device and for an
 * impossible run.
 */
export type RobotStarts = readonly (RobotStart | null)[];

/**
 * The starts of several devices. The code that finds them is loaded with the second device; one device has the start of
 * the course.
 */
export function useStarts(parts: WorkParts): Readonly<ShallowRef<RobotStarts>> {
  const { work, settings } = parts;
  const starts = shallowRef<RobotStarts>([]);
  async function find(): Promise<void> {
    if (!work.hasSeveral.value) {
      starts.value = [];
      return;
    }
    const asked = work.work.value;
    const { fitDevices } = await import('#simulation/fit-devices');
    if (asked !== work.work.value) return; // it has changed again: compute it once more
    const fitted = fitDevices(runSetup(parts, () => []));
    const found =
      'problem' in fitted ? [] : fitted.devices.map(({ hardware, start }) => (hardware.robot === null ? null : start));
    if (JSON.stringify(found) !== JSON.stringify(starts.value)) starts.value = found;
  }
  watch(
    [work.work, settings.current],
    () => void find().catch(() => undefined), // without a connection the next change tries again
    { immediate: true },
  );
  return starts;
}
