import { computed, type ComputedRef } from 'vue';

import type { CourseEditorParts } from '../../course/editor/state/parts';
import type { WorkParts } from '../../session/work/model/parts';

type Around = Pick<WorkParts, 'work'> & Pick<CourseEditorParts, 'editor'>;

/** When and how problems of the course are shown. */
export function useToldProblems({ work, editor }: Around): {
  /** True if the course was changed, or a tool for it is chosen. */
  readonly hasEdited: ComputedRef<boolean>;
  /**
   * Also true for a user's own course that was only opened. Ready-made courses are checked before they are published.
   */
  readonly isTold: ComputedRef<boolean>;
  /** True for a course that was only opened: a sign is all that is shown. */
  readonly isQuiet: ComputedRef<boolean>;
} {
  const hasEdited = computed(() => work.canUndo.value || work.canRedo.value || editor.tool.value !== 'hand');
  const isOwn = computed(() => work.work.value.project.course === null);
  return {
    hasEdited,
    isTold: computed(() => hasEdited.value || isOwn.value),
    isQuiet: computed(() => !hasEdited.value),
  };
}
