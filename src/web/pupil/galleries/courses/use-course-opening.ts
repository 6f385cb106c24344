import { computed } from 'vue';

import { importedModules } from '#python/imports';
import { AUTO, chooseHardware } from '#simulation/hardware';
import { usePage } from '../../../kit/parts';
import { useRun } from '../../../session/run/parts';
import { useWork } from '../../../session/work/model/parts';
import { useLayout } from '../../../session/layout/parts';
import { useCourses } from '../../../session/work/use-courses';
import type { Course } from '#catalogue/course';
import { withSolution } from '#catalogue/read-courses';

/** Name of the robot that a course and its solution are made for; empty if there is none. */
export function robotNameOfCourse({ scene, solution }: Course): string {
  const imports = new Set(importedModules(solution.en));
  const hardware = chooseHardware({ scene, imports, robot: AUTO, board: AUTO });
  return 'problem' in hardware ? '' : (hardware.robot?.name ?? '');
}

/** Opening courses out of the gallery, which then makes room for them. */
export function useCourseOpening() {
  const app = { ...usePage(), ...useRun(), ...useWork(), ...useLayout() };
  const { openCourse } = useCourses(app);
  const openId = computed(() => app.work.work.value.project.course);
  function open(course: Course, anew = false): void {
    app.router.close();
    openCourse(course, anew);
  }
  return {
    open: (course: Course): void => open(course),
    openSolved(course: Course): void {
      if (!app.work.locks.refuses('solution')) open(withSolution(course), true);
    },
    /** True if it is the one in the arena, changed or not; false for a random course. */
    isOpen: (course: Course): boolean => !course.isRandom && openId.value === course.id,
  };
}
