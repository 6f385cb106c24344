import { lateParts } from '../../../kit/part';
import { usePage } from '../../../kit/parts';
import type { WithLate } from '../../../kit/state/late-models';
import { useLayout, type LayoutParts } from '../../../session/layout/parts';
import { useMode, type ModeParts } from '../../../session/mode/parts';
import { useRun, type RunParts } from '../../../session/run/parts';
import { useWork, type WorkParts } from '../../../session/work/model/parts';
import { createCourseEditor, type CourseEditorModel } from './course-editor-model';
import { createEditorPanels, type EditorPanels } from './editor-panels';

/** The course editor and its windows. */
export interface CourseEditorParts {
  readonly editor: CourseEditorModel;
  readonly panels: EditorPanels;
}

/** The models that the editor needs. */
type Around = WorkParts & ModeParts & Pick<RunParts, 'run' | 'runStart'> & Pick<LayoutParts, 'layout'> & WithLate;

export const [courseEditorOf, useCourseEditor] = lateParts(
  () => ({ ...usePage(), ...useWork(), ...useRun(), ...useLayout(), ...useMode() }),
  ({ work, settings, run, runStart, layout, mode }: Around): CourseEditorParts => ({
    editor: createCourseEditor({ work, mode, runStart, isActive: run.isActive }),
    panels: createEditorPanels({ work, layout, settings, mode }),
  }),
);
