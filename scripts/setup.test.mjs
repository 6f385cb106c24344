import { readFile } from 'node:fs/promises';
import { dirname, join, normalize } from 'node:path';
import { describe, expect, it } from 'vitest';
import { root } from './progress.mjs';
import { APP_SOURCES } from './setup.mjs';

/** The files that a build script reads itself or imports, and what those import, by their paths in the repository. */
async function readBy(path, seen = new Set()) {
  if (seen.has(path)) return seen;
  seen.add(path);
  const text = await readFile(join(root, path), 'utf8');
  for (const [, from] of text.matchAll(/^import [^;]* from '(\.[^']+)';/gm))
    await readBy(normalize(join(dirname(path), from)), seen);
  for (const [, file] of text.matchAll(/\bhere\(['`]([^'`$]+)/g)) seen.add(file);
  return seen;
}

const isIn = (sources, path) => sources.some((source) => path === source || path.startsWith(`${source}/`));

describe('the app', () => {
  it('is built anew when anything changes that its build reads: the version in package.json, too', async () => {
    const read = [...(await readBy('vite.config.ts')), ...(await readBy('scripts/service-worker.mjs'))];
    expect(read).toContain('package.json');
    expect(read.filter((path) => path !== 'dist/app' && !isIn(APP_SOURCES, path))).toEqual([]);
  });
});
