import { turned } from '#editor/arrange';
import { copied, duplicated, pasted, type Pasted } from '#editor/clipboard';
import { removed, selectAll } from '#editor/selection';
import { nothingSelected } from '#editor/tools/tool';

import { useHardware } from '../../work/hardware/use-hardware';
import type { WorkParts } from '../../work/model/parts';
import type { CourseEditorParts } from './parts';

/** The actions for what is selected in the arena. */
export function useSelectionActs(app: WorkParts & Pick<CourseEditorParts, 'editor'>) {
  const { editor, work } = app;
  const hardware = useHardware(app);
  const footprint = () => hardware.value?.robot?.body.outlineMm ?? [];

  const insert = (made: Pasted | null): void => {
    if (made === null) return;
    editor.choose('select');
    editor.commit(made.edit, made.selection);
  };
  const remove = (): void => {
    const edit = removed(work.scene.value, editor.selection.value);
    if (edit !== null) editor.commit(edit, nothingSelected);
  };
  const copy = (): void => {
    const clip = copied(work.scene.value, editor.selection.value);
    if (clip !== null) editor.clipboard.take(clip);
  };

  return {
    copy,
    cut: (): void => {
      copy();
      remove();
    },
    paste: (): void => {
      const next = editor.clipboard.next();
      if (next !== null) insert(pasted(work.scene.value, next.clip, next.time));
    },
    duplicate: (): void => insert(duplicated(work.scene.value, editor.selection.value)),
    remove,
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
