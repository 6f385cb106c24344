import { NO_ROBOT } from '#simulation/run-setup';

import { hardwareNow } from '../../work/hardware/use-hardware';
import type { WorkParts, Workplace } from '../../work/model/parts';
import type { LayoutParts } from '../parts';
import { hasNothingOwn, useCourses } from '../../work/use-courses';
import { useDevice } from '../../work/hardware/use-device';
import { boardPrograms } from '../../work/catalogue/board-programs';
import { firstCourse } from '../../work/catalogue/first-course';
import { sightOf, type Stage } from './stage';

/**
 * Brings a stage into sight. Where nothing of the pupil's own is open, a program that fits comes along: one for the board
 * alone, or the first course. What they have written stays. A greeting
 * that is still there has its answer by that.
 */
export function changeStage(app: Workplace & Pick<LayoutParts, 'layout'>, stage: Stage): void {
  if (stage === 'board') leaveArena(app);
  else enterArena(app);
  app.settings.change({ ...sightOf(stage), welcomed: true });
  app.layout.tab.value = stage === 'board' ? 'code' : 'arena';
}

const isUntouched = ({ work }: Pick<WorkParts, 'work'>): boolean => hasNothingOwn(work.work.value.project);

/** Opens a program that needs no robot, unless something of the pupil's own is open or there is no robot anyway. */
function leaveArena(app: Workplace): void {
  const [first] = boardPrograms;
  if (first === undefined || !isUntouched(app) || hardwareNow(app)?.robot === null) return;
  useCourses(app).openBoardProgram(first);
}

/**
 * Brings a robot back where the board was alone: with the first course, unless something of the pupil's own is open.
 */
function enterArena(app: Workplace): void {
  if (app.settings.current.value.robot !== NO_ROBOT) return;
  if (isUntouched(app) && firstCourse !== undefined) useCourses(app).openCourse(firstCourse);
  else useDevice(app).allowRobot();
}
