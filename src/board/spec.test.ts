import { describe, expect, it } from 'vitest';
import spec from './SPEC.md?raw';

const tests = import.meta.glob<string>('./**/*.test.ts', { query: '?raw', import: 'default', eager: true });

describe('SPEC.md', () => {
  const ruleIds = [...spec.matchAll(/^\| ([A-Z]\d+) *\|/gm)].map((row) => row[1]!);
  const testedIds = new Set(
    Object.values(tests).flatMap((source) => [...source.matchAll(/\bit\('([A-Z]\d+): /g)].map((title) => title[1]!)),
  );

  it('has a test for each of its rules, whose title begins with the rule', () => {
    expect(ruleIds.length).toBeGreaterThan(50);
    expect(ruleIds.filter((id) => !testedIds.has(id))).toEqual([]);
  });

  it('has a rule for each test whose title begins with one', () => {
    expect([...testedIds].filter((id) => !ruleIds.includes(id))).toEqual([]);
  });
});
