import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import type { SceneEdit } from '#scene/edit';
import type { RuleProblem } from '#scene/rules';

import type { PageParts } from '../../kit/parts';
import { useHardware } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import type * as Problems from './panels/told-problems';
import type { CourseEditorParts } from './state/parts';

type App = WorkParts & Pick<CourseEditorParts, 'editor'> & Pick<PageParts, 'notices'>;

/** How long to wait after the last change, in ms, so that half-finished work is not reported. */
const SETTLED_MS = 400;

/** The things in a course that are probably mistakes, in words, with what mends them. */
export interface CourseProblems {
  readonly problems: ComputedRef<readonly Problems.ToldProblem[]>;
  /** Mends all that can be mended by itself; `null`: fewer than two. */
  readonly all: ComputedRef<Problems.ToldProblem['mend']>;
  mend(edit: SceneEdit): void;
  /** Selects the things of a problem where things are being selected, and finds its place, in world mm. */
  placeOf(index: number): { readonly x: number; readonly y: number } | null;
}

/**
 * Finds them while they may be told: not in ready-made courses, which are checked before they are published, and not
 * while the open task locks the course, so that nobody could mend them.
 */
export function useCourseProblems(app: App): CourseProblems {
  const { work, editor } = app;
  const hardware = useHardware(app);
  const footprint = computed(() => hardware.value?.robot?.body.outlineMm ?? []);
  const found = shallowRef<readonly RuleProblem[]>([]);
  const late: ShallowRef<typeof Problems | null> = shallowRef(null);
  const isOwn = (): boolean => work.canUndo.value || work.canRedo.value || work.work.value.project.course === null;
  const mayTell = (): boolean => isOwn() && !work.locks.isLocked('course');
  /** Checks the course. The checker is loaded on demand: a ready-made course that is only driven never needs it. */
  async function find(): Promise<void> {
    late.value ??= await import('./panels/told-problems').catch(() => null); // offline: the next edit tries again
    if (mayTell()) found.value = late.value?.problemsOf(work.scene.value, footprint.value) ?? [];
  }
  let timer: ReturnType<typeof setTimeout> | undefined;
  watch(
    [work.scene, footprint, mayTell],
    () => {
      clearTimeout(timer);
      if (mayTell()) timer = setTimeout(() => void find(), SETTLED_MS);
      else found.value = [];
    },
    { immediate: true },
  );
  watch(editor.problem, (problem) => {
    if (problem !== null) app.notices.show({ kind: 'warn', key: 'notice.courseFull' });
  });
  /** Without those of things that have just been removed: nobody waits for the next check. */
  const there = computed(() => {
    const ids = new Set(work.scene.value.objects.map(({ id }) => id));
    return found.value.filter((problem) => idsIn(problem).every((id) => ids.has(id)));
  });
  const about = () => [work.scene.value, footprint.value] as const;
  return {
    problems: computed(() => there.value.flatMap((problem) => late.value?.told(problem, ...about()) ?? [])),
    all: computed(() => late.value?.toldMendOfAll(there.value, ...about()) ?? null),
    mend: (edit) => void editor.commit(edit),
    placeOf(index) {
      const problem = there.value[index];
      if (problem === undefined) return null;
      const ids = new Set(work.scene.value.objects.map(({ id }) => id));
      if (editor.tool.value === 'select')
        editor.select({ ids: problem.ids.filter((id) => ids.has(id)), robot: problem.ids.length === 0 });
      const [x, y] = problem.at;
      return { x, y };
    },
  };
}

const idsIn = ({ ids, params: { id, other } }: RuleProblem): readonly string[] =>
  [...ids, id, other].filter((name) => typeof name === 'string');
