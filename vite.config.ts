import { fileURLToPath } from 'node:url';

import * as icons from '@mdi/js';
import vue from '@vitejs/plugin-vue';
import { defineConfig, type Plugin } from 'vite';
import vuetify from 'vite-plugin-vuetify';

/**
 * Makes each icon a module of its own, so that it comes with what shows it. All of them are one module as published: the
 * first page would bring along the icons of everything that is fetched late.
 */
function iconsApart(): Plugin {
  const PREFIX = 'icon:';
  const paths: Readonly<Record<string, string | undefined>> = { ...icons };
  return {
    name: 'icons-apart',
    enforce: 'post',
    resolveId: (id) => (id.startsWith(PREFIX) ? `\0${id}` : null),
    load(id) {
      if (!id.startsWith(`\0${PREFIX}`)) return null;
      const name = id.slice(PREFIX.length + 1);
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
          .map((name) => `import { ${name} } from '${PREFIX}${name.split(/\s/)[0] ?? ''}';`)
          .join(' '),
      );
      return { code: apart, map: null };
    },
  };
}

/**
 * Leaves out what every app with Vuetify gets and this one does not use: its calendar, its own texts (`src/web/vuetify.ts`
 * has none), the spinners of buttons that load, and the ripple, which all our buttons switch off.
 */
function vuetifyLighter(): Plugin {
  const LEFT_OUT: Readonly<Record<string, string>> = {
    'framework.js ./composables/date/date.js':
      "export const DateOptionsSymbol = Symbol.for('vuetify:date-options');\n" +
      "export const DateAdapterSymbol = Symbol.for('vuetify:date-adapter');\n" +
      'export const createDate = () => ({ options: {}, instance: {} });',
    'composables/locale.js ../locale/adapters/vuetify.js': 'export const createVuetifyAdapter = () => ({});',
    'composables/loader.js ../components/VProgressLinear/index.js': 'export const VProgressLinear = null;',
    'components/VBtn/VBtn.js ../VProgressCircular/index.js': 'export const VProgressCircular = null;',
    'components/VBtn/VBtn.js ../../directives/ripple/index.js': 'export default {};',
    'components/VList/VListItem.js ../../directives/ripple/index.js': 'export default {};',
  };
  const PREFIX = '\0left-out:';
  return {
    name: 'vuetify-lighter',
    enforce: 'pre',
    resolveId(asked, importer) {
      const [, path] = (importer ?? '').split('/node_modules/vuetify/lib/');
      const place = `${path ?? ''} ${asked}`;
      return place in LEFT_OUT ? PREFIX + place : null;
    },
    load: (id) => (id.startsWith(PREFIX) ? (LEFT_OUT[id.slice(PREFIX.length)] ?? null) : null),
  };
}

/** Builds the web app: `src/web/index.html` to `dist/app`, with relative addresses so that it runs in any folder of any host. */
export default defineConfig({
  root: 'src/web',
  base: './',
  publicDir: false,
  plugins: [vue(), vuetify({ autoImport: true }), iconsApart(), vuetifyLighter()],
  // Without its compiler: `src/web/i18n` puts values into texts itself.
  resolve: {
    alias: [
      { find: /^vue-i18n$/, replacement: 'vue-i18n/dist/vue-i18n.runtime.mjs' },
      // What jsPDF would fetch to print web pages; courses are printed from their own data.
      { find: /^(html2canvas|dompurify|canvg)$/, replacement: fileURLToPath(new URL('src/web/print/left-out.ts', import.meta.url)) }, // prettier-ignore
    ],
  },
  define: {
    // Nothing in the app uses these parts of Vue and vue-i18n; leaving them out makes the page lighter.
    __VUE_OPTIONS_API__: 'false',
    __VUE_PROD_DEVTOOLS__: 'false',
    __VUE_I18N_FULL_INSTALL__: 'false',
    __VUE_I18N_LEGACY_API__: 'false',
    __INTLIFY_DROP_MESSAGE_COMPILER__: 'true',
    __INTLIFY_PROD_DEVTOOLS__: 'false',
  },
  worker: { format: 'es' },
  server: { fs: { allow: ['../..'] } },
  build: {
    outDir: '../../dist/app',
    emptyOutDir: true,
    target: 'es2022',
    // The content policy forbids data: scripts, and the VM must be a file of its own to be compiled while it streams in.
    assetsInlineLimit: 0,
    // All that the page needs at once in one chunk: parted among the many late lists and dialogs that share some of it, it
    // would be 35 files more and 13 kB heavier.
    rolldownOptions: { output: { codeSplitting: { groups: [{ name: 'page', tags: ['$initial'] }] } } },
    chunkSizeWarningLimit: 700,
  },
});
