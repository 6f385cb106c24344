import { Prec, StateEffect, StateField, type Extension } from '@codemirror/state';
import {
  EditorView,
  hoverTooltip,
  keymap,
  showPanel,
  showTooltip,
  type Command,
  type Panel,
  type Tooltip,
} from '@codemirror/view';

import { callAt } from '#reference/arguments';
import type { ReferenceContext } from '#reference/context';
import { describe, type Description } from '#reference/describe';
import { t } from '../../../kit/i18n';
import { card, element, spoken } from './card';
import helpWords from './words';
import type { Words } from './words-on';

/** Shows a description, or none. */
const show = StateEffect.define<Description | null>();

/** Rest of the mouse before a card opens, in ms: one that only passes by opens none. */
const HOVER_MS = 350;

/**
 * Cards on names: under the mouse; with F1 or Ctrl+Shift+Space at the cursor; on touch screens in a bar below the
 * program when a name is tapped. Escape closes them.
 */
export function cards(context: () => ReferenceContext, words: Words): Extension {
  let touched = false;
  const at = (view: EditorView, offset: number): Description | null =>
    describe(view.state.doc.toString(), offset, context());
  const asked = StateField.define<Description | null>({
    create: () => null,
    update: (value, { effects, docChanged, selection }) => {
      for (const effect of effects) if (effect.is(show)) return effect.value;
      return docChanged || selection !== undefined ? null : value;
    },
    provide: (field) => [
      showTooltip.from(field, (it) => (it === null || touched ? null : tooltipOf(it, words))),
      showPanel.from(field, (it) => (it === null || !touched ? null : (view) => barOf(view, it, words))),
    ],
  });
  const open: Command = (view) => {
    const found = at(view, view.state.selection.main.head) ?? callAround(view, context());
    if (found === null) return false;
    touched = false;
    view.dispatch({ effects: [show.of(found), EditorView.announce.of(spoken(found.item, words))] });
    return true;
  };
  const close: Command = (view) => {
    if (view.state.field(asked) === null) return false;
    view.dispatch({ effects: show.of(null) });
    return true;
  };
  return [
    asked,
    hoverTooltip(
      (view, offset, side) => {
        const found = touched ? null : at(view, offset);
        // Only the word itself: not the space behind a line.
        if (found === null || (offset === found.to && side > 0)) return null;
        return tooltipOf(found, words);
      },
      { hoverTime: HOVER_MS, hideOnChange: true },
    ),
    Prec.high(
      keymap.of([
        { key: 'F1', run: open }, // without a word there, it opens the help of the page
        { key: 'Ctrl-Shift-Space', run: open, preventDefault: true },
        { key: 'Escape', run: close },
      ]),
    ),
    EditorView.domEventObservers({
      pointerdown: (event) => void (touched = event.pointerType === 'touch'),
      pointermove: (event) => void (touched = event.pointerType === 'touch'),
    }),
    EditorView.updateListener.of(({ view, transactions, state }) => {
      const tapped = transactions.some((it) => it.isUserEvent('select.pointer'));
      if (!tapped || !touched || !state.selection.main.empty) return;
      const found = at(view, state.selection.main.head);
      if (found !== null) queueMicrotask(() => view.dispatch({ effects: show.of(found) }));
    }),
  ];
}

/** The function whose brackets are around the cursor. */
function callAround(view: EditorView, context: ReferenceContext): Description | null {
  const { head } = view.state.selection.main;
  const hint = callAt(view.state.doc.toString(), head, context);
  return hint === null ? null : { from: hint.from, to: hint.from, item: hint.item, argument: null };
}

function tooltipOf({ from, to, item, argument }: Description, words: Words): Tooltip {
  return { pos: from, end: to, above: true, create: () => ({ dom: card(item, words, argument) }) };
}

function barOf(view: EditorView, { item, argument }: Description, words: Words): Panel {
  const button = element('button', 'cm-helpClose', '×') as HTMLButtonElement;
  button.type = 'button';
  button.setAttribute('aria-label', t(helpWords.close));
  button.addEventListener('click', () => view.dispatch({ effects: show.of(null) }));
  const dom = element('div', 'cm-helpBar', card(item, words, argument), button);
  dom.setAttribute('role', 'status');
  return { dom, top: false };
}
