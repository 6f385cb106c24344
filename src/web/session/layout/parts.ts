import type { ArenaAlone } from './arena-alone';
import type { GalleryModel } from './gallery-model';
import type { LayoutModel } from './layout-model';
import { part } from '../../kit/part';

/** What is in sight: the panes, the arena alone, or a gallery over them. */
export interface LayoutParts {
  readonly layout: LayoutModel;
  readonly alone: ArenaAlone;
  readonly gallery: GalleryModel;
}

export const [provideLayout, useLayout] = part<LayoutParts>('layout');
