import 'vuetify/styles/core';
import './styles/tokens.css';
import './styles/page.css';
import './styles/controls.css';

import { createApp } from 'vue';

import App from './App.vue';
import { openTabStorage } from './composables/keep-work';
import { i18n } from './i18n';
import { vuetify } from './vuetify';

const storage = await openTabStorage();
createApp(App, { storage }).use(vuetify).use(i18n).mount('#app');
