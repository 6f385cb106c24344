import { EditorState, type Extension } from '@codemirror/state';
import { watch } from 'vue';

import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import type { LayoutParts } from '../../session/layout/parts';
import { examOf } from '../../session/task/exam/exam-model';
import words from '../../session/task/exam/words';
import type { TaskParts } from '../../session/task/parts';
import type { WorkParts } from '../../session/work/model/parts';

/** The models that an exam needs. */
export type ExamPage = Pick<PageParts, 'notices' | 'late'> &
  Pick<WorkParts, 'work'> &
  TaskParts &
  Pick<LayoutParts, 'router'>;

/**
 * Holds an exam of a task that was handed out: while it runs, no page lies over the work, and when its time is over the
 * window opens in which it is handed in.
 */
export function holdExam(app: ExamPage): void {
  const { state } = examOf(app);
  const { router, task, notices } = app;
  watch(
    [state, router.page],
    ([now, page]) => {
      if (now !== 'running' || page === null) return;
      router.close();
      notices.show({ kind: 'info', key: 'notice.text', values: { text: t(words.noPages) } });
    },
    { immediate: true },
  );
  watch(state, (now, before) => {
    if (now === 'over' && before === 'running') task.handIn.open();
  });
}

/** Why the program of an exam cannot be changed now, in words; `null`: it can. */
export function examRefuses(app: Pick<ExamPage, 'late' | 'work'>): string | null {
  const { state } = examOf(app);
  if (state.value === 'waiting') return t(words.notYet);
  return state.value === 'over' ? t(words.closed) : null;
}

/** Refuses changes in the editor before and after an exam. */
export const closedByExam = (app: Pick<ExamPage, 'late' | 'work'>, tell: (text: string) => void): Extension =>
  EditorState.transactionFilter.of((change) => {
    const why = change.docChanged ? examRefuses(app) : null;
    if (why === null) return change;
    tell(why);
    return [];
  });
