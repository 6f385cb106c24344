const FOCUSABLE = 'a[href], button, input, select, textarea, summary, [tabindex], [contenteditable="true"]';

/** Gives the keyboard to what has just come, unless somebody already writes somewhere: nothing takes it from them. */
export function focusNews(element: HTMLElement | null): void {
  const isWriting = document.activeElement?.closest('input, textarea, [contenteditable="true"]') ?? null;
  if (isWriting === null) element?.focus({ preventScroll: true });
}

/** True if an element is visible; browsers of before 2024 cannot say, and count it as visible. */
export const isShown = (element: Partial<Pick<Element, 'checkVisibility'>>): boolean =>
  element.checkVisibility?.() ?? true;

/** True for a radio button that the Tab key passes over: another one of its group is chosen. */
function isPassedOver(element: HTMLElement, all: readonly HTMLElement[]): boolean {
  if (!(element instanceof HTMLInputElement) || element.type !== 'radio' || element.checked) return false;
  return all.some(
    (other) =>
      other instanceof HTMLInputElement && other.type === 'radio' && other.checked && other.name === element.name,
  );
}

/** The tab stops inside an element, in order. */
export function tabStops(inside: HTMLElement): readonly HTMLElement[] {
  const all = [...inside.querySelectorAll<HTMLElement>(FOCUSABLE)].filter(
    (element) => element.tabIndex >= 0 && !element.matches(':disabled') && isShown(element),
  );
  return all.filter((element) => !isPassedOver(element, all));
}

/** The entries of the lists in an element that can be chosen. */
export const entriesIn = (inside: HTMLElement): readonly HTMLElement[] => [
  ...inside.querySelectorAll<HTMLElement>('.page-list-item[tabindex]'),
];

/** Gives the keyboard to the first or the last entry of what has just been opened. @returns whether there was any */
export function focusEntry(inside: HTMLElement, end: 'first' | 'last'): boolean {
  const entries = entriesIn(inside);
  const stops = entries.length > 0 ? entries : tabStops(inside);
  stops.at(end === 'first' ? 0 : -1)?.focus();
  return stops.length > 0;
}

/** True if the Tab key would lead out of the place that has these stops: none of them follows, or, backwards, precedes. */
export function isLastStop(stops: readonly HTMLElement[], from: Element | null, isBack: boolean): boolean {
  const side = isBack ? Node.DOCUMENT_POSITION_PRECEDING : Node.DOCUMENT_POSITION_FOLLOWING;
  return from === null || !stops.some((stop) => (from.compareDocumentPosition(stop) & side) !== 0);
}

/** Gives the keyboard to the heading of what has just been opened, where reading begins. @returns whether there is one */
export function focusHeading(inside: Element): boolean {
  const heading = inside.querySelector<HTMLElement>('h1, h2');
  if (heading === null) return false;
  heading.tabIndex = -1;
  heading.focus({ preventScroll: true });
  return true;
}

/** Gives the keyboard to a part of the page: to itself, or else to its heading, its first stop, or to where it begins. */
export function focusPart(part: HTMLElement): void {
  if (part.tabIndex < 0 && focusHeading(part)) return;
  const target = part.tabIndex < 0 ? (tabStops(part)[0] ?? part) : part;
  if (target === part && part.tabIndex < 0) part.tabIndex = -1;
  target.focus({ preventScroll: true });
}
