import { describe, expect, it } from 'vitest';

import { command, type CommandKey } from './command-keys';

/** The effect of a key pressed with Ctrl, and whether the browser's own is prevented. */
function pressed(key: string, held: Partial<CommandKey> = {}): readonly string[] {
  const done: string[] = [];
  const plain = { altKey: false, shiftKey: false, repeat: false, preventDefault: () => done.push('kept') };
  command(
    { ...plain, key, ...held },
    { enter: () => done.push('run'), 'shift+enter': () => done.push('stop'), s: () => done.push('save') },
  );
  return done;
}

describe('keys with Ctrl', () => {
  it('run with Enter and save with S, and keep the browser from saving the page', () => {
    expect(pressed('Enter')).toEqual(['run', 'kept']);
    expect(pressed('s')).toEqual(['save', 'kept']);
  });

  it('stop with Shift and Enter', () => {
    expect(pressed('Enter', { shiftKey: true })).toEqual(['stop', 'kept']);
  });

  it('save while Caps Lock is on, too', () => {
    expect(pressed('S')).toEqual(['save', 'kept']);
  });

  it('leave all others to the browser, and do nothing twice while a key is held', () => {
    expect(pressed('p')).toEqual([]);
    expect(pressed('S', { shiftKey: true })).toEqual([]);
    expect(pressed('s', { repeat: true })).toEqual([]);
  });
});
