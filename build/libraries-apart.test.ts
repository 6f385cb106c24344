import { describe, expect, it } from 'vitest';

import { halvesOf, withLateImports } from './libraries-apart.ts';

const library = `
import { list, tree } from 'elsewhere';
const size = 3;
const label = tree('a label');
class Base { size = 1; }
class Card extends Base { show() { return label + size + list; } }
const other = 1;
function edit() { return size; }
function open() { return new Card({ other: 1 }); }
export { Base, edit, open as openCard, other };
`;

describe('a library that is one module', () => {
  const { first, late } = halvesOf(library, 'library', ['openCard']);

  it('keeps what it has besides the late names, and what that needs', () => {
    for (const kept of ['class Base', 'const size', 'function edit', 'const other']) expect(first).toContain(kept);
    expect(first).not.toMatch(/Card|label|elsewhere/);
  });

  it('gives the late names from a half of its own, with all that they alone need', () => {
    for (const moved of ['class Card', 'const label', 'function open', 'export { open as openCard }'])
      expect(late).toContain(moved);
    expect(late).toContain("import { list, tree } from 'elsewhere';");
  });

  it('has each of the things that both halves need once', () => {
    expect(late).toContain("import { $Base as Base, $size as size } from 'library'");
    expect(first).toContain('Base as $Base, size as $size');
  });

  it('cannot be parted where the late half would change a variable of the first', () => {
    const counting =
      'let count = 0; function now() { return count; } function next() { count++; } export { now, next };';
    expect(() => halvesOf(counting, 'library', ['next'])).toThrow('The late half of library assigns to count.');
  });

  it('must have the late names', () => {
    expect(() => halvesOf(library, 'library', ['shut'])).toThrow('library has no shut.');
  });
});

describe('what imports from it', () => {
  it('asks for the late names at the late half', () => {
    const apart = withLateImports('import { edit, openCard as show } from "library";\nshow();', 'library', [
      'openCard',
    ]);
    expect(apart).toBe(
      "import { edit } from 'library'; import { openCard as show } from 'library?late-half';\nshow();",
    );
  });

  it('stays as it is where it needs none of them', () => {
    const code = 'import { edit } from "library";';
    expect(withLateImports(code, 'library', ['openCard'])).toBe(code);
  });
});
