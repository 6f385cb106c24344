import { execFileSync } from 'node:child_process';
import { cp, mkdir, rm, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';

import { build } from 'vite';

import { packAll } from '../../../scripts/packages.mjs';

/** A sample host that was built. */
export interface BuiltHost {
  /** Folder of its sources and its node_modules. */
  readonly folder: string;
  /** The folder that is served. */
  readonly site: string;
}

/**
 * Builds the plain sample host as whoever copies it does: in a folder of its own, where our packages are installed from
 * their tarballs. Vite is the repository's: nothing is fetched.
 *
 * @param name of the folder: two tests at once need two
 */
export async function buildPlainHost(name: string): Promise<BuiltHost> {
  const root = resolve('.cache/hosts', name);
  const folder = join(root, 'host');
  await rm(root, { recursive: true, force: true });
  await mkdir(root, { recursive: true });
  const tarballs = Object.values(await packAll(join(root, 'tarballs'), { only: ['client', 'element'] }));
  await cp('examples/hosts/plain', folder, {
    recursive: true,
    filter: (path) => !/(^|\/)(node_modules|public|dist)$/.test(path),
  });
  await writeFile(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  const wishes = ['--offline', '--no-audit', '--no-fund', '--no-package-lock', '--no-save', '--ignore-scripts'];
  execFileSync('npm', ['install', ...wishes, ...tarballs], { cwd: folder, stdio: 'pipe' });
  execFileSync(process.execPath, ['copy-app.js'], { cwd: folder, stdio: 'pipe' });
  await build({ root: folder, configFile: join(folder, 'vite.config.js'), logLevel: 'warn' });
  await rm(join(folder, 'public'), { recursive: true }); // built in: the app is large
  return { folder, site: join(folder, 'dist') };
}
