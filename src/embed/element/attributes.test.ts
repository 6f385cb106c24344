import { describe, expect, it } from 'vitest';

import { ParcoursAttributes, takeEarlyProperties } from './attributes';

/** The element's properties over a list of attributes. */
class Element extends ParcoursAttributes {
  readonly list = new Map<string, string>();
  override getAttribute(name: string): string | null {
    return this.list.get(name) ?? null;
  }
  override setAttribute(name: string, value: string): void {
    this.list.set(name, value);
  }
  override removeAttribute(name: string): void {
    this.list.delete(name);
  }
  override whenReady(): Promise<never> {
    return Promise.reject(new Error('There is no page.'));
  }
}

describe('the properties of an element', () => {
  it('are its attributes', () => {
    const element = new Element();
    Object.assign(element, { src: 'app/', seed: 7, snapshotHz: 4, muted: true, sandboxed: true, show: 'arena' });
    expect([...element.list]).toEqual([
      ...[['src', 'app/'], ['seed', '7'], ['snapshot-hz', '4'], ['muted', ''], ['sandboxed', ''], ['show', 'arena']], // prettier-ignore
    ]);
    Object.assign(element, { seed: null, muted: false, show: undefined });
    expect([element.seed, element.muted, element.show]).toEqual([null, false, null]);
    expect(element.list.size).toBe(3);
  });

  it('are null for any value that makes no sense, as for one that is left out', () => {
    const element = new Element();
    for (const name of ['speed', 'theme', 'loading']) element.setAttribute(name, 'nonsense');
    expect([element.speed, element.theme, element.loading]).toEqual([null, null, null]);
    Object.assign(element, { speed: 0.25, theme: 'dark', loading: 'eager' });
    expect([element.speed, element.theme, element.loading]).toEqual(['0.25', 'dark', 'eager']);
  });

  it('count as well when a framework has set them before the code came', () => {
    const element = new Element();
    for (const [name, value] of Object.entries({ seed: 7, title: 'mine' }))
      Object.defineProperty(element, name, { value, configurable: true, enumerable: true, writable: true });
    expect(element.list.size).toBe(0);
    takeEarlyProperties(element);
    expect([...element.list]).toEqual([['seed', '7']]);
    expect(element.seed).toBe('7');
    expect(Object.hasOwn(element, 'seed')).toBe(false);
    expect(element.title).toBe('mine');
  });

  it('do no harm where there is no browser', async () => {
    const { ParcoursSimulatorElement } = await import('./define');
    expect(typeof ParcoursSimulatorElement).toBe('function');
  });
});
