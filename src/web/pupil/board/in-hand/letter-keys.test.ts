// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { Presses } from '../drawing/presses';
import { letterHandlers } from './letter-keys';

function bench() {
  const said: string[] = [];
  const presses = new Presses<'C'>({ press: () => said.push('down'), release: () => said.push('up') });
  const { keydown, keyup, focusout } = letterHandlers(presses, ({ key }) => (key.toUpperCase() === 'C' ? 'C' : null));
  const key = (type: string, name: string) => new KeyboardEvent(type, { key: name, code: 'KeyC' });
  return { said, focusout, down: (name: string) => keydown(key('keydown', name)), up: (name: string) => keyup(key('keyup', name)) }; // prettier-ignore
}

describe('a letter that presses a key', () => {
  it('lets it go where the same place comes up, with Shift or without', () => {
    const { said, down, up } = bench();
    down('c');
    up('C');
    expect(said).toEqual(['down', 'up']);
  });

  it('lets it go when the focus leaves the group meanwhile, and not within the group', () => {
    const { said, down, focusout } = bench();
    const group = document.createElement('div');
    const inside = group.appendChild(document.createElement('button'));
    group.addEventListener('focusout', focusout);
    const leave = (relatedTarget: EventTarget | null) =>
      inside.dispatchEvent(new FocusEvent('focusout', { relatedTarget, bubbles: true }));
    down('c');
    leave(inside);
    expect(said).toEqual(['down']);
    leave(null);
    expect(said).toEqual(['down', 'up']);
  });
});
