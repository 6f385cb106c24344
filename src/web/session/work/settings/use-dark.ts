import { computed, onScopeDispose, shallowRef, watchEffect, type ComputedRef } from 'vue';

import { lateModel } from '../../../kit/state/late-models';
import type { SettingsModel } from './settings-model';

/** True if this page is dark; from the first question on the document is marked. */
export const isDark = lateModel(({ settings }: { readonly settings: SettingsModel }) => useDark(settings));

/** True if the page is dark: as chosen, or as the device wishes. Marks the document for the style sheets. */
export function useDark({ current }: SettingsModel): ComputedRef<boolean> {
  const query = matchMedia('(prefers-color-scheme: dark)');
  const deviceIsDark = shallowRef(query.matches);
  const follow = (): void => {
    deviceIsDark.value = query.matches;
  };
  query.addEventListener('change', follow);
  onScopeDispose(() => query.removeEventListener('change', follow));
  const dark = computed(() => (current.value.theme === 'system' ? deviceIsDark.value : current.value.theme === 'dark'));
  watchEffect(() => {
    document.documentElement.dataset['theme'] = dark.value ? 'dark' : 'light';
  });
  return dark;
}
