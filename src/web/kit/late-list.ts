import type { Component } from 'vue';
import { lateView } from './late-view';

/** A part that is loaded when it is first needed, such as the list of a menu. */
export interface LateList {
  readonly List: Component;
  /** Listeners for the button that shows it: they load it once the button is pointed at or has the focus. */
  readonly soon: { readonly pointerenter: () => void; readonly focus: () => void };
}

export function lateList(load: () => Promise<{ default: Component }>): LateList {
  const fetch = (): void => {
    load().catch(() => undefined); // without a connection the open menu asks again
  };
  return { List: lateView(load), soon: { pointerenter: fetch, focus: fetch } };
}
