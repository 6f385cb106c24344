import vue from '@vitejs/plugin-vue';
import { defineConfig } from 'vite';
import vuetify from 'vite-plugin-vuetify';

/** Builds the web app: `src/web/index.html` to `dist/app`, with relative addresses so that it runs in any folder of any host. */
export default defineConfig({
  root: 'src/web',
  base: './',
  publicDir: false,
  plugins: [vue(), vuetify({ autoImport: true })],
  // Without its compiler: `src/web/i18n` puts values into texts itself.
  resolve: { alias: [{ find: /^vue-i18n$/, replacement: 'vue-i18n/dist/vue-i18n.runtime.mjs' }] },
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
