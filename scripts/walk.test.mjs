import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';

const DOCUMENT = 'docs/walk.md';
const text = readFileSync(DOCUMENT, 'utf8');
/** Each stop: a link to a file, and the name in it. */
const stops = Array.from(text.matchAll(/\]\((\.\.\/src\/[^)]+)\)\s*:\s*`([^`]+)`/g), ([, link = '', name = '']) => ({
  path: join(dirname(DOCUMENT), link),
  name,
}));

describe('the walk through the code', () => {
  it('has nine stops to the wheel, two back from a sensor and ten to the floor', () => {
    expect(stops.length).toBe(9 + 2 + 10);
  });

  it.each(stops)('$path still has $name', ({ path, name }) => {
    expect(readFileSync(path, 'utf8')).toMatch(new RegExp(`\\b${name}\\b`));
  });

  it('links to nothing that is gone', () => {
    const links = Array.from(text.matchAll(/\]\(([^)]+)\)/g), ([, link = '']) => link);
    expect(links.filter((link) => link.startsWith('../src')).length).toBe(stops.length);
  });
});
