import { describe, expect, it } from 'vitest';

import { missingInScript, missingInStyles, olderUnits } from './oldest.ts';

/** The plugin's output for one declaration's value. */
function older(value: string): string | null {
  const made: string[] = [];
  const declaration = { value, cloneBefore: (changes: { value: string }) => made.push(changes.value) };
  (olderUnits as unknown as { Declaration(it: typeof declaration): void }).Declaration(declaration);
  return made[0] ?? null;
}

describe('units of the window', () => {
  it('get an older one in front', () => {
    expect(older('calc(100dvh - 16px)')).toBe('calc(100vh - 16px)');
    expect(older('min(92vh, 92dvh)')).toBe('min(92vh, 92vh)');
    expect(older('50svw')).toBe('50vw');
  });

  it('leaves units of the window alone that are old', () => {
    for (const value of ['100vh', 'var(--1dvh-like)', '12px']) expect(older(value)).toBeNull();
  });
});

describe('a script for the oldest browsers', () => {
  it.each([
    'a.replace(/(?<!b)c/g,"")',
    'a=/(?<=b)c/',
    'structuredClone(a)',
    'crypto.randomUUID()',
    'Object.groupBy(a,b)',
    'AbortSignal.timeout(5)',
    'new OffscreenCanvas(1,1)',
    'class A{static{b()}}',
  ])('has no %s', (code) => expect(missingInScript(code)).toHaveLength(1));

  it('may have what they know and what is filled in', () => {
    expect(missingInScript('a.replace(/(?<name>b)(?!c)/g,"").toSorted().at(-1);class A{#b;static c=1}')).toEqual([]);
  });
});

describe('styles for the oldest browsers', () => {
  it.each([
    '@layer base{a{b:c}}',
    '@media (width<=600px){a{b:c}}',
    'a:has(b){c:d}',
    'a{translate:1px}',
    'a{height:100dvh}',
    'a{background:color-mix(in srgb,red 4%,blue)}',
    'a{background:red;background:color-mix(in srgb,var(--a) 4%,blue)}',
  ])('have no %s', (css) => expect(missingInStyles(css)).toHaveLength(1));

  it('may have new values behind older ones, and what they do without', () => {
    const css =
      'a{height:100vh;height:100dvh}b{background:red;background:color-mix(in srgb,red 4%,blue)}@container (width<=5px){c{transform:rotate(1deg)}}';
    expect(missingInStyles(css)).toEqual([]);
  });
});
