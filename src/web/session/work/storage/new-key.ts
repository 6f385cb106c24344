/** A key that orders things by the time at which they came; another tab may make one at the same time. */
export function newKey(taken: readonly { readonly key: string }[]): string {
  for (;;) {
    const key = `${String(Date.now())}${String(Math.floor(Math.random() * 1000)).padStart(3, '0')}`;
    if (taken.every((one) => one.key !== key)) return key;
  }
}
