import { fileURLToPath } from 'node:url';

import type { Plugin, Rolldown } from 'vite';

import { licencesOf } from '../scripts/licences.mjs';
import { bareServiceWorker } from '../scripts/service-worker.mjs';

/** Before the name of an icon's own module. */
export const ICON = 'icon:';

/** The modules with code in the bundles of this build: the page's, its workers' and the service worker's. */
export const bundled = new Set<string>();

/** Notes the modules of a bundle. */
export const collectModules = (): Plugin => ({
  name: 'collect-modules',
  apply: 'build',
  generateBundle(_, bundle) {
    for (const part of Object.values(bundle)) if (part.type === 'chunk') addModules(part);
  },
});

function addModules({ modules }: Rolldown.OutputChunk): void {
  for (const [id, { renderedLength }] of Object.entries(modules))
    if (renderedLength > 0)
      bundled.add(id.startsWith(`\0${ICON}`) ? fileURLToPath(import.meta.resolve('@mdi/js')) : id);
}

/** Writes the licences of everything in the app beside it: whoever passes it on passes them on, too. */
export const licences = (): Plugin => ({
  name: 'licences',
  apply: 'build',
  async generateBundle() {
    addModules(await bareServiceWorker());
    this.emitFile({ type: 'asset', fileName: 'LICENSES.txt', source: await licencesOf(bundled) });
  },
});
