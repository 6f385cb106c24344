import type { Ref } from 'vue';

import type { Drawn } from '../../kit/features/drawn';
import type { Pane } from './layout-model';

/**
 * A pane, the row above the panes, the card beside the program, or the bench that stands in the place of panes while
 * something is built. A feature lists them in its `panes.ts`, which comes with the app: the page's first picture consists
 * of them.
 */
export type FeaturePane = Drawn & {
  readonly place: Pane | 'row' | 'card' | 'bench';
  /** It is drawn inside the pane of this place, in that pane's slot of this name. */
  readonly slot?: string;
  /** True if it keeps its state while it is hidden. */
  readonly staysMade?: true;
  /** Called in the set-up of a phone's tabs. @returns whether it shows something that has not been seen; its tab sets it to `false` */
  readonly news?: () => Ref<boolean>;
};
