import type { ColourState } from '#robots/robot';

import type { Moment } from './moment';

/** The topics of announcements, each with one sentence at a time. */
export type Topic =
  'touch' | 'target' | 'checkpoint' | 'block' | 'start' | 'line' | 'colour' | 'camera' | 'ahead' | 'turn' | 'rest';

/** Something worth saying, seen in a moment. */
export type News = { readonly seen: Moment } & (
  | { readonly topic: 'touch' | 'rest' }
  /** True if the robot is already driving when the announcements begin. */
  | { readonly topic: 'start'; readonly isOnWay: boolean }
  /** The number of the checkpoint. */
  | { readonly topic: 'checkpoint'; readonly number: number }
  | { readonly topic: 'target' | 'block'; readonly done: number; readonly of: number }
  /** The sensors that are on the line, from left to right. */
  | { readonly topic: 'line'; readonly names: readonly string[] }
  /** The colour that a colour sensor has come onto. */
  | { readonly topic: 'colour'; readonly side: ColourState['side']; readonly name: ColourState['name'] }
  /** The sight of a camera: a line, or ids in their order; none: it has nothing any more. */
  | { readonly topic: 'camera'; readonly isLine: boolean; readonly ids: readonly number[] }
  /** `isClear`: nothing is ahead any more; else something has come nearer. */
  | { readonly topic: 'ahead'; readonly isClear: boolean }
  /** The robot turns, or (with `degrees`) has turned. */
  | { readonly topic: 'turn'; readonly isLeft: boolean; readonly degrees: number | null }
);

/** Looks at one moment after the other, and says what is worth saying about its own topics. */
export type Watcher = (moment: Moment) => readonly News[];
