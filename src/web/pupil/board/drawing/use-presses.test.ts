// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { usePresses, type HandPresses } from './use-presses';

type Key = 'up' | 'left';

function bench() {
  const said: string[] = [];
  let made: HandPresses<Key> | null = null;
  const mounted = mount({
    setup: () => {
      made = usePresses<Key>({ press: (key) => said.push(`${key} down`), release: (key) => said.push(`${key} up`) });
      return () => null;
    },
  });
  if (made === null) throw new Error('Nothing was mounted.');
  const { down, presses, handlersFor } = made as HandPresses<Key>;
  return { said, mounted, presses, handlersFor, isDown: (key: Key) => down.value.has(key) };
}

describe('keys that several fingers hold', () => {
  it('go down with the first finger and up with the last', () => {
    const { said, presses } = bench();
    presses.hold('one', ['up']);
    presses.hold('two', ['up']);
    presses.letGo('one');
    expect(said).toEqual(['up down']);
    presses.letGo('two');
    expect(said).toEqual(['up down', 'up up']);
  });

  it('are held one beside the other, each by its finger', () => {
    const { said, presses, isDown } = bench();
    presses.hold('one', ['up']);
    presses.hold('two', ['left']);
    expect([isDown('up'), isDown('left')]).toEqual([true, true]);
    presses.letGo('one');
    expect([isDown('up'), isDown('left')]).toEqual([false, true]);
    expect(said).toEqual(['up down', 'left down', 'up up']);
  });

  it('are let go when the window loses the keyboard, and when the panel goes away', () => {
    const { said, presses, mounted } = bench();
    presses.hold('one', ['up']);
    dispatchEvent(new Event('blur'));
    presses.hold('one', ['left']);
    mounted.unmount();
    expect(said).toEqual(['up down', 'up up', 'left down', 'left up']);
  });

  it('are pressed by a mere click, as screen readers and switches send it', () => {
    const { said, handlersFor } = bench();
    handlersFor(['up']).click(new MouseEvent('click', { detail: 0 }));
    expect(said).toEqual(['up down']);
  });
});
