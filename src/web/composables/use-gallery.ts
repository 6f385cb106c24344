import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

/** What the gallery of robots shows. */
export type GalleryPage = { readonly kind: 'all' } | { readonly kind: 'robot'; readonly robot: string };

/**
 * Whether the gallery is open, and where. Its pages have addresses (`#robots`, `#robots/callibot`): teachers can hand
 * them on, and the browser's back button leads back.
 */
export interface GalleryModel {
  /** `null`: closed. */
  readonly page: Readonly<ShallowRef<GalleryPage | null>>;
  open(robot?: string): void;
  close(): void;
}

const NAME = 'robots';

/** What a page's address asks for: the part behind `#`. */
export function galleryPage(hash: string): GalleryPage | null {
  const [name, robot, ...more] = hash.replace(/^#/, '').split('/');
  if (name !== NAME || more.length > 0) return null;
  return robot === undefined || robot === '' ? { kind: 'all' } : { kind: 'robot', robot };
}

export function useGallery(): GalleryModel {
  const page = shallowRef(galleryPage(location.hash));
  const follow = (): void => {
    page.value = galleryPage(location.hash);
  };
  addEventListener('popstate', follow);
  onScopeDispose(() => removeEventListener('popstate', follow));
  return {
    page,
    open(robot) {
      history.pushState({ [NAME]: depth() + 1 }, '', robot === undefined ? `#${NAME}` : `#${NAME}/${robot}`);
      follow();
    },
    close() {
      if (page.value === null) return;
      page.value = null;
      // The pages that were opened from the app leave the history; an address that was followed is only left.
      if (depth() > 0) history.go(-depth());
      else history.replaceState(null, '', location.pathname + location.search);
    },
  };
}

/** How many pages of the gallery were opened since the app itself was in sight. */
function depth(): number {
  const state = history.state as Readonly<Record<string, unknown>> | null;
  const value = state?.[NAME];
  return typeof value === 'number' ? value : 0;
}
