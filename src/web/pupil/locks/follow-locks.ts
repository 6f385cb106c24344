import { shallowRef, watch } from 'vue';

import { locksOf } from '#check/task/read-task';
import { isSame } from '#core/same';
import type { Stop } from '#core/stop';
import type { Carried } from '#project/project';

import { t } from '../../kit/i18n';
import { lateModel } from '../../kit/state/late-models';
import type { PageParts } from '../../kit/parts';
import type { WorkParts } from '../../session/work/model/parts';
import words from './words';
import { mainText } from './main-text';
import { followLines } from './follow-lines';

/** The texts of locked lines that are gone from the start program since the task was opened. */
export const lostLocks = lateModel(() => shallowRef<readonly string[]>([]));

/** Keeps the locks on the lines of a task that is being made, while its start program goes on being written. */
export function followLocks(app: Pick<PageParts, 'notices' | 'late'> & Pick<WorkParts, 'work'>): Stop {
  const { work, notices } = app;
  const lost = lostLocks(app);
  const stop = watch(
    () => work.work.value.project,
    (now, before) => {
      const { task } = now;
      if (task === undefined || before.task === undefined) return;
      if (task !== before.task) {
        if (!isSame(task['locks'], before.task['locks'])) lost.value = [];
        return;
      }
      const { lines } = locksOf(task);
      const [text, textBefore] = [mainText(now), mainText(before)];
      if (text === textBefore || lines.length + lost.value.length === 0) return;
      const followed = followLines(textBefore, text, lines, lost.value);
      if (!isSame(followed.lines, lines)) work.setTask(withLines(task, followed.lines));
      const isNew = followed.lost.length > lost.value.length;
      lost.value = followed.lost;
      if (isNew) tell();
    },
    { flush: 'sync' },
  );
  return () => {
    stop();
    lost.value = [];
  };

  function tell(): void {
    const [line = ''] = lost.value;
    const text = t(words.lost, { line: line.trim() });
    notices.show({ kind: 'info', key: 'notice.text', values: { text }, holds: () => lost.value.includes(line) });
  }
}

function withLines(task: Carried, lines: readonly number[]): Carried {
  const { lines: _, ...others } = (task['locks'] ?? {}) as { readonly lines?: unknown };
  return { ...task, locks: lines.length > 0 ? { ...others, lines } : others };
}
