// @vitest-environment happy-dom
import { EditorState } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { marginOf, pointLines, showStops, showStopsCalmly, stopMarks } from './marks';

function editor(onMove: (lines: readonly number[]) => void = vi.fn()): EditorView {
  return new EditorView({
    state: EditorState.create({ doc: 'a\nb\nc\nd\n', extensions: stopMarks(onMove, () => null) }),
  });
}
const standing = (view: EditorView): readonly string[] =>
  [...view.contentDOM.querySelectorAll('.cm-standingLine')].map(({ textContent }) => textContent ?? '');

describe('break points in the editor', () => {
  it('move with their lines, and say so', () => {
    const onMove = vi.fn<(lines: readonly number[]) => void>();
    const view = editor(onMove);
    showStops(view, [2, 4], null);
    view.dispatch({ changes: { from: 0, insert: 'new\n' } });
    expect(pointLines(view.state)).toEqual([3, 5]);
    expect(onMove.mock.calls).toEqual([[[3, 5]]]);
  });

  it('become one where their lines do', () => {
    const view = editor();
    showStops(view, [2, 3], null);
    view.dispatch({ changes: { from: 2, to: 4, insert: '' } });
    expect(pointLines(view.state)).toEqual([2]);
  });

  it('are left out on lines that the file has not', () => {
    const view = editor();
    showStops(view, [0, 2, 99], null);
    expect(pointLines(view.state)).toEqual([2]);
  });
});

describe('the line where the program stands', () => {
  it('is marked, and only that', () => {
    const view = editor();
    showStops(view, [], 3);
    expect(standing(view)).toEqual(['c']);
    showStops(view, [], 1);
    expect(standing(view)).toEqual(['a']);
    showStops(view, [], null);
    expect(standing(view)).toEqual([]);
  });

  it('is brought into sight also where the editor is only a line or two high', () => {
    expect([400, 60, 30, 10].map((heightPx) => marginOf(heightPx, 22))).toEqual([40, 19, 4, 0]);
  });

  it('is marked no more once the program has been changed', () => {
    const view = editor();
    showStops(view, [], 3);
    view.dispatch({ changes: { from: 0, insert: 'x' } });
    expect(standing(view)).toEqual([]);
  });
});

describe('the line of the moments that somebody drags through', () => {
  afterEach(() => void vi.useRealTimers());

  it('is marked five times a second at most, the last one always', () => {
    vi.useFakeTimers();
    const view = editor();
    document.body.append(view.dom);
    showStopsCalmly(view, [], 1);
    expect(standing(view)).toEqual(['a']);
    showStopsCalmly(view, [], 2);
    showStopsCalmly(view, [], 3);
    vi.advanceTimersByTime(199);
    expect(standing(view)).toEqual(['a']);
    vi.advanceTimersByTime(1);
    expect(standing(view)).toEqual(['c']);
    vi.advanceTimersByTime(200);
    showStopsCalmly(view, [], 4);
    expect(standing(view)).toEqual(['d']);
  });
});
