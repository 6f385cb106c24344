import type { SceneObject } from '../../scene';
import type { AnyObject } from '../kind';
import type { Unread } from './unread';

/** How a kind of object is read from a file. Apart from `SceneKind`: the page shows a course before it reads one. */
export interface KindReader<O extends AnyObject = SceneObject> {
  /** Its properties in a file besides those that every kind has (`commonProperties`). */
  readonly properties: readonly string[];
  /** Reads an unchecked one; what is wrong with it is noted in the reader. */
  read(given: Unread): O;
}
