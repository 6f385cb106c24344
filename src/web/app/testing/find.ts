import { nextTick } from 'vue';

/** The element with this `data-testid`; names are for readers, this for what has a different name in each language. */
export function byId(id: string): HTMLElement {
  const found = document.querySelector<HTMLElement>(`[data-testid="${id}"]`);
  if (found === null) throw new Error(`There is no “${id}”, only ${idsShown().join(' · ')}`);
  return found;
}

/** Likewise a field or a button: with its value, its mark and whether it can be used. */
export const fieldById = (id: string): HTMLInputElement => byId(id) as HTMLInputElement;

/** True if something with this `data-testid` is on the page. */
export const isThere = (id: string): boolean => idsShown().includes(id);

/** All `data-testid`s on the page, in its order; with `prefix` only those that begin with it. */
export const idsShown = (prefix = ''): readonly string[] =>
  [...document.querySelectorAll<HTMLElement>('[data-testid]')]
    .map((element) => element.dataset['testid'] ?? '')
    .filter((id) => id.startsWith(prefix));

/** Clicks it and waits until the page shows what came of it. */
export async function tap(what: HTMLElement | string): Promise<void> {
  (typeof what === 'string' ? byId(what) : what).click();
  await nextTick();
  await nextTick();
}

/** Writes into a field, as somebody typing does, and waits until the page has taken it. */
export async function write(field: HTMLElement, text: string): Promise<void> {
  (field as HTMLInputElement).value = text;
  field.dispatchEvent(new Event('input', { bubbles: true }));
  await nextTick();
}

/** Presses a key where the keyboard is (or on `target`), and says whether the page kept it from the browser. */
export async function pressKey(key: string, target: Element | null = document.activeElement): Promise<boolean> {
  const event = new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true });
  target?.dispatchEvent(event);
  await nextTick();
  await nextTick();
  return event.defaultPrevented;
}
