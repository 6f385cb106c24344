import { nextTick, onScopeDispose, shallowRef, type ShallowRef } from 'vue';

import { sayMayBeRefused } from '../../kit/bar/frame-limits';

/** Printing of more than is in sight. */
export interface Printing {
  /** True while it is drawn for the paper. */
  readonly isOn: Readonly<ShallowRef<boolean>>;
  readonly start: () => Promise<void>;
}

/** Draws something for the paper, prints it, and goes back. Called in a set-up. */
export function usePrinting(): Printing {
  const isOn = shallowRef(false);
  const end = (): void => void (isOn.value = false);
  addEventListener('afterprint', end);
  onScopeDispose(() => removeEventListener('afterprint', end));
  return {
    isOn,
    async start() {
      isOn.value = true;
      await nextTick();
      window.print();
      if (sayMayBeRefused()) end();
    },
  };
}
