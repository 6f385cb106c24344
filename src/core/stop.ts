/** Detaches, stops or unsubscribes what was attached, started or subscribed to. Calling it twice does no harm. */
export type Stop = () => void;

/** Adds something to a set; it can be taken away again. */
export function addedTo<T>(set: Set<T>, one: T): Stop {
  set.add(one);
  return () => void set.delete(one);
}
