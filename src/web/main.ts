import './kit/oldest/fill';

import './kit/styles/base.css';
import './kit/styles/tokens.css';
import './kit/styles/page.css';
import './kit/styles/controls.css';
import './kit/styles/blocks.css';

import { createApp } from 'vue';

import App from './app/App.vue';
import { nothingKept, openedFrom, openTabStorage } from './session/work/model/keep-work';
import { storedSettings } from './session/work/settings/settings-model';
import { hostWish } from './session/visit/address';
import { isPhoneNow } from './session/layout/layout-model';
import { keepEarlyMessages } from './exchange/host/listen-to-host';
import { setLanguage } from './kit/i18n';
import { controls } from './kit/controls/controls';

/** Time until the page prepares visits without a network, in ms. Chosen: what the first run needs has come by then. */
const OFFLINE_AFTER_MS = 4000;

/**
 * Starts the page. No `await` of the module itself: all files that come later build upon this one, and WebKit's module
 * loader then leaves some of them unmade (a menu stays empty), and now and then never ends when the page is loaded
 * anew.
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
    import('./exchange/offline/start').then(({ startOffline }) => startOffline(wish.keepsWork)).catch(() => undefined);
  }, OFFLINE_AFTER_MS);
}

/** True if somebody is here for the first time, on the page itself. `useGreeting` decides in the end. */
const isNewcomer = (): boolean =>
  !storedSettings().welcomed && window.parent === window && location.search === '' && location.hash === '';

/** Loads the greeting, so that it is there with the first picture of the page, instead of changing it later. */
const fetchGreeting = (): Promise<unknown> => import('./help/greeting/WelcomeCard.vue').catch(() => undefined); // the page does without

/** Loads the parts of a phone, so that they are there with its first picture. */
const fetchPhoneParts = (): Promise<unknown> =>
  Promise.all([
    import('./app/PhoneNav.vue'),
    import('./pupil/board/MiniBoard.vue'),
    import('./pupil/code/ProgramPeek.vue'),
  ]).catch(() => undefined);

keepEarlyMessages();
void start();
