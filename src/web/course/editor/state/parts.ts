import { part } from '../../../kit/part';
import type { CourseEditorModel } from './course-editor-model';
import type { EditorPanels } from './editor-panels';

/** The course editor and its windows. */
export interface CourseEditorParts {
  readonly editor: CourseEditorModel;
  readonly panels: EditorPanels;
}

export const [provideCourseEditor, useCourseEditor] = part<CourseEditorParts>('course editor');
