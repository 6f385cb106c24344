import { useHardware } from '../../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../../session/work/model/parts';
import type { CourseEditorParts } from './parts';
import { createSelectionActs, type SelectionActs } from './selection-acts';

/** The actions for what is selected in the arena. */
export function useSelectionActs(app: WorkParts & Pick<CourseEditorParts, 'editor'>): SelectionActs {
  const hardware = useHardware(app);
  return createSelectionActs(app.editor, () => ({
    scene: app.work.scene.value,
    footprint: hardware.value?.robot?.body.outlineMm ?? [],
  }));
}
