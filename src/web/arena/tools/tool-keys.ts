import type { Vec } from '#core/geometry';
import { nudged, turned } from '#editor/arrange';
import { copied, duplicated, pasted, type Pasted } from '#editor/clipboard';
import { countOf, removed, selectAll } from '#editor/selection';
import { nothingSelected, type Selection, type ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';

import type { Clipboard } from '../../course-editor/state/clipboard';

/** Movement per press of an arrow key, and with Shift; mm. Chosen: a line of the grid, the smallest whole step. */
export const STEP_MM = { coarse: 10, fine: 1 };

/** What keys do to what is selected. */
export interface SelectionKeys {
  /**
   * A key goes down.
   *
   * @param command whether Ctrl or ⌘ is down
   * @returns whether it was used
   */
  keyDown(key: string, fine: boolean, command: boolean): boolean;
  /** A key goes up: what the arrows have moved is one step. */
  keyUp(key: string): void;
  /** What the arrows have moved so far, or `null`. */
  readonly edit: SceneEdit | null;
}

/** What the keys work on. */
export interface SelectionKeyPorts {
  readonly context: () => ToolContext;
  readonly commit: (edit: SceneEdit, select?: Selection) => void;
  readonly select: (selection: Selection) => void;
  readonly clipboard: Clipboard;
  /** What is selected was copied: nothing looks different. */
  readonly copied: () => void;
  /** Something looks different now. */
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

/** Makes the keys: arrows, Q and E, Delete, and Ctrl with A, C, X, V, D. */
export function createSelectionKeys(ports: SelectionKeyPorts): SelectionKeys {
  const nudges = createNudges(ports);
  return {
    get edit() {
      return nudges.edit;
    },
    keyDown(key, fine, command) {
      const context = ports.context();
      if (command) return commandKey(key.toLowerCase(), context, ports);
      if (countOf(context.selection) === 0) return false;
      const arrow = arrowOf(key);
      if (arrow !== null) nudges.by(arrow, fine);
      else if (key === 'Delete' || key === 'Backspace') remove(context, ports);
      else return turnKey(key.toLowerCase(), context, ports);
      return true;
    },
    keyUp(key) {
      if (arrowOf(key) !== null) nudges.letGo();
    },
  };
}

/** What arrow keys move from the first press to letting go is one step. */
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

function commandKey(key: string, context: ToolContext, ports: SelectionKeyPorts): boolean {
  const { scene, selection, footprint } = context;
  switch (key) {
    case 'a':
      ports.select(selectAll(scene, footprint.length > 0));
      return true;
    case 'c':
    case 'x':
      return copy(context, ports, key === 'x');
    case 'v':
      return paste(scene, ports);
    case 'd':
      if (selection.ids.length === 0) return false;
      insert(duplicated(scene, selection), ports);
      return true;
    default:
      return false;
  }
}

function copy(context: ToolContext, ports: SelectionKeyPorts, cuts: boolean): boolean {
  const taken = copied(context.scene, context.selection);
  if (taken === null) return false;
  ports.clipboard.take(taken);
  if (cuts) remove(context, ports);
  else ports.copied();
  return true;
}

function paste(scene: Scene, ports: SelectionKeyPorts): boolean {
  const next = ports.clipboard.next();
  if (next === null) return false;
  insert(pasted(scene, next.clip, next.time), ports);
  return true;
}

function insert(made: Pasted | null, { commit }: SelectionKeyPorts): void {
  if (made !== null) commit(made.edit, made.selection);
}

function remove({ scene, selection }: ToolContext, { commit }: SelectionKeyPorts): void {
  const gone = removed(scene, selection);
  if (gone !== null) commit(gone, nothingSelected);
}

/** Q turns to the left by an eighth, E to the right. */
function turnKey(key: string, { scene, selection, footprint }: ToolContext, { commit }: SelectionKeyPorts): boolean {
  if (key !== 'q' && key !== 'e') return false;
  const done = turned(scene, selection, key === 'q' ? 1 : -1, footprint);
  if (done !== null) commit(done);
  return true;
}
