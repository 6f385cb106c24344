import { fileURLToPath } from 'node:url';

import { build } from 'vite';

import type { connect as connectClient } from '#embed/client/connect';
import { appAddress, hostPage, type HostPage } from '../../hosts';

declare global {
  /** The client, in the host page. */
  var connect: typeof connectClient;
}

let bundled: Promise<string> | null = null;

/** The client as one script. */
async function clientScript(): Promise<string> {
  const built = await build({
    configFile: false,
    logLevel: 'warn',
    root: fileURLToPath(new URL('../../..', import.meta.url)),
    build: {
      write: false,
      target: 'es2022',
      lib: { entry: fileURLToPath(new URL('host.ts', import.meta.url)), formats: ['es'], fileName: 'host' },
    },
  });
  const [output] = Array.isArray(built) ? built : [built];
  const chunk = output !== undefined && 'output' in output ? output.output[0] : undefined;
  if (chunk?.type !== 'chunk') throw new Error('The client was not built.');
  return chunk.code.replaceAll('</script', '<\\/script');
}

/** A host page on another site that has the client and shows the app, and whatever else stands in `body`. */
export async function parcoursHost(query = '?lang=en&dialect=none', body = ''): Promise<HostPage> {
  bundled ??= clientScript();
  return hostPage(`
    <iframe id="parcours" src="${appAddress()}${query}" sandbox="allow-scripts allow-same-origin" style="width: 1100px; height: 700px; border: 0"></iframe>
    ${body}
    <script type="module">${await bundled}</script>`);
}
