import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

import type { FeaturePage } from '../../kit/features/feature-page';
import { back as theBack, type Back } from '../../kit/overlays/back';

/** A page over the whole app that is open, by its name, and the id of the one thing that it shows. */
export interface OpenPage {
  readonly name: string;
  readonly id: string | null;
}

/**
 * The page over the whole app that is open, if there is one. Each has an address (`#robots`, `#courses/slalom`, `#class`):
 * teachers can pass it on, and the browser's back button leads back. In the frame of a host pages have none: the history is the
 * host's.
 */
export interface Router {
  /** `null`: none is open. */
  readonly page: Readonly<ShallowRef<OpenPage | null>>;
  /** The id that the open page shows; `null`: none, or another page is open. A page that is about to close asks, too. */
  idOn(name: string): string | null;
  /** Opens a page, or one thing on it. */
  open(name: string, id?: string): void;
  /** Leads from a page up to another one: back, where it was opened from there. */
  up(name: string): void;
  /** Shows another thing in the same place: the back button skips the one before. */
  replace(name: string, id: string): void;
  close(): void;
}

/** The page that an address asks for by the part behind `#`; `null`: none. */
export function pageAt(hash: string, pages: readonly FeaturePage[]): OpenPage | null {
  for (const { name, read } of pages) {
    const id = read?.(hash) ?? null;
    if (id !== null) return { name, id };
  }
  const [name = '', id = '', ...more] = hash.replace(/^#/, '').split('/');
  const page = pages.find((one) => one.name === name);
  if (page === undefined || more.length > 0) return null;
  if (page.hasIds !== true && (id !== '' || page.read !== undefined)) return null;
  return { name, id: id === '' ? null : id };
}

/** Creates a router that follows and writes the browser's address. */
export function createRouter(pages: readonly FeaturePage[], back: Back = theBack): Router {
  const page = shallowRef(pageAt(location.hash, pages));
  const address = back.isFramed() ? pageOnly(page, pages) : inAddress(page, pages, back);
  return { page, idOn: (name) => (page.value?.name === name ? page.value.id : null), ...address };
}

type Ways = Pick<Router, 'open' | 'up' | 'replace' | 'close'>;
type Shown = ShallowRef<OpenPage | null>;

const hashOf = (name: string, id?: string): string => (id === undefined ? `#${name}` : `#${name}/${id}`);

const bare = (): void => history.replaceState(null, '', location.pathname + location.search);

/** Follows the address of a frame, and adds nothing to its history. */
function pageOnly(page: Shown, pages: readonly FeaturePage[]): Ways {
  const show = (hash: string): void => void (page.value = pageAt(hash, pages));
  const arrive = (): void => show(location.hash);
  addEventListener('popstate', arrive);
  onScopeDispose(() => removeEventListener('popstate', arrive));
  const open = (name: string, id?: string): void => show(hashOf(name, id));
  function close(): void {
    page.value = null;
    if (pageAt(location.hash, pages) !== null) bare();
  }
  return { open, up: open, replace: open, close };
}

function inAddress(page: Shown, pages: readonly FeaturePage[], back: Back): Ways {
  const began = page.value === null ? null : location.hash;
  /** True while `close` goes back in the history: a page that the visit began with is then not wanted either. */
  let isLeaving = false;
  const follow = (): void => {
    isLeaving = false;
    page.value = pageAt(location.hash, pages);
  };
  const arrive = (): void => {
    if (isLeaving && location.hash === began && page.value === null) bare();
    follow();
  };
  addEventListener('popstate', arrive);
  onScopeDispose(() => removeEventListener('popstate', arrive));
  return {
    open: (name, id) =>
      back.whenStill(() => {
        const from = page.value?.name;
        back.push(
          { [BEFORE]: stepsBefore() ?? back.steps, ...(from !== undefined && { [FROM]: from }) },
          hashOf(name, id),
        );
        follow();
      }),
    up(name) {
      if (stateOf(FROM) === name) {
        history.back();
        return;
      }
      history.replaceState(history.state, '', hashOf(name));
      follow();
    },
    replace(name, id) {
      history.replaceState(history.state, '', hashOf(name, id));
      follow();
    },
    close() {
      if (page.value === null) return;
      page.value = null;
      // The pages that were opened from the app leave the history; an address that was followed is only left.
      const before = stepsBefore();
      isLeaving = before !== null && before < back.steps;
      if (isLeaving) back.leave(back.steps - (before ?? 0));
      else bare();
    },
  };
}

/** Key under which an entry of the history keeps the number of entries before the first page. */
const BEFORE = 'beforePages';
/** Key of the name of the page from which one was opened. */
const FROM = 'openedFrom';

/** Number of entries that the app itself had made in the history when it was last in sight; `null`: no page was opened since. */
function stepsBefore(): number | null {
  const value = stateOf(BEFORE);
  return typeof value === 'number' ? value : null;
}

const stateOf = (key: string): unknown => (history.state as Readonly<Record<string, unknown>> | null)?.[key];
