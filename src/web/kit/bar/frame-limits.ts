/**
 * Says that a download or printing may have been refused. A page cannot see whether its frame allows them: in one without
 * an origin of its own it is likely not, elsewhere nothing is said.
 *
 * @returns whether it was said
 */
export function sayMayBeRefused(): boolean {
  if (self.origin !== 'null') return false;
  // A late answer does not count: the file itself arrives anyway.
  import('./messages').then(
    ({ sayRefusal }) => sayRefusal(),
    () => undefined,
  );
  return true;
}
