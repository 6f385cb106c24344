import { effectScope, type ShallowRef } from 'vue';

import { useRun } from '../../run/parts';
import { useWork } from '../../work/model/parts';
import { createChecked, type Checked } from './checked';

/** The state of the open task's checks: made once for all components that show it. */
export function useChecked({ checked }: { readonly checked: ShallowRef<Checked | null> }): Checked {
  const app = { ...useRun(), ...useWork() };
  checked.value ??= effectScope(true).run(() => createChecked(app)) ?? null;
  return checked.value as Checked;
}
