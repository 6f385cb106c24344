// @vitest-environment happy-dom
import { history } from '@codemirror/commands';
import { pythonLanguage } from '@codemirror/lang-python';
import { indentOnInput, indentUnit, LanguageSupport } from '@codemirror/language';
import { EditorState } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { describe, expect, it } from 'vitest';

import { givenBrackets, insertCall } from '../help/given-brackets';
import { KEYS, typeInto, type KeyId } from './keys';

/** An editor; `|` is the cursor, `[ ]` what is marked. */
function editor(marked: string): EditorView {
  const from = marked.search(/[|‹]/);
  const to = marked.includes('›') ? marked.indexOf('›') - 1 : from;
  const python = [new LanguageSupport(pythonLanguage), indentUnit.of('    '), indentOnInput()];
  return new EditorView({
    state: EditorState.create({
      doc: marked.replace(/[|‹›]/g, ''),
      selection: { anchor: from, head: to },
      extensions: [history(), givenBrackets, python],
    }),
  });
}

function shown({ state }: EditorView): string {
  const { head } = state.selection.main;
  return `${state.sliceDoc(0, head)}|${state.sliceDoc(head)}`;
}

function press(view: EditorView, ...ids: readonly KeyId[]): string {
  for (const id of ids) KEYS.find((key) => key.id === id)?.press(view);
  return shown(view);
}

describe('the keys over the soft keyboard', () => {
  it('write at the cursor, one after the other', () => {
    expect(press(editor('print|'), 'open', 'quote', 'quote', 'close')).toBe('print("")|');
    expect(press(editor('liste|'), 'openSquare', 'apostrophe', 'closeSquare', 'equals')).toBe("liste[']=|");
    expect(press(editor('a|b'), 'underscore', 'hash', 'less', 'greater')).toBe('a_#<>|b');
  });

  it('replace what is marked', () => expect(press(editor('a ‹und› b'), 'equals')).toBe('a =| b'));

  it('pass over the bracket that a suggestion has brought, as if it were typed', () => {
    const view = editor('sle|');
    insertCall(view, 'sleep', 0, 3, true);
    expect(shown(view)).toBe('sleep(|)');
    typeInto(view, '5');
    expect(press(view, 'close')).toBe('sleep(5)|');
  });

  it('move else back when its colon comes, as if it were typed', () => {
    expect(press(editor('if x:\n    y\n    else|'), 'colon')).toBe('if x:\n    y\nelse:|');
  });

  it('indent and unindent the line by four spaces', () => {
    expect(press(editor('a|'), 'indent')).toBe('    a|');
    expect(press(editor('        a|'), 'dedent')).toBe('    a|');
  });

  it('take back what the last key wrote', () => {
    expect(press(editor('x|'), 'colon', 'undo')).toBe('x|');
  });

  it('begin with those that a beginner needs: they are in sight on a phone of 360 px', () => {
    const first = KEYS.slice(0, 8).map(({ id }) => id);
    for (const id of ['colon', 'open', 'close', 'quote', 'equals', 'hash', 'indent']) expect(first).toContain(id);
  });
});
