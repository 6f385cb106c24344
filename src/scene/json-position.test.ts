import { describe, expect, it } from 'vitest';
import { findJsonError } from './json-position';

describe('the place of a mistake in JSON', () => {
  const table: readonly [text: string, line: number, column: number][] = [
    ['[1,]', 1, 4],
    ['{"a" 1}', 1, 6],
    ['{"a":1,}', 1, 8],
    ['{"a":01}', 1, 6],
    ['["\u0007"]', 1, 2],
    ['[1]\n\n]', 3, 1],
    ['{"a":\n  tru}', 2, 3],
    ["['a']", 1, 2],
  ];
  it.each(table)('is found in %j', (text, line, column) => {
    expect(() => void JSON.parse(text)).toThrow();
    expect(findJsonError(text)).toEqual({ line, column });
  });

  it('is nowhere in what JSON.parse accepts', () => {
    for (const text of ['{}', ' [1.5e-3, "a\\u00e9", true, {"a": {"b": []}}] ', '-0', 'null']) {
      expect(() => void JSON.parse(text)).not.toThrow();
      expect(findJsonError(text)).toBeNull();
    }
  });
});
