import { computed } from 'vue';

import { t } from '../../kit/i18n';
import { useHardware } from '../../session/work/hardware/use-hardware';
import type { Workplace } from '../../session/work/model/parts';
import words from './words';

/** The pupil's own robot, if one of the type in use was measured, and its name. */
export function useMyRobotInUse(app: Workplace) {
  const hardware = useHardware(app);
  const mine = computed(() => {
    const kept = app.settings.current.value.myRobot;
    return kept !== null && kept.robot === hardware.value?.robot?.id ? kept : null;
  });
  const name = computed(() => (mine.value === null || mine.value.name === '' ? t(words.myRobot) : mine.value.name));
  return { mine, name };
}
