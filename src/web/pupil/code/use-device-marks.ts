import { computed, watch, type ComputedRef } from 'vue';

import { filesByName } from '#project/project';
import type { Hardware } from '#simulation/hardware';
import type { WorkParts } from '../../session/work/model/parts';
import { deviceAt } from '../../session/work/hardware/device-at';
import { AUTO_DEVICE, deviceName } from '../../session/work/settings/devices';
import { isAsFound } from '../../session/work/catalogue/first-course';
import type { DeviceMarksOptions, DeviceQuestion } from './device-question';

/** The options of the marks for each file: for the microcomputer that is chosen now, and its firmware. */
export function useDeviceMarks(
  parts: WorkParts,
  hardware: ComputedRef<Hardware | null>,
): (file: string) => DeviceMarksOptions {
  const { work, settings } = parts;
  const board = computed(() => deviceName(deviceAt(parts).settings.device, hardware.value?.board));
  const key = computed(() => [board.value, hardware.value?.firmware.id, settings.current.value.deviceCheck].join());
  const question = (file: string): DeviceQuestion | null => {
    const firmware = hardware.value?.firmware;
    if (firmware === undefined || !settings.current.value.deviceCheck) return null;
    const files = filesByName(work.files.value.filter(({ name }) => name !== file));
    const written = () => ({ hardware: hardware.value, files: work.files.value, file });
    return { file, files, device: firmware, board: board.value, language: settings.current.value.language, written };
  };
  // Our own programs have nothing to mark: a first visit need not fetch the check.
  const isOurs = (): boolean => settings.current.value.device === AUTO_DEVICE && isAsFound(work.work.value.project);
  return (file) => ({
    question: () => question(file),
    isOurs,
    onChange: (listener) => watch(key, listener),
  });
}
