#!/usr/bin/env node
// The command line is a bundle that `npm run setup` makes: it starts without compiling TypeScript.
import { existsSync } from 'node:fs';

const bundle = new URL('../dist/cli/main.mjs', import.meta.url);

if (existsSync(bundle)) {
  await import(bundle.href);
} else {
  process.stderr.write('parcours: not set up yet. Run this once in the project folder: npm run setup\n');
  process.exitCode = 2;
}
