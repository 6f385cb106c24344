import { readFile } from 'node:fs/promises';
import { dirname, join, normalize } from 'node:path';
import { describe, expect, it } from 'vitest';
import { root } from './progress.mjs';
import { APP_SOURCES, VM_SOURCES } from './setup.mjs';

const FIRMWARE = '.cache/vm/vm.wasm';

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
    const read = [...(await readBy('vite.config.ts'))];
    expect(read).toContain('package.json');
    expect(read).toContain('scripts/service-worker.mjs');
    expect(read.filter((path) => path !== FIRMWARE && !isIn(APP_SOURCES, path))).toEqual([]);
    expect(read).toContain(FIRMWARE);
    expect(APP_SOURCES).toEqual(expect.arrayContaining(VM_SOURCES));
  });
});

describe('the VM', () => {
  it('is known by what it is made from, before it is made: the packages of the lock file, and its own steps', async () => {
    const packages = Object.keys(JSON.parse(await readFile(join(root, 'package-lock.json'), 'utf8')).packages);
    for (const path of ['scripts/build-vm.mjs', 'scripts/build-library.mjs']) {
      expect(isIn(VM_SOURCES, path)).toBe(true);
      const text = await readFile(join(root, path), 'utf8');
      const asked = Array.from(text.matchAll(/\brequire(?:\.resolve)?\('((?:@[^/']+\/)?[^/']+)/g), ([, name]) => name);
      expect(asked.length).toBeGreaterThan(0);
      expect(asked.filter((name) => !packages.includes(`node_modules/${name}`))).toEqual([]);
      const own = Array.from(text.matchAll(/['`](?:\.\.\/)?(src\/[^'`$]+)/g), ([, file]) => file);
      expect(own.length).toBeGreaterThan(0);
      expect(own.filter((file) => !isIn(VM_SOURCES, file))).toEqual([]);
    }
  });
});
