import type { Vec } from '#core/geometry';
import { nudged } from '#editor/arrange';
import { handlePointRemoved } from '#editor/handle-drag';
import { countOf } from '#editor/selection';
import type { Selection, ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';

import type { SelectionActs } from '../../../course/editor/state/selection-acts';

/** Movement per press of an arrow key, and with Shift; mm. Chosen: a line of the grid, the smallest whole step. */
export const STEP_MM = { coarse: 10, fine: 1 };

/** The effects of keys on the selection. */
export interface SelectionKeys {
  /**
   * Handles a key that is pressed.
   *
   * @param command whether Ctrl or ⌘ is down
   * @returns whether it was used
   */
  keyDown(key: string, fine: boolean, command: boolean): boolean;
  /** Handles a key that is released: the moves by the arrows become one step. */
  keyUp(key: string): void;
  /** The moves by the arrows so far, or `null`. */
  readonly edit: SceneEdit | null;
}

/** The surroundings of the keys. */
export interface SelectionKeyPorts {
  readonly context: () => ToolContext;
  readonly commit: (edit: SceneEdit, select?: Selection) => void;
  readonly acts: Pick<SelectionActs, 'selectAll' | 'duplicate' | 'group' | 'ungroup' | 'remove' | 'turn'>;
  /** Place of the mouse or of the keyboard's crosshair, and the distance that counts as on a handle; `null`: none. */
  readonly pointed: () => { readonly at: Vec; readonly reachMm: number } | null;
  /** Called when the picture has changed. */
  readonly changed: () => void;
}

/** The direction of an arrow key, or `null`. */
export function arrowOf(key: string): Vec | null {
  if (key === 'ArrowLeft') return { x: -1, y: 0 };
  if (key === 'ArrowRight') return { x: 1, y: 0 };
  if (key === 'ArrowUp') return { x: 0, y: 1 };
  if (key === 'ArrowDown') return { x: 0, y: -1 };
  return null;
}

/** Makes the keys: arrows, Q and E, Delete, and Ctrl with A, D and G. The clipboard has keys on the whole page. */
export function createSelectionKeys(ports: SelectionKeyPorts): SelectionKeys {
  const { acts } = ports;
  const nudges = createNudges(ports);
  return {
    get edit() {
      return nudges.edit;
    },
    keyDown(key, fine, command) {
      const { selection } = ports.context();
      const letter = key.toLowerCase();
      if (command && letter === 'a') acts.selectAll();
      else if (command && letter === 'd' && selection.ids.length > 0) acts.duplicate();
      else if (command && letter === 'g' && selection.ids.length > 0) acts[fine ? 'ungroup' : 'group']();
      else if (command || countOf(selection) === 0) return false;
      else return onSelected(key, letter, fine);
      return true;
    },
    keyUp(key) {
      if (arrowOf(key) !== null) nudges.letGo();
    },
  };

  function onSelected(key: string, letter: string, fine: boolean): boolean {
    const arrow = arrowOf(key);
    if (arrow !== null) nudges.by(arrow, fine);
    else if (key === 'Delete' || key === 'Backspace') {
      if (!removePoint(ports)) acts.remove();
    } else if (letter === 'q' || letter === 'e') acts.turn(letter === 'q' ? 1 : -1);
    else return false;
    return true;
  }
}

/** Removes only the point of a selected thing that is pointed at. */
function removePoint({ context, commit, pointed }: SelectionKeyPorts): boolean {
  const place = pointed();
  const done = place && handlePointRemoved(context(), place.at, place.reachMm);
  if (done) commit(done);
  return done !== null;
}

/** Moves by arrow keys, from the first press to the release, are one step. */
function createNudges({ context, commit, changed }: SelectionKeyPorts) {
  let by: Vec = { x: 0, y: 0 };
  let begun: ToolContext | null = null;
  let edit: SceneEdit | null = null;
  return {
    get edit() {
      return edit;
    },
    by(arrow: Vec, fine: boolean): void {
      begun ??= context();
      const step = fine ? STEP_MM.fine : STEP_MM.coarse;
      by = { x: by.x + arrow.x * step, y: by.y + arrow.y * step };
      edit = nudged(begun.scene, begun.selection, by.x, by.y, begun.footprint);
      changed();
    },
    letGo(): void {
      if (begun === null) return;
      const done = edit;
      begun = null;
      edit = null;
      by = { x: 0, y: 0 };
      if (done !== null) commit(done);
      changed();
    },
  };
}
