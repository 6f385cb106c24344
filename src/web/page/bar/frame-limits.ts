/**
 * Says that a download or printing may have been refused. A page cannot see whether its frame allows them: in one without
 * an origin of its own it is likely not, elsewhere nothing is said.
 *
 * @returns whether it was said
 */
export function sayMayBeRefused(): boolean {
  if (self.origin !== 'null') return false;
  void say().catch(() => undefined); // a late answer does not count: the file itself arrives anyway
  return true;
}

async function say(): Promise<void> {
  const [{ showPageBar }, { barWords }] = await Promise.all([import('./page-bar'), import('./bar-words')]);
  const { close } = barWords;
  showPageBar({ kind: 'may-be-refused', text: barWords.mayBeRefused, actions: [], close });
}
