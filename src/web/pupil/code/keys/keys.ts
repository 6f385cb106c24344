import { indentLess, indentMore, undo } from '@codemirror/commands';
import { EditorView, type Command } from '@codemirror/view';

/** A key of the row: what it writes, or what it does. */
export interface Key {
  /** The name of its words. */
  readonly id: KeyId;
  /** The sign on it, which it writes; `null`: it does something else. */
  readonly sign: string | null;
  readonly press: Command;
}

/**
 * Writes a sign as if it were typed: what watches over typing (brackets given, suggestions, indentation) takes part.
 */
export function typeInto(view: EditorView, text: string): boolean {
  const { state } = view;
  const { from, to } = state.selection.main;
  const insert = () =>
    state.update(state.replaceSelection(text), { userEvent: 'input.type', scrollIntoView: true }, { sequential: true });
  const taken = state.facet(EditorView.inputHandler).some((handle) => handle(view, from, to, text, insert));
  if (!taken) view.dispatch(insert());
  return true;
}

const typed = <K extends string>(id: K, sign: string) =>
  ({ id, sign, press: (view: EditorView) => typeInto(view, sign) }) as const;

const all = [
  { id: 'indent', sign: null, press: indentMore },
  typed('colon', ':'),
  typed('open', '('),
  typed('close', ')'),
  typed('quote', '"'),
  typed('equals', '='),
  typed('hash', '#'),
  { id: 'dedent', sign: null, press: indentLess },
  typed('apostrophe', "'"),
  typed('underscore', '_'),
  typed('openSquare', '['),
  typed('closeSquare', ']'),
  typed('less', '<'),
  typed('greater', '>'),
  { id: 'undo', sign: null, press: undo },
] as const;

/** The name of a key. */
export type KeyId = (typeof all)[number]['id'];

/**
 * Characters that Python needs and soft keyboards hide behind two layers. The first eight fit on a phone of 360 px;
 * the others follow by how seldom a beginner's program has them.
 */
export const KEYS: readonly Key[] = all;
