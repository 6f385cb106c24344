import { cp, mkdtemp, readdir, readFile, rename, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { serve } from '../scripts/serve.mjs';
import { buildServiceWorker } from '../scripts/service-worker.mjs';

/** A host of the app of our own: it can be cut off, and can bring out new versions. */
export interface Host {
  readonly url: string;
  readonly folder: string;
  /** As if the network were gone. */
  cut(): Promise<void>;
  restore(): Promise<void>;
  close(): Promise<void>;
}

/** Serves a copy of the built app in a folder below the top, as hosts do. */
export async function openHost(): Promise<Host> {
  const root = await mkdtemp(join(tmpdir(), 'parcours-host-'));
  const folder = join(root, 'tools', 'sim');
  await cp('dist/app', folder, { recursive: true });
  await fetchWithoutRest(folder);
  let server = await serve({ folder: root, port: 0 });
  const port = Number(new URL(server.url).port);
  return {
    url: `${server.url}tools/sim/`,
    folder,
    cut: () => server.close(),
    restore: async () => {
      server = await serve({ folder: root, port });
      if (Number(new URL(server.url).port) !== port) throw new Error(`Port ${port} is taken.`);
    },
    close: async () => {
      await server.close();
      await rm(root, { recursive: true });
    },
  };
}

/** Names have six characters of their hash (styles), seven (late scripts) or eight. */
const HASHED = /^(.*-)([\w-]{8}|[\w-]{7}|[\w-]{6})(\.\w+)$/;
const TEXT = /\.(js|css|html|webmanifest)$/;

/**
 * Brings out another version: every file has another name, as after a change of what all of them use, and the page's title
 * says the version.
 */
export async function release(folder: string, version: string): Promise<void> {
  const assets = join(folder, 'assets');
  const names = new Map<string, string>();
  for (const name of await readdir(assets)) {
    const [, start, hash, end] = HASHED.exec(name) ?? [];
    if (start !== undefined && hash !== undefined)
      names.set(name, `${start}${version}${hash.slice(version.length)}${end}`);
  }
  const renamed = (text: string): string => text.replace(/[\w.-]+-[\w-]{6,8}\.\w+/g, (name) => names.get(name) ?? name);
  for (const place of [folder, assets]) {
    for (const name of await readdir(place)) {
      if (!TEXT.test(name) || name.endsWith('.single.html')) continue;
      const text = renamed(await readFile(join(place, name), 'utf8'));
      await writeFile(join(place, name), text.replace(/<title>[^<]*/, `<title>Parcours ${version}`));
    }
  }
  for (const [from, to] of names) await rename(join(assets, from), join(assets, to));
  await buildServiceWorker(folder);
  await fetchWithoutRest(folder);
}

/**
 * The service worker fetches one file after the other without the rest between them (`sw.test.ts` shows that): the rests of
 * one version are 15 s, in which nothing else happens.
 */
async function fetchWithoutRest(folder: string): Promise<void> {
  const worker = join(folder, 'sw.js');
  await writeFile(worker, `self.PARCOURS_REST_MS = 0;\n${await readFile(worker, 'utf8')}`);
}
