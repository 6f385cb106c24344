import { cp, readFile, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { once } from 'node:events';
import { execFileSync } from 'node:child_process';
import { extname, join } from 'node:path';

import { build as buildByVite } from 'vite';

import { packAll } from '../../../scripts/packages.mjs';
import { onceARun } from '../../once-a-run';

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
};

/**
 * Builds the sample host as whoever copies it does: in a folder of its own, where our package is installed from its
 * tarball. Vue and Vite are the repository's: nothing is fetched.
 *
 * @returns the folder to serve
 */
export const sampleHost = (): Promise<string> => onceARun('webtigerpython', build);

async function build(folder: string): Promise<string> {
  const tarballs = Object.values(await packAll(join(folder, 'tarballs'), { only: ['webtigerpython'] }));
  const host = join(folder, 'host');
  await cp('examples/hosts/webtigerpython-vue', host, { recursive: true });
  await writeFile(join(host, 'package.json'), '{ "private": true, "type": "module" }');
  const wishes = ['--offline', '--no-audit', '--no-fund', '--no-package-lock', '--no-save', '--ignore-scripts'];
  execFileSync('npm', ['install', ...wishes, ...tarballs], { cwd: host, stdio: 'pipe' });
  await buildByVite({ root: host, configFile: join(host, 'vite.config.js'), logLevel: 'warn' });
  return join(host, 'dist');
}

/** Serves a folder at 127.0.0.1, which to browsers is another site than localhost, where the app is. */
export async function serveHost(folder: string): Promise<{ readonly url: string; close(): void }> {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const path = pathname === '/' ? 'index.html' : pathname.slice(1);
    readFile(join(folder, path))
      .then((body) => response.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'text/plain' }).end(body))
      .catch(() => response.writeHead(404).end());
  }).listen(0, '127.0.0.1');
  await once(server, 'listening');
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`,
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}
