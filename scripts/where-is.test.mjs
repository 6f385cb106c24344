import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

const text = readFileSync('docs/architecture.md', 'utf8');
/** Each row of the table: question, path, name. */
const rows = Array.from(
  text.matchAll(/^\| +([^|]+?) +\| +\[(src\/[^\]]+)\]\(\.\.\/([^)]+)\) +\| +`(\w+)` +\|$/gm),
  ([, question = '', path = '', link = '', name = '']) => ({ question, path, link, name }),
);

describe('the list of where things are', () => {
  it('answers thirty questions, each by a file of its own', () => {
    expect(rows.length).toBe(30);
    expect(new Set(rows.map(({ path }) => path)).size).toBe(30);
  });

  it.each(rows)('$question: $path has $name', ({ path, link, name }) => {
    expect(link).toBe(path);
    expect(readFileSync(path, 'utf8')).toMatch(new RegExp(`export (const|function|class|async function) ${name}\\b`));
  });
});
