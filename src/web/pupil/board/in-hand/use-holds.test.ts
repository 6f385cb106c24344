// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { effectScope } from 'vue';
import { useHolds } from './use-holds';

function bench() {
  const said: string[] = [];
  const scope = effectScope();
  const holds = scope.run(() =>
    useHolds<'up' | 'left'>((key, isDown) => said.push(`${key} ${isDown ? 'down' : 'up'}`)),
  );
  if (holds === undefined) throw new Error('no holds');
  return { said, scope, ...holds };
}

describe('keys that several fingers hold', () => {
  it('go down with the first finger and up with the last', () => {
    const { said, hold } = bench();
    hold('one', 'up');
    hold('two', 'up');
    hold('one', null);
    expect(said).toEqual(['up down']);
    hold('two', null);
    expect(said).toEqual(['up down', 'up up']);
  });

  it('are held one beside the other, each by its finger', () => {
    const { said, hold, isDown } = bench();
    hold('one', 'up');
    hold('two', 'left');
    expect([isDown('up'), isDown('left')]).toEqual([true, true]);
    hold('one', null);
    expect([isDown('up'), isDown('left')]).toEqual([false, true]);
    expect(said).toEqual(['up down', 'left down', 'up up']);
  });

  it('are let go when the window loses the keyboard, and when the panel goes away', () => {
    const { said, hold, scope } = bench();
    hold('one', 'up');
    dispatchEvent(new Event('blur'));
    hold('one', 'left');
    scope.stop();
    expect(said).toEqual(['up down', 'up up', 'left down', 'left up']);
  });
});
