// @vitest-environment happy-dom
import { EditorView } from '@codemirror/view';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';

import { createTabKey, type TabKey } from './tab-key';

let view: EditorView;
let tabKey: TabKey;
beforeEach(() => {
  tabKey = createTabKey();
  view = new EditorView({ doc: 'eins', extensions: tabKey.extension, parent: document.body });
  send('focus');
});
afterEach(() => view.destroy());

function send(type: 'focus' | 'blur' | 'pointerdown' | 'keydown' | 'keyup', key = '', shiftKey = false): Event {
  const event = new KeyboardEvent(type, { key, shiftKey, bubbles: true, cancelable: true });
  view.contentDOM.dispatchEvent(event);
  return event;
}
/** True if Tab leads on: the browser gets the key. */
const leaves = (shiftKey = false): boolean => !send('keydown', 'Tab', shiftKey).defaultPrevented;
const type = (): void => view.dispatch({ changes: { from: 0, insert: 'x' }, userEvent: 'input.type' });
const text = (): string => view.state.doc.toString();

describe('the Tab key in the program', () => {
  it('leads on, and back, and changes nothing until something was typed', () => {
    expect([leaves(), leaves(true), text()]).toEqual([true, true, 'eins']);
    type();
    expect([leaves(), text()]).toEqual([false, '  xeins']);
    expect([leaves(true), text()]).toEqual([false, 'xeins']);
  });

  it('leads on again after Escape, until the next letter', () => {
    type();
    send('keydown', 'Escape');
    expect([leaves(), leaves()]).toEqual([true, true]);
    type();
    expect(leaves()).toBe(false);
  });

  it('leads on when the keyboard comes back later', () => {
    type();
    send('blur');
    send('focus');
    expect(leaves()).toBe(true);
  });

  it('indents what was pressed or marked with the mouse', () => {
    send('pointerdown');
    expect([leaves(), text()]).toEqual([false, '  eins']);
  });

  it('does not take a text that comes from elsewhere for typing', () => {
    send('blur');
    type();
    send('focus');
    expect(leaves()).toBe(true);
  });
});

describe('the line that says how the keyboard leaves the program', () => {
  it('comes with the keyboard: a key that was pressed elsewhere is let go here', () => {
    expect(tabKey.isReached.value).toBe(false);
    send('keyup', 'Tab');
    expect(tabKey.isReached.value).toBe(true);
    send('blur');
    expect(tabKey.isReached.value).toBe(false);
  });

  it('does not come to whom the mouse brought here, nor to a key that is pressed and let go here', () => {
    send('pointerdown');
    send('keyup', 'Control');
    send('keydown', 'a');
    send('keyup', 'a');
    expect(tabKey.isReached.value).toBe(false);
  });
});
