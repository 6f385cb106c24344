/** A key that orders things by the time at which they came, after all of `taken`; another tab may make one at the same time. */
export function newKey(taken: readonly { readonly key: string }[]): string {
  const now = Date.now() * 1000 + Math.floor(Math.random() * 1000);
  return String(taken.reduce((key, one) => Math.max(key, Number(one.key) + 1), now));
}
