import { turned } from '#editor/arrange';
import { duplicated } from '#editor/clipboard';
import { removed, selectAll } from '#editor/selection';
import { nothingSelected } from '#editor/tools/tool';

import { useHardware } from '../../work/hardware/use-hardware';
import type { WorkParts } from '../../work/model/parts';
import type { CourseEditorParts } from './parts';

/** What can be done with what is selected in the arena. */
export function useSelectionActs(app: WorkParts & Pick<CourseEditorParts, 'editor'>) {
  const { editor, work } = app;
  const hardware = useHardware(app);
  const footprint = () => hardware.value?.robot?.body.outlineMm ?? [];

  return {
    duplicate: (): void => {
      const made = duplicated(work.scene.value, editor.selection.value);
      if (made === null) return;
      editor.choose('select');
      editor.commit(made.edit, made.selection);
    },
    remove: (): void => {
      const edit = removed(work.scene.value, editor.selection.value);
      if (edit !== null) editor.commit(edit, nothingSelected);
    },
    /** Eighths of a turn, counter-clockwise. */
    turn: (eighths: number): void => {
      const edit = turned(work.scene.value, editor.selection.value, eighths, footprint());
      if (edit !== null) editor.commit(edit);
    },
    selectAll: (): void => {
      editor.choose('select');
      editor.select(selectAll(work.scene.value, footprint().length > 0));
    },
  };
}
