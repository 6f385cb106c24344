import { execFile, execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { API_REPORT, apiReport } from './api-report.mjs';
import { bundleTypes } from './bundle-types.mjs';
import { missingInScript } from '../build/oldest.ts';
import { buildModule, packages, packAll } from './packages.mjs';
import { root } from './progress.mjs';

let folder = '';
beforeAll(async () => (folder = await mkdtemp(join(tmpdir(), 'parcours-packages-'))));
afterAll(() => rm(folder, { recursive: true, force: true }));

const pack = async (name) => Object.values(await packAll(join(folder, name), { only: ['client'] }))[0];

describe('npm run packages', () => {
  it('makes the same tarball of the same sources, with the version of the app and nothing to install besides', async () => {
    const [first, second] = [await pack('first'), await pack('second')];
    expect((await readFile(first)).equals(await readFile(second))).toBe(true);
    const list = execFileSync('tar', ['-tzf', first], { encoding: 'utf8' }).trim().split('\n').sort();
    expect(list).toEqual(['LICENSE', 'README.md', 'dist/index.d.ts', 'dist/index.js', 'package.json'].map((file) => `package/${file}`)); // prettier-ignore
    const about = JSON.parse(execFileSync('tar', ['-xzOf', first, 'package/package.json'], { encoding: 'utf8' }));
    const app = JSON.parse(await readFile(join(root, 'package.json'), 'utf8'));
    expect(about).toMatchObject({ name: 'parcours-client', version: app.version, license: 'MIT', type: 'module' });
    expect(about).not.toHaveProperty('dependencies');
    const script = execFileSync('tar', ['-xzOf', first, 'package/dist/index.js'], { encoding: 'utf8' });
    expect(script).not.toMatch(/^\s*import[\s{*'"]|valibot/m);
  });

  it('makes a tarball that npm would publish as it is', async () => {
    const tarball = await pack('published');
    const { stdout, stderr } = await promisify(execFile)('npm', ['publish', '--dry-run', '--offline', tarball]);
    expect(stdout).toMatch(/^\+ parcours-client@\d+\.\d+\.\d+$/m);
    expect(stderr).not.toContain('auto-corrected'); // npm would mend package.json
  });

  it('export what packages/API.md says (npm run api): another API is another version', async () => {
    expect(apiReport()).toBe(await readFile(API_REPORT, 'utf8'));
  });

  it.each(packages)('writes types of $folder that import nothing', ({ entry }) => {
    const types = bundleTypes(join(root, entry)).replace(/\/\*[^]*?\*\//g, '');
    expect(types).not.toMatch(/^\s*import |from ['"]|import\(|#\w+\//m);
    expect(types).toMatch(/^export \{ .*(connect|ParcoursSimulatorElement|createParcoursDevice)/m);
  });

  it.each(packages)(
    'makes of $folder what the oldest browsers run: a host’s page has nothing filled in',
    async ({ entry, folder: name }) => {
      const made = join(folder, `module-${name}`);
      await buildModule(join(root, entry), made);
      const script = await readFile(join(made, 'index.js'), 'utf8');
      expect(missingInScript(script)).toEqual([]);
      const filled =
        /\.(findLast|findLastIndex|toReversed|toSorted|toSpliced|with|throwIfAborted|roundRect)\(|hasOwn\(/;
      expect(script).not.toMatch(filled);
    },
  );
});
