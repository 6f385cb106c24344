import { watch } from 'vue';

import { isSame } from '#core/same';

import { withTravelling } from '../../session/work/settings/travelling';
import type { WorkParts } from '../../session/work/model/parts';
import type { TaskLocks } from '../../session/work/model/task-locks';

/** The settings that are locked with the robot. */
export const OF_THE_ROBOT = ['device', 'firmware', 'robot', 'robotOptions', 'reality', 'seed', 'myRobot'] as const;

/**
 * Holds the settings that a task locks at the task's values, whatever an address, another tab or somebody in a hurry
 * has chosen.
 */
export function holdLockedSettings({ settings, work }: WorkParts, task: Pick<TaskLocks, 'locks'>): void {
  holdSpeed({ settings }, task);
  watch(
    [() => task.locks, () => work.work.value.project.settings, settings.current] as const,
    ([{ robot, hand }, brought, now]) => {
      if (brought === undefined) return;
      const kept = withTravelling(now, brought);
      // A robot that was measured here is not forgotten for a task.
      const names = [...(robot ? OF_THE_ROBOT.filter((name) => name !== 'myRobot') : []), ...(hand ? ['arenaSenses' as const] : [])]; // prettier-ignore
      const others = names.filter((name) => !isSame(kept[name], now[name]));
      if (others.length > 0) settings.bring(Object.fromEntries(others.map((name) => [name, kept[name]])));
    },
    { immediate: true, flush: 'sync' },
  );
}

function holdSpeed({ settings }: Pick<WorkParts, 'settings'>, task: Pick<TaskLocks, 'locks'>): void {
  watch(
    () => task.locks.speed,
    (kept, _, onEnd) => {
      if (kept === null) return;
      const { speed } = settings.current.value;
      const stop = watch(
        () => settings.current.value.speed,
        (now) => now !== kept && settings.hold({ speed: kept }),
        { immediate: true, flush: 'sync' },
      );
      onEnd(() => {
        stop();
        settings.hold({ speed });
      });
    },
    { immediate: true, flush: 'sync' },
  );
}
