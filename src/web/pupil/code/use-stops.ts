import { Compartment, type Extension } from '@codemirror/state';
import { keymap, lineNumbers, type EditorView } from '@codemirror/view';
import { watch, type ShallowRef } from 'vue';

import { fileKey } from '../debug/file-key';
import { useDebug } from '../debug/parts';
import type { WorkParts } from '../../session/work/model/parts';

/**
 * Break points beside the line numbers, and the line where the program is halted. A press on a number sets one, F9 at
 * the cursor; the code for them is loaded with the first.
 *
 * @returns the column of line numbers for a file, and a function to call when another file is shown
 */
export function useStops(
  { work }: Pick<WorkParts, 'work'>,
  view: Readonly<ShallowRef<EditorView | null>>,
): { column: Extension; show(): void } {
  const { slot } = useDebug();
  const place = new Compartment();
  const key = (): string => fileKey(work.work.value.project, work.place.value, work.open.value.name);

  function toggle(editor: EditorView, from: number): true {
    const { number } = editor.state.doc.lineAt(from);
    const file = key(); // the debugger may come late, when another file is shown
    slot.need((debug) => debug.points.toggle(file, number));
    return true;
  }
  /** The place that was shown last. */
  let stood: unknown = null;
  function show(): void {
    const debug = slot.debug.value;
    const editor = view.value;
    if (debug === null || editor === null || slot.marks === null) return;
    const { stopMarks, showStopsCalmly } = slot.marks;
    if (isEmpty(place.get(editor.state))) {
      const onMove = (lines: readonly number[]): void => debug.points.set(key(), lines);
      editor.dispatch({ effects: place.reconfigure(stopMarks(onMove, (name) => debug.valueOf(name))) });
    }
    const at = debug.here.value;
    // Who writes while it stands is not taken away from where they write.
    const isNew = stood !== debug.place.value;
    stood = debug.place.value;
    showStopsCalmly(editor, debug.points.of(key()), at?.file === work.open.value.name ? at.line : null, isNew);
  }
  const shown = (): unknown[] => [view.value, slot.debug.value?.points.lines.value, slot.debug.value?.here.value];
  watch(shown, show, { flush: 'post' });
  const column = [
    place.of([]),
    lineNumbers({ domEventHandlers: { mousedown: (editor, { from }) => toggle(editor, from) } }),
    keymap.of([{ key: 'F9', run: (editor) => toggle(editor, editor.state.selection.main.head) }]),
  ];
  return { column, show };
}

const isEmpty = (extension: Extension | undefined): boolean => Array.isArray(extension) && extension.length === 0;
