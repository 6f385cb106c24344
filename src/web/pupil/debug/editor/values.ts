import { StateEffect, StateField, type Extension } from '@codemirror/state';
import { EditorView, hoverTooltip, showTooltip, type Tooltip } from '@codemirror/view';

import type { Shown } from '#vm/debug/shown';

/** The name at a place of a text, as Python's are written; `null`: there is none. */
export function nameAt(text: string, at: number): { readonly name: string; readonly from: number } | null {
  for (const { 1: before = '', 2: name = '', index } of text.matchAll(/(^|[^\w.])([\p{L}_][\p{L}\p{N}_]*)/gu)) {
    const from = index + before.length;
    if (from <= at && at <= from + name.length) return { name, from };
  }
  return null;
}

/** A finger may tap this far beside a name, in px. */
const BESIDE_PX = 12;

/** Shows this card for a finger, which cannot hover; `null` takes it away. */
export const showTapped = StateEffect.define<Tooltip | null>();

const tapped = StateField.define<Tooltip | null>({
  create: () => null,
  update(before, transaction) {
    const shown = transaction.effects.findLast((effect) => effect.is(showTapped));
    return shown === undefined ? (transaction.docChanged ? null : before) : shown.value;
  },
  provide: (field) => showTooltip.from(field),
});

/**
 * Shows the value of the name that the mouse points at or a finger taps.
 *
 * @param valueOf the value of a name; `null`: it has none now
 */
export function values(valueOf: (name: string) => Shown | null): Extension {
  let isFinger = false;
  return [
    hoverTooltip((view, position) => tooltipAt(view, position, valueOf)),
    tapped,
    EditorView.domEventHandlers({
      pointerdown({ pointerType }) {
        isFinger = pointerType === 'touch';
      },
      click({ clientX, clientY }, view) {
        const position = isFinger ? view.posAtCoords({ x: clientX, y: clientY }) : null;
        const near = position === null ? null : tooltipAt(view, position, valueOf);
        const rightPx = near?.end === undefined ? undefined : view.coordsAtPos(near.end)?.right;
        // Beside a line's end the nearest place is its last letter.
        const tooltip = rightPx !== undefined && clientX < rightPx + BESIDE_PX ? near : null;
        if (tooltip !== view.state.field(tapped)) view.dispatch({ effects: showTapped.of(tooltip) });
      },
    }),
  ];
}

function tooltipAt(view: EditorView, position: number, valueOf: (name: string) => Shown | null): Tooltip | null {
  const line = view.state.doc.lineAt(position);
  const found = nameAt(line.text, position - line.from);
  const value = found && valueOf(found.name);
  if (found === null || value === null) return null;
  const { name, from } = found;
  return {
    pos: line.from + from,
    end: line.from + from + name.length,
    above: true,
    create: () => ({ dom: card(name, value) }),
  };
}

function card(name: string, { type, text }: Shown): HTMLElement {
  const dom = document.createElement('div');
  dom.className = 'cm-valueCard';
  dom.dataset['testid'] = 'value-card';
  const kind = document.createElement('span');
  kind.textContent = ` ${type}`;
  const value = document.createElement('b');
  value.textContent = ` ${text}`;
  dom.append(name, kind, value);
  return dom;
}
