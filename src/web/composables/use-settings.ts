import { shallowRef, watch, type ShallowRef } from 'vue';

import { preferredLanguage } from '../i18n';
import { defaultSettings, settingsFromText, type Settings } from '../project/settings';

const KEY = 'parcours.settings';

/** The settings, kept per tab; a new tab starts with the ones changed last. */
export interface SettingsModel {
  readonly current: Readonly<ShallowRef<Settings>>;
  change(part: Partial<Settings>): void;
}

/** Reads the stored settings and stores every change. */
export function useSettings(): SettingsModel {
  const current = shallowRef(storedSettings());
  watch(current, (settings) => {
    const text = JSON.stringify(settings);
    for (const store of stores()) {
      try {
        store.setItem(KEY, text);
      } catch {
        // No room or no permission: the settings hold as long as the page does.
      }
    }
  });
  return {
    current,
    change: (part) => {
      current.value = { ...current.value, ...part };
    },
  };
}

/** The settings of an earlier visit; on a first one those that suit the browser's language. */
export function storedSettings(): Settings {
  return settingsFromText(stored(), defaultSettings(preferredLanguage(navigator.languages)));
}

function stored(): string | null {
  for (const store of stores()) {
    const text = store.getItem(KEY);
    if (text !== null) return text;
  }
  return null;
}

/** The tab's own store and the shared one, as far as the browser allows them. */
function stores(): Storage[] {
  try {
    return [sessionStorage, localStorage];
  } catch {
    return [];
  }
}
