import { shallowRef, type Ref } from 'vue';

/** The best result of each ready course, by its id: 1 to 3 stars. */
export type Stars = Readonly<Record<string, number>>;

/** Stars that were won in this browser. They stay when the program is changed or the page is closed. */
export interface KeptStars {
  readonly all: Readonly<Ref<Stars>>;
  /** Stores a result if it is better than those before. @param stars 1 to 3 */
  keep(id: string, stars: number): void;
}

const KEY = 'parcours.stars';

/** Loads the stars. @param store storage for them; `null`: they last as long as the page is open */
export function createKeptStars(store: Storage | null): KeptStars {
  const all = shallowRef(read(store));
  // What another tab has won shows here, too.
  if (store !== null)
    window.addEventListener('storage', ({ key }) => {
      if (key === KEY) all.value = read(store);
    });
  return {
    all,
    keep(id, stars) {
      const kept = { ...all.value, ...read(store) };
      if (stars <= (kept[id] ?? 0)) return;
      all.value = { ...kept, [id]: stars };
      try {
        store?.setItem(KEY, JSON.stringify(all.value));
      } catch {
        // No room or no permission: they hold as long as the page does.
      }
    },
  };
}

/** The stored stars; unreadable ones count as none. */
function read(store: Storage | null): Stars {
  try {
    const stored: unknown = JSON.parse(store?.getItem(KEY) ?? '{}');
    if (typeof stored !== 'object' || stored === null) return {};
    return Object.fromEntries(Object.entries(stored).filter(([, stars]) => isStars(stars)));
  } catch {
    return {};
  }
}

const isStars = (value: unknown): boolean => value === 1 || value === 2 || value === 3;
