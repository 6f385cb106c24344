// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { EditorState } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { watchLargePastes } from './watch-large-pastes';

const THREE = 'forward()\ndelay(500)\nstop()\n';

function editor(doc = '') {
  const told = vi.fn();
  const copied = { text: '' };
  const view = new EditorView({ state: EditorState.create({ doc, extensions: watchLargePastes(copied, told) }) });
  const add = (insert: string, userEvent = 'input.paste'): void =>
    view.dispatch({ changes: { from: view.state.doc.length, insert }, userEvent });
  return { told, copied, add };
}

describe('a paste', () => {
  it('is told if it is most of the program', () => {
    const { told, add } = editor('# Anna\n');
    add(THREE);
    expect(told).toHaveBeenCalledOnce();
  });

  it('is not told if it is a line or two, or the smaller part', () => {
    const small = editor();
    small.add('forward()\nstop()\n');
    const long = editor(THREE.repeat(2));
    long.add(THREE);
    expect([small.told, long.told].map(({ mock }) => mock.calls.length)).toEqual([0, 0]);
  });

  it('is not told if it was copied here, nor is what was typed', () => {
    const { told, copied, add } = editor();
    add(THREE, 'input.type');
    copied.text = THREE;
    add(THREE);
    expect(told).not.toHaveBeenCalled();
  });
});
