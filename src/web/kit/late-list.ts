import { defineAsyncComponent, type Component } from 'vue';

/** The list of a menu: it comes when it is needed first, not with the page. */
export interface LateList {
  readonly List: Component;
  /** For the menu's button: once it is pointed at or has the focus, the list is on its way. */
  readonly soon: { readonly pointerenter: () => void; readonly focus: () => void };
}

export function lateList(load: () => Promise<{ default: Component }>): LateList {
  const fetch = (): void => {
    load().catch(() => undefined); // without a connection the open menu asks again
  };
  return { List: defineAsyncComponent(load), soon: { pointerenter: fetch, focus: fetch } };
}
