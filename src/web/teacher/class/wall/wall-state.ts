import { shallowRef } from 'vue';

import { lateModel } from '../../../kit/state/late-models';
import { Lots, type Naming, type WallOrder } from './wall-cards';

/** The views of the wall: a card for each hand-in, or all paths in one picture. */
export const wallViews = ['cards', 'ways'] as const;

/** The chosen look of the wall. It stays when the wall is closed and opened again. */
export class WallState {
  readonly shows = shallowRef<(typeof wallViews)[number]>('cards');
  readonly naming = shallowRef<Naming>('passed');
  readonly order = shallowRef<WallOrder>('came');
  readonly lots = new Lots();
}

/** The wall of the class. */
export const wallOf = lateModel(() => new WallState());
