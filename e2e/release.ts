import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';

import { serve } from '../scripts/serve.mjs';
import { buildServiceWorker } from '../scripts/service-worker.mjs';
import { expect, type App } from './app';
import { onceARun } from './once-a-run';
import { consoleIn, on, pasteProgram } from './page';
import { until } from './parts';

/** A host of the app of our own: it can be cut off, and can bring out new versions. */
export interface Host {
  readonly url: string;
  readonly folder: string;
  /** The files that its service worker keeps; `undefined`: all. */
  readonly files: readonly string[] | undefined;
  /** As if the network were gone. */
  cut(): Promise<void>;
  restore(): Promise<void>;
  close(): Promise<void>;
}

/**
 * Serves a copy of the built app in a folder below the top, as hosts do.
 *
 * @param files what its service worker keeps, by the addresses below the page; without it all, as of a built app
 */
export async function openHost(files?: readonly string[]): Promise<Host> {
  const root = await mkdtemp(join(tmpdir(), 'parcours-host-'));
  const folder = join(root, 'tools', 'sim');
  await cp('dist/app', folder, { recursive: true });
  if (files !== undefined) await buildServiceWorker(folder, (url) => files.includes(url));
  await fetchWithoutRest(folder);
  let server = await serve({ folder: root, port: 0 });
  const port = Number(new URL(server.url).port);
  return {
    url: `${server.url}tools/sim/`,
    folder,
    files,
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

/** Marks the files of the bar that asks for the new version: they come with its first message. */
const BAR = 'page-bar';

/** Time without a request after which the page has asked for all that it wants, in ms. */
const QUIET_MS = 1000;

/**
 * The files that an engine asks for in two visits with a run and the gallery of robots: a fifth of all. To keep all of them takes
 * several seconds, and an update is the same with a few.
 */
export const filesOfVisit = (app: App): Promise<readonly string[]> =>
  onceARun(`visit-${app.engine}`, async () => {
    const asked = new Set<string>();
    const note = ({ url = '/' }: { readonly url?: string | undefined }): boolean => {
      asked.add(new URL(url, 'http://host').pathname.slice(1) || 'index.html');
      return url.includes('/sw.js');
    };
    const server = await serve({ port: 0, lacks: note });
    try {
      await app.goto(server.url);
      await until(app, on('editor'));
      await pasteProgram(app, 'print("visited")');
      await app.click(on('run'));
      await expect.poll(() => consoleIn(app)).toContain('visited');
      await app.reload(); // whoever comes back has work that is opened
      await until(app, on('editor'));
      await app.goto(`${server.url}#robots`);
      await until(app, '.gallery li');
      let before: number;
      do {
        before = asked.size;
        await sleep(QUIET_MS);
      } while (asked.size > before);
    } finally {
      await server.close();
    }
    for (const name of await readdir('dist/app/assets'))
      if ((await readFile(join('dist/app/assets', name), 'utf8')).includes(BAR)) asked.add(`assets/${name}`);
    return [...asked];
  });

/** Names have six characters of their hash (styles), seven (late scripts) or eight. */
const HASHED = /^(.*-)([\w-]{8}|[\w-]{7}|[\w-]{6})(\.\w+)$/;
const TEXT = /\.(js|css|html|webmanifest)$/;

/**
 * Brings out another version: every file has another name, as after a change of what all of them use, and the page's title
 * says the version. The files of before are gone, but for those that its service worker does not keep.
 */
export async function release({ folder, files }: Host, version: string): Promise<void> {
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
      const [from, to] = [join(place, name), join(place, names.get(name) ?? name)];
      if (TEXT.test(name) && !name.endsWith('.single.html')) {
        const text = renamed(await readFile(from, 'utf8'));
        await writeFile(to, text.replace(/<title>[^<]*/, `<title>Parcours ${version}`));
      } else if (to !== from) await cp(from, to);
      if (to !== from && (files?.includes(`assets/${name}`) ?? true)) await rm(from);
    }
  }
  const kept = files?.map(renamed);
  await buildServiceWorker(folder, (url) => kept?.includes(url) ?? true);
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
