import { Linter } from 'eslint';
import tseslint from 'typescript-eslint';
import { describe, expect, it } from 'vitest';

import { moduleState } from './module-state.mjs';

const linter = new Linter();
const refused = (code) =>
  linter.verify(code, {
    languageOptions: { parser: tseslint.parser },
    rules: { 'no-restricted-syntax': ['error', ...moduleState] },
  }).length;

describe('the lint rule about state of modules', () => {
  it.each([
    'let count = 0;',
    'export let count = 0;',
    'const known = new Map<string, number>();',
    'export const known = new WeakMap();',
    'const known: Set<string> = new Set();',
    'const shown = shallowRef(0);',
    'const open: Overlay[] = [];',
    'const made: Partial<Record<string, number>> = {};',
  ])('refuses: %s', (code) => expect(refused(code)).toBe(1));

  it.each([
    'const nobody: ReadonlySet<string> = new Set();',
    'const none: readonly number[] = [];',
    "const ids = new Set(['a', 'b']);",
    'const LIMIT = 5;',
    'function make() { let count = 0; const known = new Map(); return () => known.get(count++); }',
    'const signOf = memo((language: string) => language.length);',
  ])('lets pass: %s', (code) => expect(refused(code)).toBe(0));
});
