import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { licencesOf } from './licences.mjs';
import { root } from './progress.mjs';

const at = (path) => join(root, path);
const titles = (text) => text.split(`${'-'.repeat(80)}\n\n`).map((section) => section.split('\n')[0]);

describe('licencesOf', () => {
  it('names our own licence first, then each package with code in the bundle, and no other', async () => {
    const text = await licencesOf([
      at('node_modules/vue/dist/vue.runtime.esm-bundler.js'),
      at('node_modules/@lezer/common/dist/index.js?commonjs-exports'),
      at('node_modules/vue/dist/vue.esm-bundler.js'),
      '\0vite/preload-helper.js',
      at('src/core/languages.ts'),
    ]);
    expect(titles(text)).toEqual([
      expect.stringMatching(/^Parcours \d/),
      expect.stringMatching(/^@lezer\/common \d/),
      expect.stringMatching(/^vue \d/),
    ]);
    expect(text).not.toContain('undefined');
  });

  it('names a package within another package by itself', async () => {
    await expect(licencesOf([at('node_modules/vue/node_modules/nothing/index.js')])).rejects.toThrow(/nothing/);
  });

  it('takes over the notice in a comment of our own file, with the terms that it names', async () => {
    const text = await licencesOf([at('src/board/display/font.ts')]);
    expect(text).toContain(
      "codal-core (the display's letters)\n\nMIT. Copyright (c) 2017 Lancaster University.\n\nPermission is hereby granted",
    );
  });

  it('writes a notice that several files have only once, without the signs of comments', async () => {
    const text = await licencesOf([at('src/core/exact-math.ts'), at('.cache/vm/vm.wasm?url')]);
    expect(text.match(/Sun Microsystems, Inc\. All rights reserved\. Developed\nat SunPro/g)).toHaveLength(1);
  });

  it('names what the VM and its library are made of', async () => {
    const text = await licencesOf([at('.cache/vm/vm.wasm?url'), at('.cache/vm/library.json')]);
    expect(titles(text).slice(1)).toEqual([
      'Emscripten (compiled into the VM)',
      'MicroPython (compiled into the VM)',
      'fdlibm (mathematical functions)',
      'micropython-microbit-v2 (pictures, melodies, pitches)',
      'musl (C library, compiled into the VM)',
      're1.5 (regular expressions, part of MicroPython)',
      'uzlib (compressed data, part of MicroPython)',
    ]);
    expect(text).toContain('POSSIBILITY OF SUCH DAMAGE.');
    expect(text).toContain('This notice may not be removed or altered from any source distribution.');
  });
});

it('no file of ours names a copyright without a notice for LICENSES.txt', () => {
  const files = readdirSync(at('src'), { recursive: true, withFileTypes: true })
    .filter((it) => it.isFile() && /\.(ts|vue|mjs|py)$/.test(it.name) && !it.name.includes('.test.'))
    .map((it) => join(it.parentPath, it.name));
  const bare = files.filter((file) => {
    const text = readFileSync(file, 'utf8');
    return /copyright \(c\)|\(MIT\b/i.test(text) && !text.includes('@license');
  });
  expect(bare).toEqual([]);
});
