import { computed, shallowRef, watch, type Ref } from 'vue';

import { isSame } from '#core/same';
import { preferredLanguage } from '../../../kit/i18n';
import { defaultSettings, settingsFromText, type Settings } from './settings';

const KEY = 'parcours.settings';

/** The settings, stored per tab; a new tab starts with the ones changed last. */
export interface SettingsModel {
  readonly current: Readonly<Ref<Settings>>;
  /** The pupil's own, without what only this visit has. */
  readonly own: Readonly<Ref<Settings>>;
  /**
   * Changes settings by the pupil's choice: it holds from now on and is stored. A value left as it was stays the host's
   * if it was the host's.
   *
   * @param own what is stored, where the pupil has chosen only a part of a value whose rest is the host's
   */
  change(part: Partial<Settings>, own?: Partial<Settings>): void;
  /** The same with the settings of work that is being opened; nothing refuses them. */
  bring(part: Partial<Settings>, own?: Partial<Settings>): void;
  /** Sets something for this visit only, as a host or an address wishes; it holds until the pupil changes it. */
  hold(part: Partial<Settings>): void;
}

/**
 * Reads the stored settings and stores every change.
 *
 * @param held settings for this visit only
 * @param refuses whether settings that the pupil wants to change have to stay as they are
 */
export function createSettings(
  held: Partial<Settings> = {},
  refuses: (names: readonly string[]) => boolean = () => false,
): SettingsModel {
  const own = shallowRef(storedSettings());
  const visit = shallowRef(held);
  const current = computed(() => ({ ...own.value, ...visit.value }));
  watch(own, (settings) => {
    const text = JSON.stringify(settings);
    for (const store of stores()) {
      try {
        store.setItem(KEY, text);
      } catch {
        // No room or no permission: the settings hold as long as the page does.
      }
    }
  });
  const changing =
    (mayBeRefused: boolean): SettingsModel['change'] =>
    (part, stored = part) => {
      const chosen = Object.entries(part).flatMap(([name, value]) =>
        isSame(value, current.value[name as keyof Settings]) ? [] : [name],
      );
      if (chosen.length === 0 || (mayBeRefused && refuses(chosen))) return;
      const isChosen = ([name]: readonly [string, unknown]): boolean => chosen.includes(name);
      const before = visit.value;
      // In this order observers never see a value that is neither the old one nor the new one.
      visit.value = { ...before, ...Object.fromEntries(Object.entries(part).filter(isChosen)) };
      own.value = { ...own.value, ...Object.fromEntries(Object.entries(stored).filter(isChosen)) };
      const rest = Object.entries(visit.value).filter(
        (entry) => !isChosen(entry) || (entry[0] in before && !isSame(entry[1], stored[entry[0] as keyof Settings])),
      );
      visit.value = Object.fromEntries(rest);
    };
  return {
    own,
    current,
    change: changing(true),
    bring: changing(false),
    hold: (part) => {
      visit.value = { ...visit.value, ...part };
    },
  };
}

/** The settings of an earlier visit; on a first one those that suit the browser's language. */
export function storedSettings(): Settings {
  return settingsFromText(stored(), defaultSettings(preferredLanguage(navigator.languages)));
}

function stored(): string | null {
  for (const store of stores()) {
    try {
      const text = store.getItem(KEY);
      if (text !== null) return text;
    } catch {
      // There may be settings that cannot be read: then the page behaves as on a first visit.
    }
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
