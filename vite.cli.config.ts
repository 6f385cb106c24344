import { copyFile, mkdir, rm, writeFile } from 'node:fs/promises';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

import { firmwareAwaited, firmwareMade } from './build/firmware-awaited.ts';
import { programs } from './build/programs.ts';
import { scenes } from './build/scenes.ts';
import { words } from './build/words.ts';
import about from './package.json' with { type: 'json' };

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** Puts the VM beside the bundle that loads it. */
const vmBeside = (folder: string): Plugin => ({
  name: 'vm-beside',
  async writeBundle() {
    await firmwareMade();
    await mkdir(folder, { recursive: true });
    await copyFile(here('.cache/vm/vm.wasm'), `${folder}/vm.wasm`);
  },
});

/** Writes the page for `man parcours`, which the bundle makes of its table of commands. */
const manPageBeside = (folder: string): Plugin => ({
  name: 'man-page-beside',
  async writeBundle() {
    const maker = `${folder}/man-page.mjs`;
    const { manPage } = (await import(`${pathToFileURL(maker).href}?${Date.now()}`)) as {
      readonly manPage: (version: string) => string;
    };
    await writeFile(`${folder}/parcours.1`, manPage(about.version));
    await rm(maker);
  },
});

/**
 * Bundles what runs in Node, with all packages inside, so that it starts without compiling TypeScript:
 * the command line to dist/cli and, with `--mode bench`, the benchmarks to dist/bench.
 */
export default defineConfig(({ mode }) => {
  const bench = mode === 'bench';
  const outDir = here(bench ? 'dist/bench' : 'dist/cli');
  return {
    publicDir: false,
    plugins: [
      firmwareAwaited(),
      programs(),
      scenes(),
      words(),
      vmBeside(outDir),
      ...(bench ? [] : [manPageBeside(outDir)]),
    ],
    ssr: { noExternal: true, target: 'node' },
    build: {
      ssr: true,
      outDir,
      emptyOutDir: true,
      target: 'node20',
      minify: false, // a stack trace in a problem report stays readable
      rolldownOptions: {
        input: bench
          ? { bench: here('bench/bench.ts') }
          : {
              main: here('src/cli/main.ts'),
              worker: here('src/cli/worker.ts'),
              'check-worker': here('src/cli/check/check-worker.ts'),
              'hint-worker': here('src/cli/hint/hint-worker.ts'),
              'facts-worker': here('src/cli/check/facts-worker.ts'),
              'lab-worker': here('src/cli/lab/lab-worker.ts'),
              'man-page': here('src/cli/commands/man-page.ts'),
            },
        output: { entryFileNames: '[name].mjs', chunkFileNames: 'part-[name].mjs' },
      },
    },
  };
});
