import { describe, expect, it } from 'vitest';

import { isOn, pageAddress } from './address';

const HOST = 'https://school.example/lessons/';
const address = (attributes: Readonly<Record<string, string>>): URL | null => {
  const text = pageAddress((name) => attributes[name] ?? null, HOST);
  return text === null ? null : new URL(text);
};
const parameters = (attributes: Readonly<Record<string, string>>): object =>
  Object.fromEntries(address({ src: 'app/', ...attributes })?.searchParams ?? []);

describe('the address that an element shows', () => {
  it('is that of its src, seen from the host page', () => {
    expect(address({ src: '../parcours/' })?.href).toBe('https://school.example/parcours/?dialect=none');
    expect(address({ src: 'https://other.example/p/simulator.html' })?.pathname).toBe('/p/simulator.html');
  });

  it('is none without a src, and none that is a script', () => {
    for (const src of [
      '',
      'javascript:alert(1)',
      'data:text/html,x',
      'blob:https://a.example/1',
      'http://[',
      'about:blank',
    ])
      expect(address({ src }), src).toBeNull();
    expect(address({})).toBeNull();
  });

  it('carries what the attributes wish, and leaves the parameters of src alone', () => {
    expect(parameters({ show: 'board, arena', lang: 'fr', speed: 'max', seed: '7', task: 'push' })).toEqual({
      ...{ show: 'board, arena', lang: 'fr', speed: 'max', seed: '7', task: 'push' },
      dialect: 'none',
    });
    expect(parameters({ src: 'app/?dialect=microbit&flag=x&theme=dark' })).toEqual({
      ...{ dialect: 'microbit', flag: 'x', theme: 'dark' },
    });
    expect(parameters({ title: 'a course', project: 'p.json', allow: 'serial' })).toEqual({ dialect: 'none' });
  });

  it('is silent where muted is there, but not where a framework writes false', () => {
    expect(parameters({ muted: '' })).toMatchObject({ muted: 'true' });
    expect(parameters({ muted: 'false' })).not.toHaveProperty('muted');
    expect([isOn(null), isOn(''), isOn('true'), isOn('false')]).toEqual([false, true, true, false]);
  });

  it('is that of the single file in a sandbox', () => {
    const path = (src: string): string | undefined => address({ src, sandboxed: '' })?.pathname;
    expect(path('/p/')).toBe('/p/parcours.single.html');
    expect(path('/p/index.html?x')).toBe('/p/parcours.single.html');
    expect(path('/p/simulator.html')).toBe('/p/simulator.single.html');
    expect(path('/p/parcours.single.html')).toBe('/p/parcours.single.html');
    expect(path('/p/our-own-name')).toBe('/p/our-own-name');
  });
});
