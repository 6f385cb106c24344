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

const [storage] = await Promise.all([openTabStorage(), setLanguage(storedSettings().language)]);
createApp(App, { storage }).use(vuetify).use(i18n).mount('#app');
