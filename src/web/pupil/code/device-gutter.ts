import { Facet, Prec, RangeSet, type Extension } from '@codemirror/state';
import { EditorView, gutter, type GutterMarker } from '@codemirror/view';

/** The marks beside the lines. Their column is there from the start: text that is being read must not move. */
export const deviceGutter = Facet.define<RangeSet<GutterMarker>, RangeSet<GutterMarker>>({
  combine: ([first]) => first ?? RangeSet.empty,
});

/** The column itself; a press on a mark puts the cursor into its line, which is explained then. */
export const deviceColumn: Extension = Prec.high(
  gutter({
    class: 'cm-deviceGutter',
    markers: (view) => view.state.facet(deviceGutter),
    domEventHandlers: {
      mousedown(view, { from }, event) {
        if (!(event.target instanceof Element) || event.target.closest('.cm-deviceMark') === null) return false;
        event.preventDefault();
        view.dispatch({ selection: { anchor: from } });
        view.focus();
        return true;
      },
    },
  }),
);

/** How the column looks while it is empty; the marks bring their own look. */
export const columnLook: Extension = EditorView.theme({
  '.cm-deviceGutter': { width: '20px' },
  '&.cm-focused .cm-lineNumbers .cm-activeLineGutter': { boxShadow: 'none' }, // the first column has the bar
});
