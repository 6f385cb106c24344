import { computed, type ComputedRef } from 'vue';

import type { CourseEditorParts } from '../course-editor/state/parts';
import type { WorkParts } from '../work/model/parts';

type Around = Pick<WorkParts, 'work'> & Pick<CourseEditorParts, 'editor'>;

/** Who is told of what is not right with the course. */
export function useToldProblems({ work, editor }: Around): {
  /** The course was changed, or a tool for it is chosen. */
  readonly hasEdited: ComputedRef<boolean>;
  /** Also true for a course of somebody's own that was only opened. Ready courses are checked before they come here. */
  readonly isTold: ComputedRef<boolean>;
  /** To who only opened it, it is told by a sign alone. */
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
