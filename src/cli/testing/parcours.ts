import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll } from 'vitest';
import type { Report } from '../report';

/** A folder for the files of one test file; it is removed after the tests. */
export function useFolder(): {
  readonly folder: string;
  readonly file: (name: string, text: string | Uint8Array) => string;
} {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-cli-'));
  afterAll(() => rmSync(folder, { recursive: true }));
  beforeAll(() => {
    if (!existsSync('dist/cli/main.mjs')) throw new Error('The command line is not built. Run: npm run setup');
  });
  return {
    folder,
    file(name, text) {
      const path = join(folder, name);
      writeFileSync(path, text);
      return path;
    },
  };
}

/** Runs the bundle to its end. */
export function parcours(...args: string[]): { code: number | null; out: string; err: string } {
  const { status, stdout, stderr } = spawnSync(process.execPath, ['bin/parcours.mjs', ...args], { encoding: 'utf8' });
  return { code: status, out: stdout, err: stderr };
}

/** The line printed by `--json`. */
export const lastLine = (text: string): Report & { console: string } =>
  JSON.parse(text.trimEnd().split('\n').at(-1) ?? '') as Report & { console: string };
