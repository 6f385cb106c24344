import type { Vec } from '#core/geometry';
import { turnedByEighths } from '#editor/arrange';
import { grouped, locked, ungrouped, unlocked } from '#editor/arranging/hold';
import { aligned, distributed, type Alignment } from '#editor/arranging/align';
import { mirrored } from '#editor/arranging/mirror';
import { reordered, type Order } from '#editor/arranging/order';
import { sizedAlike } from '#editor/arranging/same-size';
import { clipOf, clipText } from '#editor/clip-text';
import { copied, duplicated, pasted, type Clip, type Pasted } from '#editor/clipboard';
import { removed, selectAll } from '#editor/selection';
import { nothingSelected, type Selection, type ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';

import type { CourseEditorModel } from './course-editor-model';

/** The course that the acts work on. */
export type ActsCourse = Pick<ToolContext, 'scene' | 'footprint'>;

/** Everything that can be done to what is selected. Each is one edit; it does nothing where there is nothing to do. */
export type SelectionActs = ReturnType<typeof createSelectionActs>;

/** The part of the editor that the acts use. */
export type ActsEditor = Pick<
  CourseEditorModel,
  'selection' | 'select' | 'commit' | 'choose' | 'clipboard' | 'pointer' | 'tell'
>;

export function createSelectionActs(editor: ActsEditor, course: () => ActsCourse) {
  const { clipboard } = editor;
  const scene = () => course().scene;
  const selection = () => editor.selection.value;
  const commit = (edit: SceneEdit | null): void => {
    if (edit !== null) editor.commit(edit);
  };
  const insert = (made: Pasted | null): void => {
    if (made === null) return;
    editor.choose('select');
    editor.commit(made.edit, made.selection);
  };
  const remove = (): void => {
    const edit = removed(scene(), selection());
    if (edit !== null) editor.commit(edit, nothingSelected);
  };
  const take = (): boolean => {
    const clip = copied(scene(), selection());
    if (clip !== null) clipboard.take(clip, clipText(clip));
    return clip !== null;
  };
  const insertClip = (clip: Clip | null, at: Vec | null): void =>
    insert(clip && pasted(scene(), clip, at, course().footprint));
  return {
    copy: (): void => {
      if (take()) editor.tell({ type: 'copied' });
    },
    cut: (): void => {
      if (take()) remove();
    },
    /** Pastes what was copied here: at a place, or where the pointer is, or where it came from. */
    paste: (at = editor.pointer.value): void => insertClip(clipboard.clip, at),
    /** The same with a text of the system's clipboard. @returns whether it holds objects */
    pasteText: (text: string, at = editor.pointer.value): boolean => {
      const clip = clipOf(text);
      insertClip(clip, at);
      return clip !== null;
    },
    /** Puts objects into the course: with their middle at a place, or beside what is in the way there. */
    insert: insertClip,
    duplicate: (): void => {
      const made = duplicated(scene(), selection(), clipboard.copies, course().footprint);
      insert(made);
      clipboard.copies = made?.copies ?? clipboard.copies;
    },
    remove,
    /** Turns what is selected by eighths of a full turn, counter-clockwise. */
    turn: (eighths: number): void => commit(turnedByEighths(scene(), selection(), eighths, course().footprint)),
    selectAll: (): void => {
      editor.choose('select');
      editor.select(selectAll(scene(), course().footprint.length > 0));
    },
    ...arranging(selection, course, commit),
  };
}

/** Acts that change the selected things' arrangement, and their locks and groups. */
const arranging = (selection: () => Selection, course: () => ActsCourse, commit: (edit: SceneEdit | null) => void) => ({
  reorder: (order: Order): void => commit(reordered(course().scene, selection(), order)),
  align: (to: Alignment): void => commit(aligned(course().scene, selection(), to, course().footprint)),
  distribute: (axis: 'x' | 'y'): void => commit(distributed(course().scene, selection(), axis, course().footprint)),
  mirror: (axis: 'x' | 'y'): void => commit(mirrored(course().scene, selection(), axis, course().footprint)),
  group: (): void => commit(grouped(course().scene, selection())),
  ungroup: (): void => commit(ungrouped(course().scene, selection())),
  lock: (): void => commit(locked(course().scene, selection())),
  unlock: (): void => commit(unlocked(course().scene, selection())),
  sizeAlike: (): void => commit(sizedAlike(course().scene, selection())),
});
