import { computed, type ComputedRef } from 'vue';

import type { CourseEditorParts } from '../course-editor/state/parts';
import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';

type Around = Pick<WorkParts, 'work'> & Pick<RunParts, 'run'> & Pick<CourseEditorParts, 'editor'>;

/** Who is told of what is not right with the course. */
export function useToldProblems({ work, run, editor }: Around): {
  /** The course was changed, or a tool for it is chosen. */
  readonly hasEdited: ComputedRef<boolean>;
  /** Also true for a course of somebody's own that was only opened, until it runs: ready courses need no warning. */
  readonly isTold: ComputedRef<boolean>;
} {
  const hasEdited = computed(() => work.canUndo.value || work.canRedo.value || editor.tool.value !== 'hand');
  const isOwn = computed(() => work.work.value.project.course === null);
  return { hasEdited, isTold: computed(() => hasEdited.value || (isOwn.value && !run.isActive.value)) };
}
