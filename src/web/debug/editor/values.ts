import { hoverTooltip, type EditorView, type Tooltip } from '@codemirror/view';
import type { Extension } from '@codemirror/state';

import type { Shown } from '#vm/debug/shown';

/** The name at a place of a text, as Python's are written; `null`: there is none. */
export function nameAt(text: string, at: number): { readonly name: string; readonly from: number } | null {
  for (const { 0: name, index } of text.matchAll(/(?<![\w.])[\p{L}_][\p{L}\p{N}_]*/gu))
    if (index <= at && at <= index + name.length) return { name, from: index };
  return null;
}

/** Shows the value of the name that the mouse points at. @param valueOf `null`: nothing is known by that name now */
export const values = (valueOf: (name: string) => Shown | null): Extension =>
  hoverTooltip((view: EditorView, position): Tooltip | null => {
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
  });

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
