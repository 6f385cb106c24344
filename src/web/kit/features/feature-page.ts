import type { Component } from 'vue';

/**
 * A page over the whole app with an address of its own: `#class`, or `#courses/slalom` where it shows one thing of several.
 * A feature lists its pages in a `pages.ts`, which comes with the app and holds nothing else.
 */
export interface FeaturePage {
  /** Its name in the address. */
  readonly name: string;
  /** True if an id may follow: `#courses/slalom`. */
  readonly hasIds?: true;
  /** Reads other forms of its address. @returns the id; `null`: the address is not one of this page */
  readonly read?: (hash: string) => string | null;
  readonly load: () => Promise<{ readonly default: Component }>;
}
