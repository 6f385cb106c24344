import type { Extension } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

import type { Brought } from './bring-names';
import { insertion } from './insert';

/** The media type of a dragged command: no other page and no other program takes it for something else. */
const KIND = 'application/x-parcours-command';

/** Puts a command into the data of a drag. */
export function putCommand(data: DataTransfer, brought: Brought): void {
  data.setData(KIND, JSON.stringify(brought));
  data.effectAllowed = 'copy';
}

/** The editor takes commands that are dropped on it. */
export const commandDrop: Extension = EditorView.domEventHandlers({
  dragover(event) {
    if (event.dataTransfer?.types.includes(KIND) !== true) return false;
    event.dataTransfer.dropEffect = 'copy';
    event.preventDefault();
    return true;
  },
  drop(event, view) {
    const text = event.dataTransfer?.getData(KIND) ?? '';
    if (text === '') return false;
    event.preventDefault();
    const at = view.posAtCoords({ x: event.clientX, y: event.clientY }, false);
    const box = view.coordsAtPos(at);
    const isUpper = box !== null && event.clientY < (box.top + box.bottom) / 2;
    view.dispatch(insertion(view.state, JSON.parse(text) as Brought, { at, isUpper }));
    view.focus();
    return true;
  },
});
