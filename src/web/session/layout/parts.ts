import type { ArenaAlone } from './arena-alone';
import type { LayoutModel } from './layout-model';
import { part } from '../../kit/part';
import type { Router } from './router';

/** The visible views: the panes, the arena alone, or a page over them. */
export interface LayoutParts {
  readonly layout: LayoutModel;
  readonly alone: ArenaAlone;
  readonly router: Router;
}

export const [provideLayout, useLayout] = part<LayoutParts>('layout');
