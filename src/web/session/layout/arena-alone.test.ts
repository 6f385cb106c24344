// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it } from 'vitest';

import { openLayer } from '../../kit/overlays/overlays';
import { ArenaAlone } from './arena-alone';

const isShown = (): boolean => document.documentElement.classList.contains('arena-alone');
const escape = (before?: (event: Event) => void): void => {
  const event = new KeyboardEvent('keydown', { key: 'Escape', cancelable: true });
  before?.(event);
  dispatchEvent(event);
};

describe('the arena alone on the screen', () => {
  let alone: ArenaAlone;
  let detach: () => void;
  beforeEach(() => {
    document.body.innerHTML = '';
    Object.defineProperty(document, 'fullscreenElement', { configurable: true, value: null });
    alone = new ArenaAlone();
    detach = alone.attach();
  });
  afterEach(() => {
    alone.leave();
    detach();
  });

  it('comes and goes, and the page behind it with it', () => {
    expect(isShown()).toBe(false);
    alone.enter();
    expect([alone.isAlone.value, isShown()]).toEqual([true, true]);
    alone.leave();
    expect([alone.isAlone.value, isShown()]).toEqual([false, false]);
  });

  it('is the next time without task and timer, however it was left', () => {
    alone.hasSide.value = true;
    alone.enter();
    escape();
    expect(alone.hasSide.value).toBe(false);
    alone.hasSide.value = true;
    alone.enter();
    document.dispatchEvent(new Event('fullscreenchange'));
    expect([alone.hasSide.value, isShown()]).toEqual([false, false]);
  });

  it('is left with Escape', () => {
    alone.enter();
    escape();
    expect(isShown()).toBe(false);
  });

  it('stays when a menu, a dialog or a gesture has used Escape', () => {
    alone.enter();
    escape((event) => event.preventDefault());
    expect(isShown()).toBe(true);
    const close = openLayer({ requestClose: () => close() });
    escape();
    expect(isShown()).toBe(true);
    escape();
    expect(isShown()).toBe(false);
  });

  it('is not left with another key', () => {
    alone.enter();
    dispatchEvent(new KeyboardEvent('keydown', { key: 'a' }));
    expect(isShown()).toBe(true);
  });

  it('goes when the browser itself gives the screen back', () => {
    alone.enter();
    Object.defineProperty(document, 'fullscreenElement', { configurable: true, value: document.documentElement });
    document.dispatchEvent(new Event('fullscreenchange'));
    expect(isShown()).toBe(true);
    Object.defineProperty(document, 'fullscreenElement', { configurable: true, value: null });
    document.dispatchEvent(new Event('fullscreenchange'));
    expect(isShown()).toBe(false);
  });

  it('is left without an error on an iPhone, which can give no page the whole screen', () => {
    Object.defineProperty(document, 'fullscreenElement', { configurable: true, value: undefined });
    alone.enter();
    expect(() => alone.leave()).not.toThrow();
    expect(isShown()).toBe(false);
  });

  it('goes when the last control that leads back goes, not before', () => {
    const second = alone.attach();
    alone.enter();
    second();
    expect(isShown()).toBe(true);
    detach();
    expect(isShown()).toBe(false);
    detach = alone.attach();
  });

  it('no longer listens once nothing is left that leads back', () => {
    detach();
    alone.enter();
    escape();
    expect(isShown()).toBe(true);
    detach = alone.attach();
  });
});
