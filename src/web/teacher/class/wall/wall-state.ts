import { shallowRef } from 'vue';

import { lateModel } from '../../../kit/state/late-models';
import { Lots, type Naming, type WallOrder } from './wall-cards';

/** The views of the wall: a card for each hand-in, all paths in one picture, or the groups of what the runs did. */
export const wallViews = ['cards', 'ways', 'groups'] as const;

/** The chosen look of the wall. It stays when the wall is closed and opened again. */
export class WallState {
  readonly shows = shallowRef<(typeof wallViews)[number]>('cards');
  readonly naming = shallowRef<Naming>('passed');
  readonly order = shallowRef<WallOrder>('came');
  /** Key of the group whose example is shown; `null`: all groups are. */
  readonly example = shallowRef<string | null>(null);
  readonly lots = new Lots();
}

/** The wall of the class. */
export const wallOf = lateModel(() => new WallState());
