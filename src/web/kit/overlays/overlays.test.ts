// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { effectScope, shallowRef } from 'vue';

import { openLayer, openOverlay, type Layer } from './overlays';
import { useLayer } from './use-layer';

let closed: string[] = [];
beforeEach(() => {
  closed = [];
  document.body.innerHTML =
    '<div class="app"><div class="cm-editor"><i id="program"></i></div></div><section id="menus"></section>';
});

/** Opens something that goes when it is asked to. */
function put(name: string, how: 'menu' | 'dialog' | 'card' | 'mode'): () => void {
  const layer: Layer = {
    covers: how === 'dialog',
    requestClose() {
      closed.push(name);
      close();
    },
  };
  const overlay = { ...layer, isBeside: () => false, tab: () => undefined };
  const close: () => void =
    how === 'menu' || how === 'dialog'
      ? openOverlay(overlay, how === 'menu' ? 2000 : 2400).close
      : openLayer(layer, how === 'mode' ? 'below' : 'top');
  return close;
}
function escape(at: Element = document.body, isUsed = false): readonly string[] {
  const before = closed.length;
  const event = new KeyboardEvent('keydown', { key: 'Escape', bubbles: true, cancelable: true });
  if (isUsed) event.preventDefault();
  at.dispatchEvent(event);
  return closed.slice(before);
}

describe('Escape', () => {
  it.each([
    { opened: ['menu', 'dialog'], closes: ['dialog', 'menu'] },
    { opened: ['dialog', 'menu'], closes: ['menu', 'dialog'] },
    { opened: ['card', 'menu'], closes: ['menu', 'card'] },
    { opened: ['dialog', 'mode'], closes: ['dialog', 'mode'] },
    { opened: ['mode', 'card', 'dialog', 'menu'], closes: ['menu', 'dialog', 'card', 'mode'] },
    { opened: ['card', 'mode', 'dialog'], closes: ['dialog', 'card', 'mode'] },
  ] as const)('closes one thing at a time, of $opened: $closes', ({ opened, closes }) => {
    for (const how of opened) put(how, how);
    const seen = closes.map(() => escape());
    expect([seen, escape()]).toEqual([closes.map((name) => [name]), []]);
  });

  it('closes nothing when a field or a gesture has used it', () => {
    const close = put('dialog', 'dialog');
    expect(escape(document.body, true)).toEqual([]);
    close();
  });

  it('is the program’s own in the program, unless an overlay lies over the page', () => {
    const program = document.getElementById('program')!;
    put('card', 'card');
    expect(escape(program)).toEqual([]);
    put('menu', 'menu');
    expect([escape(program), escape()]).toEqual([['menu'], ['card']]);
  });
});

describe('what a dialog covers', () => {
  const isInert = (): boolean => document.querySelector('.app')?.hasAttribute('inert') === true;

  it('cannot be used until the last of them has gone; menus lie beside it', () => {
    const closes = [put('one', 'dialog'), put('two', 'dialog'), put('menu', 'menu')];
    expect([isInert(), document.getElementById('menus')?.hasAttribute('inert')]).toEqual([true, false]);
    closes[0]?.();
    expect(isInert()).toBe(true);
    closes[1]?.();
    expect(isInert()).toBe(false);
    closes[2]?.();
  });
});

describe('a layer of a component', () => {
  it('is open as long as it says, and goes with its component', () => {
    const isOpen = shallowRef(false);
    const scope = effectScope();
    scope.run(() => useLayer({ requestClose: () => closed.push('mode') }, { isOpen: () => isOpen.value }));
    expect(escape()).toEqual([]);
    isOpen.value = true;
    expect(escape()).toEqual(['mode']);
    scope.stop();
    expect(escape()).toEqual([]);
  });
});
