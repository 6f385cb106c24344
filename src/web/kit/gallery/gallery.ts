/**
 * The parts that the page is made of, on a page of their own: `npm run gallery`. `?language=fr` shows them in another language. It is
 * no page of the app and comes into no build.
 */
import '../styles/base.css';
import '../styles/tokens.css';
import '../styles/page.css';
import '../styles/controls.css';
import '../styles/blocks.css';

import { createApp } from 'vue';

import { controls } from '../controls/controls';
import { LANGUAGES, setLanguage } from '../i18n';
import KitGallery from './KitGallery.vue';

const wish = new URLSearchParams(location.search).get('language');
const language = LANGUAGES.find((one) => one === wish) ?? 'de';
void setLanguage(language).then(() => createApp(KitGallery, { language }).use(controls).mount('#app'));
