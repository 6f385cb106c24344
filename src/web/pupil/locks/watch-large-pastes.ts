import type { Extension, Transaction } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

/** Fewest lines of a paste that is reported. Chosen: less is an example from the worksheet. */
const LEAST_LINES = 3;

/**
 * Calls `onPasted` for a paste that makes up most of the program, unless it was copied here.
 *
 * @param copied the text that was last copied or cut in an editor of this page
 */
export function watchLargePastes(copied: { text: string }, onPasted: () => void): Extension {
  const remember = (_: Event, { state }: EditorView): boolean => {
    copied.text = state.selection.ranges.map(({ from, to }) => state.sliceDoc(from, to)).join('\n');
    return false;
  };
  return [
    EditorView.domEventHandlers({ copy: remember, cut: remember }),
    EditorView.updateListener.of(({ transactions }) => {
      for (const done of transactions) {
        const text = pastedIn(done);
        if (text !== '' && text !== copied.text.trim() && isMost(text, done.newDoc.toString())) onPasted();
      }
    }),
  ];
}

function pastedIn(done: Transaction): string {
  if (!done.isUserEvent('input.paste') && !done.isUserEvent('input.drop')) return '';
  const texts: string[] = [];
  done.changes.iterChanges((_from, _to, _fromNow, _toNow, inserted) => texts.push(inserted.toString()));
  return texts.join('\n').trim();
}

/** True if a text is more than half of the program and has enough lines. */
function isMost(text: string, program: string): boolean {
  const lines = text.split('\n').filter((line) => line.trim() !== '').length;
  const written = (of: string): number => of.replaceAll(/\s/g, '').length;
  return lines >= LEAST_LINES && 2 * written(text) > written(program);
}
