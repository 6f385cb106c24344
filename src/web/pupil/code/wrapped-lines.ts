import { countColumn, RangeSetBuilder, type Extension } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin, type DecorationSet, type ViewUpdate } from '@codemirror/view';

import { memo } from '#core/memo';

/** Indentation of the continuation of a wrapped line, in columns. Chosen: it cannot be mistaken for an indent. */
const FURTHER = 2;
/** Most columns of indentation that the continuation of a line has: a phone has little more. */
const MOST = 16;

/** Column, from the pane's left edge, at which the rest of a wrapped line begins. */
export function restColumn(text: string, tabSize: number): number {
  const indent = /^[ \t]*/.exec(text)?.[0] ?? '';
  return Math.min(MOST, countColumn(indent, tabSize)) + FURTHER;
}

/** The padding of a line at its left, as in the editor's look, px. */
const PADDING_PX = 6;

const markFor = memo((column: number) =>
  Decoration.line({
    attributes: { style: `padding-left:calc(${PADDING_PX}px + ${column}ch);text-indent:-${column}ch` },
  }),
);

function marksIn({ state, visibleRanges }: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { from, to } of visibleRanges) {
    for (let at = from; at <= to;) {
      const line = state.doc.lineAt(at);
      builder.add(line.from, line.from, markFor(restColumn(line.text, state.tabSize)));
      at = line.to + 1;
    }
  }
  return builder.finish();
}

/**
 * Lines that are too long for the pane go on below, further in than they begin: nothing of a program is out of sight.
 */
export const wrappedLines: Extension = [
  EditorView.lineWrapping,
  ViewPlugin.fromClass(
    class {
      decorations: DecorationSet;

      constructor(view: EditorView) {
        this.decorations = marksIn(view);
      }

      update({ docChanged, viewportChanged, view }: ViewUpdate): void {
        if (docChanged || viewportChanged) this.decorations = marksIn(view);
      }
    },
    { decorations: (plugin) => plugin.decorations },
  ),
];
