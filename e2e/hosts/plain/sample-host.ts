import { execFileSync } from 'node:child_process';
import { cp, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

import { build as buildByVite } from 'vite';

import { packAll } from '../../../scripts/packages.mjs';
import { onceARun } from '../../once-a-run';

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
 */
export const plainHost = (): Promise<BuiltHost> => onceARun('plain', build);

async function build(root: string): Promise<BuiltHost> {
  const folder = join(root, 'host');
  const tarballs = Object.values(await packAll(join(root, 'tarballs'), { only: ['client', 'element'] }));
  await cp('examples/hosts/plain', folder, {
    recursive: true,
    filter: (path) => !/(^|\/)(node_modules|public|dist)$/.test(path),
  });
  await writeFile(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  const wishes = ['--offline', '--no-audit', '--no-fund', '--no-package-lock', '--no-save', '--ignore-scripts'];
  execFileSync('npm', ['install', ...wishes, ...tarballs], { cwd: folder, stdio: 'pipe' });
  execFileSync(process.execPath, ['copy-app.js'], { cwd: folder, stdio: 'pipe' });
  await buildByVite({ root: folder, configFile: join(folder, 'vite.config.js'), logLevel: 'warn' });
  await rm(join(folder, 'public'), { recursive: true }); // built in: the app is large
  return { folder, site: join(folder, 'dist') };
}
