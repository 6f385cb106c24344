import { Prec, StateEffect, StateField, type EditorState, type Extension, type Transaction } from '@codemirror/state';
import { EditorView, keymap, showTooltip, type Tooltip } from '@codemirror/view';

import { callAt, parametersOf, type CallHint } from '#reference/arguments';
import type { ReferenceContext } from '#reference/context';
import { element, shortSignature } from './card';

const close = StateEffect.define();

/** While arguments are written: how the function is called, with the present parameter marked. Escape closes it. */
export function argumentHint(context: () => ReferenceContext): Extension {
  const field = StateField.define<CallHint | null>({
    create: () => null,
    update: (hint, transaction) => next(hint, transaction, context),
    provide: (it) => showTooltip.from(it, (hint) => (hint === null ? null : tooltipOf(hint))),
  });
  return [
    field,
    Prec.high(
      keymap.of([
        {
          key: 'Escape',
          run: (view) => {
            if (view.state.field(field) === null) return false;
            view.dispatch({ effects: close.of(null) });
            return true;
          },
        },
      ]),
    ),
    EditorView.domEventHandlers({
      blur: (_event, view) => {
        if (view.state.field(field, false) !== null) queueMicrotask(() => view.dispatch({ effects: close.of(null) }));
      },
    }),
  ];
}

function next(hint: CallHint | null, transaction: Transaction, context: () => ReferenceContext): CallHint | null {
  if (transaction.effects.some((effect) => effect.is(close))) return null;
  const { state, docChanged, selection } = transaction;
  if (!docChanged && selection === undefined) return hint;
  if (docChanged && hint === null && !opens(transaction)) return null;
  if (hint === null && !docChanged) return null;
  const found = hintAt(state, context());
  return same(hint, found) ? hint : found;
}

/** A bracket or comma asks for the hint; other signs only keep it up to date. */
function opens(transaction: Transaction): boolean {
  if (!transaction.isUserEvent('input')) return false;
  let opening = false;
  transaction.changes.iterChanges((_fromA, _toA, _fromB, _toB, inserted) => {
    opening = opening || /[(,]/.test(inserted.sliceString(0));
  });
  return opening;
}

function hintAt(state: EditorState, context: ReferenceContext): CallHint | null {
  const { main } = state.selection;
  if (!main.empty) return null;
  const hint = callAt(state.doc.toString(), main.head, context);
  return hint === null || parametersOf(hint.item.calls[hint.call] ?? '').length === 0 ? null : hint;
}

function same(a: CallHint | null, b: CallHint | null): boolean {
  if (a === null || b === null) return a === b;
  const sameCall = a.item.label === b.item.label && a.item.calls[a.call] === b.item.calls[b.call];
  return sameCall && a.from === b.from && a.parameter === b.parameter;
}

function tooltipOf(hint: CallHint): Tooltip {
  return {
    pos: hint.from,
    above: true,
    create: () => {
      const call = hint.item.calls[hint.call] ?? '';
      const dom = element('div', 'cm-helpHint', shortSignature(hint.item.label, call, hint.parameter));
      dom.setAttribute('role', 'status');
      return { dom };
    },
  };
}
