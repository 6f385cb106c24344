import './page/oldest/fill';

import './page/styles/base.css';
import './page/styles/tokens.css';
import './page/styles/page.css';
import './page/styles/controls.css';
import './page/styles/blocks.css';

import { createApp } from 'vue';

import App from './app/App.vue';
import { nothingKept, openedFrom, openTabStorage } from './work/model/keep-work';
import { storedSettings } from './work/settings/settings-model';
import { hostWish } from './visit/address';
import { isPhoneNow } from './layout/layout-model';
import { keepEarlyMessages } from './host/listen-to-host';
import { setLanguage } from './page/i18n';
import { controls } from './page/controls/controls';

/** When the page looks after visits without a network, in ms. Chosen: what the first run needs has come by then. */
const OFFLINE_AFTER_MS = 4000;

/**
 * No `await` of the module itself: all files that come later build upon this one, and WebKit's module loader then leaves
 * some of them unmade (a menu stays empty), and now and then never ends when the page is loaded anew.
 */
async function start(): Promise<void> {
  const wish = hostWish(location, document.documentElement.dataset);
  // The styles look at what is spoken, not at what this page speaks unless told otherwise.
  document.documentElement.dataset['dialect'] = wish.dialect ?? 'none';
  const language = wish.settings.language ?? storedSettings().language;
  const [opened] = await Promise.all([
    wish.keepsWork ? openTabStorage().then(openedFrom) : nothingKept,
    setLanguage(language),
    isNewcomer() ? fetchGreeting() : undefined,
    isPhoneNow() ? fetchPhoneParts() : undefined,
  ]);
  createApp(App, { opened, wish }).use(controls).mount('#app');
  setTimeout(() => {
    import('./offline/start').then(({ startOffline }) => startOffline(wish.keepsWork)).catch(() => undefined);
  }, OFFLINE_AFTER_MS);
}

/** Somebody is here for the first time, on the page itself. `useGreeting` decides in the end. */
const isNewcomer = (): boolean =>
  !storedSettings().welcomed && window.parent === window && location.search === '' && location.hash === '';

/** The greeting is there with the first picture of the page, instead of changing it later. */
const fetchGreeting = (): Promise<unknown> => import('./first-steps/greeting/WelcomeCard.vue').catch(() => undefined); // the page does without

/** What only a phone has is there with its first picture. */
const fetchPhoneParts = (): Promise<unknown> =>
  Promise.all([import('./app/PhoneNav.vue'), import('./board/MiniBoard.vue')]).catch(() => undefined);

keepEarlyMessages();
void start();
