import { watch } from 'vue';

import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import type { TaskLocks } from '../../session/work/model/task-locks';
import words from './words';

/** Removes from messages the offers of what is locked: another start in a locked course, a tool that is missing. */
export function removeLockedOffers(
  { notices }: Pick<PageParts, 'notices'>,
  task: Pick<TaskLocks, 'locks' | 'hasTool'>,
): void {
  watch(
    notices.current,
    (notice) => {
      if (notice?.action !== undefined && notice.key === 'notice.handRobot' && task.locks.course) {
        const { action: _, ...plain } = notice;
        notices.show(plain);
      } else if (notice?.key === 'notice.handBlock' && !task.hasTool('select'))
        notices.show({ ...notice, key: 'notice.text', values: { text: t(words.backAtStart) } });
    },
    { flush: 'sync' },
  );
}
