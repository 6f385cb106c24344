import { enableAutoUnmount, mount, type VueWrapper } from '@vue/test-utils';
import { afterEach, beforeAll, beforeEach, vi } from 'vitest';
import { defineComponent, h, type Component } from 'vue';

import { loadTexts, showLanguage } from '../../kit/i18n';
import { controls } from '../../kit/controls/controls';
import { provideSession } from '../../session/models/create-session';
import type { TestPage } from './page';

/*
 * Whoever imports this file gets the German page before its tests, an empty document with a place for menus and no
 * stored settings before each of them, and everything unmounted after it.
 */
beforeAll(() => {
  vi.stubGlobal('visualViewport', Object.assign(new EventTarget(), { width: 1024, height: 768 })); // menus measure it
  return loadTexts('de');
});
beforeEach(() => {
  localStorage.clear();
  sessionStorage.clear(); // a tab's own settings
  showLanguage('de');
  document.body.innerHTML = '<section id="menus"></section>';
  Object.assign(document, { elementsFromPoint: () => [] }); // happy-dom has no places
  setWindow(1024, 768);
});
enableAutoUnmount(afterEach);

/**
 * Mounts a component as the page does: in the document, with the models of all rooms, the controls and the texts.
 *
 * @param props what it is given; `onX` listens to its event `x`
 * @param slots what stands inside it
 * @returns the mounted component itself; what it shows elsewhere (menus, dialogs) is found in `document`
 */
export function mountOn(
  page: TestPage,
  component: Component,
  props: Readonly<Record<string, unknown>> = {},
  slots: Readonly<Record<string, () => unknown>> = {},
): VueWrapper {
  const Page = defineComponent({
    setup() {
      provideSession(page);
      return () => h(component, props, slots);
    },
  });
  return mount(Page, { attachTo: document.body, global: { plugins: [controls] } }).findComponent(component);
}

/** Takes the page away that a mounted component is on, as leaving it does. */
export function leavePage(mounted: VueWrapper): void {
  mounted.vm.$.appContext.app.unmount();
}

/** Makes the window this large, in px: from 1280 on the page is wide, from 1001 medium, from 600 narrow, else a phone. */
export function setWindow(width: number, height = 768): void {
  type Resizable = typeof globalThis & {
    happyDOM: { setViewport(size: { readonly width: number; readonly height: number }): void };
  };
  (globalThis as Resizable).happyDOM.setViewport({ width, height });
}

/** The text of an element as a reader sees it: without the spaces of the template, a space for a new line. */
export function textOf(element: Element | null | undefined): string {
  const copy = element?.cloneNode(true) as Element | undefined;
  for (const line of copy?.querySelectorAll('br') ?? []) line.replaceWith(' ');
  return (copy?.textContent ?? '').replace(/\s+/g, ' ').trim();
}

/**
 * The control or region with this name: the label for screen readers, the text of a button, or a field's `label`.
 *
 * @throws Error when there is none, with the names that there are
 */
export function named(
  name: string,
  selector = 'button, a, input, select, textarea, [role], [aria-label]',
): HTMLElement {
  const all = [...document.querySelectorAll<HTMLElement>(selector)];
  const found = all.find((element) => nameOf(element) === name);
  if (found === undefined) throw new Error(`Nothing is called “${name}”, only ${all.map(nameOf).join(' · ')}`);
  return found;
}

function nameOf(element: HTMLElement): string {
  const label = (element as HTMLInputElement).labels?.[0];
  const by = element.getAttribute('aria-labelledby');
  const texts = (ids: string): string[] => ids.split(' ').map((id) => textOf(document.getElementById(id)));
  return by === null
    ? (element.getAttribute('aria-label') ?? (label ? textOf(label) : textOf(element)))
    : texts(by).join(' ');
}

/** The way back through the history leads to the address without a page, at once; happy-dom's leads nowhere. */
export const goBackAtOnce = (): void =>
  void vi.spyOn(history, 'go').mockImplementation(() => {
    history.replaceState(null, '', location.pathname + location.search);
    dispatchEvent(new PopStateEvent('popstate'));
  });
