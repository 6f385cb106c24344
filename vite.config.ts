import { readdirSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import * as icons from '@mdi/js';
import vue from '@vitejs/plugin-vue';
import { build, defineConfig, type Plugin, type PluginOption, type UserConfig } from 'vite';

import { breakPoints } from './build/break-points.ts';
import { bundled, collectModules, ICON, licences } from './build/bundled.ts';
import {
  belowWorker,
  chunkGroups,
  fetchedAhead,
  LATE_OF_LIBRARIES,
  namesOfWords,
  shortForStyles,
} from './build/chunks.ts';
import { firmwareAwaited, firmwareMade } from './build/firmware-awaited.ts';
import { handbook, handbookPictures } from './build/handbook.ts';
import { librariesApart } from './build/libraries-apart.ts';
import { olderUnits, runsInTheOldest } from './build/oldest.ts';
import { programs } from './build/programs.ts';
import { scenes } from './build/scenes.ts';
import { physicsLighter } from './build/physics-lighter.ts';
import { reachedWords } from './build/word-groups.ts';
import { words, wordsByLanguage, type WordGroups } from './build/words.ts';
import { frameCheckParts, withFrameCheck } from './scripts/frame-check.mjs';
import { licencesOf } from './scripts/licences.mjs';
import { OLDEST } from './scripts/oldest.mjs';
import { buildServiceWorker } from './scripts/service-worker.mjs';
import { singleFile } from './scripts/single-file.mjs';

/**
 * Makes each icon a module of its own, so that it comes with what shows it. All of them are one module as published: the
 * first page would bring along the icons of everything that is fetched late.
 */
function iconsApart(): Plugin {
  const paths: Readonly<Record<string, string | undefined>> = { ...icons };
  return {
    name: 'icons-apart',
    enforce: 'post',
    resolveId: (id) => (id.startsWith(ICON) ? `\0${id}` : null),
    load(id) {
      if (!id.startsWith(`\0${ICON}`)) return null;
      const name = id.slice(ICON.length + 1);
      if (paths[name] === undefined) this.error(`There is no icon ${name}.`);
      return `export const ${name} = ${JSON.stringify(paths[name])};`;
    },
    transform(code) {
      if (!code.includes('@mdi/js')) return null;
      const apart = code.replace(/import\s*\{([^}]*)\}\s*from\s*["']@mdi\/js["'];?/g, (_, names: string) =>
        names
          .split(',')
          .map((name) => name.trim())
          .filter((name) => name !== '')
          .map((name) => `import { ${name} } from '${ICON}${name.split(/\s/)[0] ?? ''}';`)
          .join(' '),
      );
      return { code: apart, map: null };
    },
  };
}

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** The pages of the app: every HTML file in `src/web`. */
const pages = (): readonly string[] => readdirSync(here('src/web')).filter((name) => name.endsWith('.html'));

/** The single file of a page. */
const singleOf = (page: string): string =>
  `${page === 'index.html' ? 'parcours' : page.replace('.html', '')}.single.html`;

/** Lets every page say where it cannot start. */
function frameCheck(): Plugin {
  return {
    name: 'frame-check',
    transformIndexHtml: {
      order: 'post',
      handler: async (html, { path }) => {
        if (!pages().includes(path.slice(1))) return html; // the gallery of the kit, which is no page of the app
        const parts = await frameCheckParts();
        const own = parts.html.replaceAll('parcours.single.html', singleOf(path.replace(/^.*\//, '')));
        return withFrameCheck(html, { ...parts, html: own });
      },
    },
  };
}

const ICONS = { 'icon-192.png': '192x192', 'icon-512.png': '512x512', 'icon-maskable-512.png': '512x512' };

/** The files that make the app installable. Its names stay the same from version to version. */
function installable(): Plugin {
  const manifest = {
    name: 'Parcours',
    short_name: 'Parcours',
    id: './',
    start_url: './',
    scope: './',
    display: 'standalone',
    background_color: '#eceef1',
    theme_color: '#ffffff',
    icons: [
      { src: 'logo.svg', sizes: 'any', type: 'image/svg+xml' },
      ...Object.entries(ICONS).map(([name, sizes]) => ({
        src: name,
        sizes,
        type: 'image/png',
        purpose: name.includes('maskable') ? 'maskable' : 'any',
      })),
    ],
  };
  return {
    name: 'installable',
    apply: 'build',
    async generateBundle() {
      const emit = (fileName: string, source: string | Uint8Array): void => {
        this.emitFile({ type: 'asset', fileName, source });
      };
      emit('manifest.webmanifest', JSON.stringify(manifest));
      emit('logo.svg', await readFile(here('src/web/logo.svg')));
      for (const name of Object.keys(ICONS)) emit(name, await readFile(here(`src/web/exchange/offline/icons/${name}`)));
    },
    transformIndexHtml: {
      order: 'post',
      handler: (_, { path }) => [
        ...(path === '/index.html'
          ? [{ tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' }, injectTo: 'head' as const }]
          : []),
      ],
    },
  };
}

/** Writes the service worker, which lists all files of the app, once they are there. */
function offline(): Plugin {
  return {
    name: 'offline',
    apply: 'build',
    async writeBundle({ dir }) {
      if (dir !== undefined) await buildServiceWorker(dir);
    },
  };
}

/**
 * Fields of classes are plain assignments in the browsers that have none. Defining them, as the standard says, takes a helper
 * that is called for each field of each object. It only makes a difference where a class has a setter of that name above it: none has.
 */
const fieldsAssigned = { assumptions: { setPublicClassFields: true } } as const;

/** The configuration that both builds of the web app share: the folder of files, and the single file (`--mode single`). */
const common = {
  root: 'src/web',
  base: './',
  publicDir: false,
  css: { postcss: { plugins: [breakPoints, olderUnits] } },
  resolve: {
    alias: [
      // What jsPDF would fetch to print web pages; courses are printed from their own data.
      { find: /^(html2canvas|dompurify|canvg)$/, replacement: here('src/web/teacher/print/left-out.ts') },
    ],
  },
  define: {
    __APP_VERSION__: JSON.stringify(
      (JSON.parse(readFileSync(here('package.json'), 'utf8')) as { version: string }).version,
    ),
    // Nothing in the app uses these parts of Vue; leaving them out makes the page lighter.
    __VUE_OPTIONS_API__: 'false',
    __VUE_PROD_DEVTOOLS__: 'false',
  },
} satisfies UserConfig;

/** Leaves out the comments and the indentation of drawings, which are for those who draw. */
function drawingsLighter(): Plugin {
  return {
    name: 'drawings-lighter',
    enforce: 'pre',
    async load(id) {
      if (!id.endsWith('.svg?raw')) return null;
      const drawing = await readFile(id.slice(0, -'?raw'.length), 'utf8');
      return `export default ${JSON.stringify(drawing.replace(/<!--.*?-->/gs, '').replace(/\s*\n\s*/g, '\n'))};`;
    },
  };
}

/** The plugins of both builds, made anew for each. */
const commonPlugins = (): PluginOption[] => [
  ...[firmwareAwaited(), programs(), scenes(), handbook(), vue(), iconsApart(), drawingsLighter()],
  physicsLighter(),
  runsInTheOldest(),
];

/** Reading a property does nothing else, in none of the libraries: what is read and not used can go. */
const treeshake = { propertyReadSideEffects: false } as const;

/** Whether a folder's words name a robot's options on the page: to a worker they are values. */
const isUntoldByWorkers = (folder: string): boolean =>
  ['src/robots/', 'src/attachments/'].some((place) =>
    folder.replaceAll('\\', '/').startsWith(here(place).replaceAll('\\', '/')),
  );

/** The plugins of the worker in both builds, made anew for each. */
const workerPlugins = (): PluginOption[] => [
  ...[programs(), words(isUntoldByWorkers), physicsLighter(), runsInTheOldest(), collectModules()],
];

/** The worker as one classic script. */
async function workerCode(): Promise<string> {
  const made = await build({
    configFile: false,
    root: common.root,
    logLevel: 'warn',
    resolve: common.resolve,
    plugins: workerPlugins(),
    build: {
      write: false,
      target: OLDEST,
      lib: { entry: here('src/web/session/run/worker/worker.ts'), formats: ['iife'], name: 'parcoursWorker' },
      rolldownOptions: { transform: fieldsAssigned, treeshake, output: { codeSplitting: false } },
    },
  });
  const [first] = Array.isArray(made) ? made : [made];
  if (first === undefined || !('output' in first)) throw new Error('The worker was not built.');
  return first.output[0].code;
}

/** Gives the parts that lie in files beside the page, as texts inside it. */
function partsInside(): Plugin {
  return {
    name: 'parts-inside',
    enforce: 'pre',
    resolveId: (id) => (/^single:(worker|firmware)$/.test(id) ? `\0${id}` : null),
    async load(id) {
      if (id === '\0single:worker') return `export default ${JSON.stringify(await workerCode())};`;
      if (id !== '\0single:firmware') return null;
      const firmware = here('.cache/vm/vm.wasm');
      bundled.add(firmware);
      await firmwareMade();
      const packed = gzipSync(await readFile(firmware), { level: 9 });
      return `export default ${JSON.stringify(packed.toString('base64'))};`;
    },
  };
}

/** Makes one file of each page: script and styles inside. */
function onePage(): Plugin {
  return {
    name: 'one-page',
    enforce: 'post',
    async generateBundle(_, bundle) {
      const read = (path: string): Promise<string> => readFile(here(path), 'utf8');
      let [script, css] = ['', ''];
      for (const [name, part] of Object.entries(bundle)) {
        if (part.type === 'chunk') script += part.code;
        else if (name.endsWith('.css')) css += part.source.toString();
        else this.error(`${name} would lie beside the single file.`);
        Reflect.deleteProperty(bundle, name);
      }
      const [icon, licences, check] = await Promise.all([
        read('src/web/logo.svg'),
        licencesOf(bundled),
        frameCheckParts(),
      ]);
      for (const page of pages()) {
        const source = singleFile(await read(`src/web/${page}`), { script, css, icon, licences, check });
        this.emitFile({ type: 'asset', fileName: singleOf(page), source });
      }
    },
  };
}

/** The sources of the page before anything is pressed; their words come together. */
const FIRST_SOURCES = [
  ...[
    'main.ts',
    'pupil/code/CodeEditor.vue',
    'pupil/board/drawing/MicrobitView.vue',
    'pupil/next-step/NextStepBar.vue',
  ],
  'help/greeting/WelcomeCard.vue',
  'app/SkipLinks.vue',
];

/** The files of other words, by whose they are. */
const LATE_WORDS: readonly (readonly [RegExp, string])[] = [
  [/\/src\/web\/(course\/editor\/|kit\/words\/tools$)/, 'editor'],
  [/\/src\/(web\/(teacher|pupil\/(several-devices|real-device|device-log|my-robot))|check)\//, 'teacher'],
  [/\/src\/advice\//, 'errors'],
  [/\/words\/reference$|\/src\/libraries\//, 'reference'],
  [/./, 'late'],
];

/** Which words share a file, of which there is one for each language. */
function wordFiles(): WordGroups {
  const { first, late } = reachedWords(
    FIRST_SOURCES.map((path) => here(`src/web/${path}`)),
    here('src'),
  );
  const groups: Record<string, string[]> = { first: [...first] };
  for (const folder of late) {
    const [, group = ''] = LATE_WORDS.find(([place]) => place.test(folder)) ?? [];
    (groups[group] ??= []).push(folder);
  }
  return groups;
}

/** The web app: the pages of `src/web` to `dist/app`, with relative addresses so that it runs in any folder of any host. */
const folder: UserConfig = {
  ...common,
  worker: {
    format: 'es',
    plugins: () => [firmwareAwaited(), ...workerPlugins()],
    rolldownOptions: { transform: fieldsAssigned, treeshake, output: { codeSplitting: { groups: [belowWorker] } } },
  },
  server: { fs: { allow: ['../..'] } },
  build: {
    outDir: '../../dist/app',
    emptyOutDir: false, // scripts/setup.mjs does, before both builds begin
    target: OLDEST,
    // The content policy forbids data: scripts, and the VM must be a file of its own to be compiled while it streams in.
    assetsInlineLimit: 0,
    // The polyfill would only make old Safaris ask a moment earlier.
    modulePreload: { resolveDependencies: fetchedAhead, polyfill: false },
    rolldownOptions: {
      transform: fieldsAssigned,
      input: pages().map((page) => here(`src/web/${page}`)),
      treeshake,
      output: { codeSplitting: { groups: chunkGroups }, assetFileNames: shortForStyles, chunkFileNames: namesOfWords },
    },
    chunkSizeWarningLimit: 700,
  },
};

/**
 * The same app once more, every page as one HTML file with everything inside, for frames with `sandbox="allow-scripts"`
 * (decision 0018). They lie beside the ordinary pages.
 */
const single: UserConfig = {
  ...common,
  plugins: [partsInside(), words(), ...commonPlugins(), collectModules(), onePage()],
  resolve: {
    alias: [
      ...common.resolve.alias,
      { find: /^.*\/worker\/create-worker$/, replacement: here('src/web/session/run/worker/create-worker.single.ts') },
      { find: /^.*\/worker\/firmware$/, replacement: here('src/web/session/run/worker/firmware.single.ts') },
    ],
  },
  build: {
    outDir: '../../dist/app',
    emptyOutDir: false,
    target: OLDEST,
    assetsInlineLimit: 1e9,
    cssCodeSplit: false,
    modulePreload: false,
    rolldownOptions: {
      transform: fieldsAssigned,
      input: here('src/web/main.ts'),
      output: { format: 'iife', codeSplitting: false },
      checks: { emptyImportMeta: false }, // of Vite's loader of late parts, which has nothing to do here
    },
    chunkSizeWarningLimit: 10_000,
  },
};

/** The server of `npm run gallery` gives all languages at once: it knows no files of words, and nothing waits for them. */
const wordsFor = (command: 'build' | 'serve'): Plugin => (command === 'serve' ? words() : wordsByLanguage(wordFiles));

/** Builds the web app; with `--mode single`, as single files. */
export default defineConfig(({ mode, command }) =>
  mode === 'single'
    ? single
    : {
        ...folder,
        plugins: [
          wordsFor(command),
          librariesApart(LATE_OF_LIBRARIES),
          ...commonPlugins(),
          frameCheck(),
          installable(),
          handbookPictures(),
          collectModules(),
          licences(),
          offline(),
        ],
      },
);
