import { shallowRef, watch, type ShallowRef } from 'vue';

import type { RobotStart } from '#scene/scene';
import { runSetup } from '../../work/run-setup';
import type { WorkParts } from '../../work/model/parts';

/** Where the robot of each device starts, by its place; `null` without a robot, and nothing for a run that cannot be. */
export type RobotStarts = readonly (RobotStart | null)[];

/** The starts of several devices. What finds them is fetched with the second device; one device's is the course's. */
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
    if (asked !== work.work.value) return; // it has changed again: asked anew
    const fitted = fitDevices(runSetup(parts, () => []));
    const found =
      'problem' in fitted ? [] : fitted.devices.map(({ hardware, start }) => (hardware.robot === null ? null : start));
    if (JSON.stringify(found) !== JSON.stringify(starts.value)) starts.value = found;
  }
  watch(
    [work.work, settings.current],
    () => void find().catch(() => undefined), // without a connection the next change asks again
    { immediate: true },
  );
  return starts;
}
