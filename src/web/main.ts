import 'vuetify/styles/core';
import './styles/tokens.css';
import './styles/page.css';
import './styles/controls.css';

import { createApp } from 'vue';

import App from './App.vue';
import { openTabStorage } from './composables/keep-work';
import { storedSettings } from './composables/use-settings';
import { i18n, setLanguage } from './i18n';
import { vuetify } from './vuetify';

/**
 * No `await` of the module itself: all files that come later build upon this one, and WebKit's module loader then leaves
 * some of them unmade (a menu stays empty), and now and then never ends when the page is loaded anew.
 */
async function start(): Promise<void> {
  const [storage] = await Promise.all([openTabStorage(), setLanguage(storedSettings().language)]);
  createApp(App, { storage }).use(vuetify).use(i18n).mount('#app');
}

void start();
