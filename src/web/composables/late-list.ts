import { defineAsyncComponent, type Component } from 'vue';

/** The list of a menu: it comes when it is needed first, not with the page. */
export interface LateList {
  readonly List: Component;
  /** For the menu's button: once it is pointed at or has the focus, the list is on its way. */
  readonly soon: { readonly pointerenter: () => void; readonly focus: () => void };
}

export function lateList(load: () => Promise<{ default: Component }>): LateList {
  // Asked for once: WebKit leaves a menu empty whose file was asked for again while it was on its way.
  let coming: Promise<{ default: Component }> | null = null;
  const once = (): Promise<{ default: Component }> => {
    coming ??= load().catch((problem: unknown) => {
      coming = null; // without a connection the open menu asks again
      throw problem;
    });
    return coming;
  };
  const fetch = (): void => {
    once().catch(() => undefined);
  };
  return { List: defineAsyncComponent(once), soon: { pointerenter: fetch, focus: fetch } };
}
