import { indentLess, indentMore } from '@codemirror/commands';
import type { Extension } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { shallowRef, type ShallowRef } from 'vue';

/** The Tab key in the program: it leads on until something was typed there, and only then it indents. */
export interface TabKey {
  /** True while the program has been reached by the keyboard: then it says how the keyboard leaves it. */
  readonly isReached: Readonly<ShallowRef<boolean>>;
  readonly extension: Extension;
}

/**
 * Makes the Tab key of an editor. A press into the program counts as typing: who marks lines with the mouse wants to indent
 * them. Escape makes Tab lead on again, until the next letter.
 */
export function createTabKey(): TabKey {
  const isReached = shallowRef(false);
  let isHere = false;
  let isUsed = false;
  let hasHeardKey = false;
  const indents =
    (indent: typeof indentMore): typeof indentMore =>
    (target) =>
      isUsed && indent(target);
  const extension = [
    keymap.of([
      { key: 'Tab', run: indents(indentMore), shift: indents(indentLess) },
      { key: 'Escape', run: () => (isUsed = false) },
    ]),
    EditorView.updateListener.of(({ docChanged }) => {
      if (docChanged && isHere) isUsed = true;
    }),
    EditorView.domEventHandlers({
      pointerdown() {
        isUsed = hasHeardKey = true;
        isReached.value = false;
      },
      keydown() {
        hasHeardKey = true;
      },
      // A key that was pressed elsewhere and is let go here has brought the keyboard here.
      keyup() {
        if (!hasHeardKey) isReached.value = true;
        hasHeardKey = true;
      },
      focus() {
        isHere = true;
      },
      blur() {
        isHere = isUsed = hasHeardKey = isReached.value = false;
      },
    }),
  ];
  return { isReached, extension };
}
