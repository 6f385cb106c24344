import { useCourseEditor, type CourseEditorParts } from '../../course/editor/state/parts';
import { usePage, type PageParts } from '../../kit/parts';
import { useLayout, type LayoutParts } from '../../session/layout/parts';
import { useMode, type ModeParts } from '../../session/mode/parts';
import { useRun, type RunParts } from '../../session/run/parts';
import { useTask, type TaskParts } from '../../session/task/parts';
import { useWork, type WorkParts } from '../../session/work/model/parts';
import { useConsole, type ConsoleParts } from '../console/parts';

/** The models that the next step depends on and acts on. */
export type StepApp = PageParts &
  RunParts &
  WorkParts &
  LayoutParts &
  TaskParts &
  ModeParts &
  CourseEditorParts &
  ConsoleParts;

/** All of them for a component, in `setup`. */
export const useStepApp = (): StepApp => ({
  ...{ ...usePage(), ...useRun(), ...useWork(), ...useLayout(), ...useTask() },
  ...{ ...useMode(), ...useCourseEditor(), ...useConsole() },
});
